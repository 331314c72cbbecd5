// What shows when nothing is selected: the home, the level drawn on, where and when it stands.
#include <QCheckBox>
#include <cmath>

#include "light/civil_time.h"
#include "light/sun_position.h"
#include "model/edits/level_edits.h"
#include "model/room_geometry.h"
#include "studio/properties/sections.h"
#include "studio/properties/time_field.h"
#include "studio/widgets/material_picker.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

bool nothing(const Selected& s) { return s.kind == ElementKind::None; }

template <class V>
Common<V> one(const V& value) {
  Common<V> common;
  common.add(value);
  return common;
}

class HomeSection : public Section {
 public:
  HomeSection(PanelLink& link, QWidget* parent)
      : Section(link, "homeSection", QT_TRANSLATE_NOOP("idap", "Home"), parent) {
    add({"homeName", QT_TRANSLATE_NOOP("idap", "Name"), QT_TRANSLATE_NOOP("idap", "Change name"),
         QT_TRANSLATE_NOOP("idap", "What the home is called in lists of files.")},
        &Home::name);
    add({"homeTitle", QT_TRANSLATE_NOOP("idap", "Title"), QT_TRANSLATE_NOOP("idap", "Change title"),
         QT_TRANSLATE_NOOP("idap", "Stands on prints.")},
        &Home::title);
    addTextArea(
        {"homeNotes", QT_TRANSLATE_NOOP("idap", "Notes"), QT_TRANSLATE_NOOP("idap", "Change notes"),
         QT_TRANSLATE_NOOP("idap", "Anything to remember. Control+Enter or leaving the field applies.")},
        3, [](const Selected& s) { return one(s.home.notes); },
        [](const Home& home, const Elements&, const std::string& notes) {
          Home next = home;
          next.notes = notes;
          return next;
        });
    addLength(
        {"homeWallHeight", QT_TRANSLATE_NOOP("idap", "Wall height"),
         QT_TRANSLATE_NOOP("idap", "Change wall height"),
         QT_TRANSLATE_NOOP("idap", "Of walls that are drawn from now on.")},
        [](const Selected& s) { return one(s.home.wallHeight); },
        [](const Home& home, const Elements&, double height) {
          Home next = home;
          next.wallHeight = height;
          return next;
        },
        [](const Selected&) { return std::pair(0.1, 100.0); });
    add({"homeCurrency", QT_TRANSLATE_NOOP("idap", "Currency"), QT_TRANSLATE_NOOP("idap", "Change currency"),
         QT_TRANSLATE_NOOP("idap", "Of all prices: EUR, USD, THB.")},
        &Home::currency);
    addInfo({"homePrice", QT_TRANSLATE_NOOP("idap", "Total price"), "",
             QT_TRANSLATE_NOOP("idap", "Of all furniture, doors and windows that have a price.")},
            [](const Selected& s) {
              double total = 0;
              for (const auto& [id, piece] : s.home.furniture) total += piece->price.value_or(0);
              for (const auto& [id, opening] : s.home.openings) total += opening->price.value_or(0);
              return QString::number(total, 'f', 2) + QLatin1Char(' ') + toQt(s.home.currency);
            });
    addInfo({"homeArea", QT_TRANSLATE_NOOP("idap", "Floor area"), "",
             QT_TRANSLATE_NOOP("idap", "Of all rooms on all levels.")},
            [](const Selected& s) {
              double area = 0;
              for (const auto& [id, room] : s.home.rooms) area += floorArea(*room);
              return s.home.rooms.empty() ? QString() : areaText(area, s.settings.unit);
            });
  }

 private:
  void add(const RowText& text, std::string Home::*member) {
    addText(
        text, [member](const Selected& s) { return one(s.home.*member); },
        [member](const Home& home, const Elements&, const std::string& value) {
          Home next = home;
          next.*member = value;
          return next;
        });
  }
};

class LevelSection : public Section {
 public:
  LevelSection(PanelLink& panelLink, QWidget* parent)
      : Section(panelLink, "levelSection", QT_TRANSLATE_NOOP("idap", "Level"), parent) {
    addText(
        {"levelName", QT_TRANSLATE_NOOP("idap", "Name"), QT_TRANSLATE_NOOP("idap", "Change name"), ""},
        [](const Selected& s) { return level(s, &Level::name); }, change(&Level::name));
    add({"levelElevation", QT_TRANSLATE_NOOP("idap", "Elevation"),
         QT_TRANSLATE_NOOP("idap", "Change elevation"),
         QT_TRANSLATE_NOOP("idap", "Of the top of its floor.")},
        &Level::elevation, -1000);
    add({"levelHeight", QT_TRANSLATE_NOOP("idap", "Height"), QT_TRANSLATE_NOOP("idap", "Change height"),
         QT_TRANSLATE_NOOP("idap", "From its floor to its ceiling.")},
        &Level::height, 0.1);
    add({"levelFloor", QT_TRANSLATE_NOOP("idap", "Floor thickness"),
         QT_TRANSLATE_NOOP("idap", "Change floor thickness"),
         QT_TRANSLATE_NOOP("idap", "Of the slab below it.")},
        &Level::floorThickness, 0);
    addCheck(
        {"levelVisible", QT_TRANSLATE_NOOP("idap", "Visible"), QT_TRANSLATE_NOOP("idap", "Change visibility"),
         QT_TRANSLATE_NOOP("idap", "Whether all that is on it shows in pictures.")},
        [](const Selected& s) { return level(s, &Level::visible); }, change(&Level::visible));
  }

 private:
  template <class V>
  static Common<V> level(const Selected& s, V Level::*member) {
    const Level* found = s.home.levels.find(s.level);
    return found ? one(found->*member) : Common<V>();
  }
  template <class V>
  Write<V> change(V Level::*member) {
    return [this, member](const Home& home, const Elements&, const V& value) {
      const LevelId id = link().editor().level();
      const Level* found = home.levels.find(id);
      if (!found) return home;
      Level next = *found;
      next.*member = value;
      return setLevel(home, id, next);
    };
  }
  void add(const RowText& text, double Level::*member, double least) {
    addLength(
        text, [member](const Selected& s) { return level(s, member); }, change(member),
        [least](const Selected&) { return std::pair(least, 1000.0); });
  }
};

class SiteSection : public Section {
 public:
  SiteSection(PanelLink& panelLink, QWidget* parent)
      : Section(panelLink, "siteSection", QT_TRANSLATE_NOOP("idap", "Place and time"), parent) {
    auto* time = new TimeField(body());
    const RowText timeText{"siteTime", QT_TRANSLATE_NOOP("idap", "Time"),
                           QT_TRANSLATE_NOOP("idap", "Change time"),
                           QT_TRANSLATE_NOOP("idap", "The moment of pictures: it sets the sun.")};
    addRow(timeText, time);
    connect(time, &TimeField::timeChosen, this,
            [this, timeText](qint64 utc) { apply<std::int64_t>(timeText, change(&Site::time), utc); });
    onRefresh([time](const Selected& s) { time->setTime(s.home.site.time, s.home.site.timeZone); });
    addInfo({"siteSun", QT_TRANSLATE_NOOP("idap", "Sun"), "",
             QT_TRANSLATE_NOOP("idap", "Where it stands at that time.")},
            [](const Selected& s) { return sunWords(s.home.site); });
    addDegrees(
        {"siteLatitude", QT_TRANSLATE_NOOP("idap", "Latitude"), QT_TRANSLATE_NOOP("idap", "Change place"),
         QT_TRANSLATE_NOOP("idap", "North of the equator in degrees; south is negative.")},
        &Site::latitude, 90);
    addDegrees(
        {"siteLongitude", QT_TRANSLATE_NOOP("idap", "Longitude"), QT_TRANSLATE_NOOP("idap", "Change place"),
         QT_TRANSLATE_NOOP("idap", "East of Greenwich in degrees; west is negative.")},
        &Site::longitude, 180);
    addText(
        {"siteZone", QT_TRANSLATE_NOOP("idap", "Time zone"), QT_TRANSLATE_NOOP("idap", "Change time zone"),
         QT_TRANSLATE_NOOP("idap", "By its international name: Europe/Paris, Asia/Bangkok.")},
        [](const Selected& s) { return one(s.home.site.timeZone); },
        [this](const Home& home, const Elements&, const std::string& zone) {
          if (!isTimeZone(zone)) {
            link().editor().say({QT_TRANSLATE_NOOP("idap",
                                                   "There is no time zone “%1”. Write it like "
                                                   "Europe/Paris."),
                                 {zone}},
                                Editor::Severity::Warning);
            return home;
          }
          // The clock on the wall stays.
          Home next = home;
          const std::string before = isTimeZone(home.site.timeZone) ? home.site.timeZone : "UTC";
          next.site.time = utcFromCivil(civilFromUtc(home.site.time, before), zone);
          next.site.timeZone = zone;
          return next;
        });
    addAngle(
        {"siteNorth", QT_TRANSLATE_NOOP("idap", "North"), QT_TRANSLATE_NOOP("idap", "Turn north"),
         QT_TRANSLATE_NOOP("idap", "Counter-clockwise from the top of the plan.")},
        [](const Selected& s) { return one(positiveDegrees(s.home.site.north)); },
        [](const Home& home, const Elements&, double angle) {
          Home next = home;
          next.site.north = radians(angle);
          return next;
        });
    addCheck(
        {"siteCompass", QT_TRANSLATE_NOOP("idap", "Compass on the plan"),
         QT_TRANSLATE_NOOP("idap", "Show compass"), ""},
        [](const Selected& s) { return one(s.home.site.compassVisible); }, change(&Site::compassVisible));
    addFinish(
        {"siteGround", QT_TRANSLATE_NOOP("idap", "Ground"), QT_TRANSLATE_NOOP("idap", "Change ground"),
         QT_TRANSLATE_NOOP("idap", "What the home stands on, in pictures from outside.")},
        QT_TRANSLATE_NOOP("idap", "Bare"), [](const Selected& s) { return one(s.home.environment.ground); },
        [](const Home& home, const Elements&, const Finish& finish) {
          Home next = home;
          next.environment.ground = finish;
          return next;
        });
  }

 private:
  static QString sunWords(const Site& site) {
    const SunPosition sun = sunPosition(site.latitude, site.longitude, site.time);
    if (sun.altitude < 0) return Section::tr("Below the horizon");
    const QString sides[] = {Section::tr("north"),      Section::tr("north-east"), Section::tr("east"),
                             Section::tr("south-east"), Section::tr("south"),      Section::tr("south-west"),
                             Section::tr("west"),       Section::tr("north-west")};
    const auto side = static_cast<std::size_t>(std::lround(sun.azimuth / (kPi / 4))) % 8;
    return Section::tr("%1 high in the %2").arg(angleText(sun.altitude), sides[side]);
  }
  template <class V>
  static Write<V> change(V Site::*member) {
    return [member](const Home& home, const Elements&, const V& value) {
      Home next = home;
      next.site.*member = value;
      return next;
    };
  }
  void addDegrees(const RowText& text, double Site::*member, double most) {
    addNumber(
        text, QStringLiteral("°"), 4,
        [member](const Selected& s) { return one(degrees(s.home.site.*member)); },
        [member](const Home& home, const Elements&, double value) {
          Home next = home;
          next.site.*member = radians(value);
          return next;
        },
        [most](const Selected&) { return std::pair(-most, most); });
  }
};

}  // namespace

SectionEntry homeSection() {
  return {nothing,
          [](PanelLink& link, QWidget* parent) -> Section* { return new HomeSection(link, parent); }};
}
SectionEntry levelSection() {
  return {[](const Selected& s) { return nothing(s) && s.home.levels.contains(s.level); },
          [](PanelLink& link, QWidget* parent) -> Section* { return new LevelSection(link, parent); }};
}
SectionEntry siteSection() {
  return {nothing,
          [](PanelLink& link, QWidget* parent) -> Section* { return new SiteSection(link, parent); }};
}

}  // namespace idap
