// What is drawn and written on the plan: rooms, dimensions, labels, polylines.
#include "model/room_geometry.h"
#include "studio/properties/sections.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

std::pair<double, double> textSizes(const Selected&) { return {0.01, 100}; }

Home changeRooms(const Home& home, const Elements& e, const std::function<void(Room&)>& change) {
  return changeEach(home, &Home::rooms, e.rooms, change);
}
Home changeDimensions(const Home& home, const Elements& e, const std::function<void(Dimension&)>& change) {
  return changeEach(home, &Home::dimensions, e.dimensions, change);
}
Home changeLabels(const Home& home, const Elements& e, const std::function<void(Label&)>& change) {
  return changeEach(home, &Home::labels, e.labels, change);
}
Home changeLines(const Home& home, const Elements& e, const std::function<void(Polyline&)>& change) {
  return changeEach(home, &Home::polylines, e.polylines, change);
}

// Rows for a text style, of rooms' names and of labels.
class StyledSection : public Section {
 protected:
  using Section::Section;
  using ReadStyle = std::function<Common<TextStyle>(const Selected&)>;
  using Change = std::function<Home(const Home&, const Elements&, const std::function<void(TextStyle&)>&)>;

  // each: calls with every style.
  template <class Each>
  void addStyle(Each each, const Change& change, const char* prefix) {
    names_.reserve(8);
    const auto named = [this, prefix](const char* rest) {
      names_.push_back(std::string(prefix) + rest);
      return names_.back().c_str();
    };
    const auto read = [each](auto get) {
      return [each, get](const Selected& s) {
        Common<std::decay_t<decltype(get(std::declval<const TextStyle&>()))>> common;
        each(s, [&](const TextStyle& style) { common.add(get(style)); });
        return common;
      };
    };
    addLength(
        {named("Size"), QT_TRANSLATE_NOOP("idap", "Text size"), QT_TRANSLATE_NOOP("idap", "Change text size"),
         QT_TRANSLATE_NOOP("idap", "Height of a line, measured on the plan.")},
        read([](const TextStyle& t) { return t.size; }),
        [change](const Home& home, const Elements& e, double size) {
          return change(home, e, [size](TextStyle& t) { t.size = size; });
        },
        textSizes);
    addCheck({named("Bold"), QT_TRANSLATE_NOOP("idap", "Bold"),
              QT_TRANSLATE_NOOP("idap", "Change text style"), ""},
             read([](const TextStyle& t) { return t.bold; }),
             [change](const Home& home, const Elements& e, bool on) {
               return change(home, e, [on](TextStyle& t) { t.bold = on; });
             });
    addCheck({named("Italic"), QT_TRANSLATE_NOOP("idap", "Italic"),
              QT_TRANSLATE_NOOP("idap", "Change text style"), ""},
             read([](const TextStyle& t) { return t.italic; }),
             [change](const Home& home, const Elements& e, bool on) {
               return change(home, e, [on](TextStyle& t) { t.italic = on; });
             });
    addChoice({named("Alignment"), QT_TRANSLATE_NOOP("idap", "Alignment"),
               QT_TRANSLATE_NOOP("idap", "Change text style"),
               QT_TRANSLATE_NOOP("idap", "Of its lines, about its place.")},
              {QT_TRANSLATE_NOOP("idap", "Left"), QT_TRANSLATE_NOOP("idap", "Centred"),
               QT_TRANSLATE_NOOP("idap", "Right")},
              read([](const TextStyle& t) { return static_cast<int>(t.alignment); }),
              [change](const Home& home, const Elements& e, int at) {
                return change(home, e, [at](TextStyle& t) { t.alignment = static_cast<TextAlignment>(at); });
              });
    addColor({named("Color"), QT_TRANSLATE_NOOP("idap", "Text colour"),
              QT_TRANSLATE_NOOP("idap", "Change colour"), ""},
             QT_TRANSLATE_NOOP("idap", "As the plan"), read([](const TextStyle& t) { return t.color; }),
             [change](const Home& home, const Elements& e, const std::optional<Color>& color) {
               return change(home, e, [&color](TextStyle& t) { t.color = color; });
             });
  }

 private:
  std::vector<std::string> names_;
};

class RoomSection : public StyledSection {
 public:
  RoomSection(PanelLink& link, QWidget* parent)
      : StyledSection(link, "roomSection", QT_TRANSLATE_NOOP("idap", "Room"), parent) {
    addText(
        {"roomName", QT_TRANSLATE_NOOP("idap", "Name"), QT_TRANSLATE_NOOP("idap", "Change name"),
         QT_TRANSLATE_NOOP("idap", "Stands in the room on the plan.")},
        [](const Selected& s) { return s.ofRooms([](const Room& r) { return r.name; }); },
        [](const Home& home, const Elements& e, const std::string& name) {
          return changeRooms(home, e, [&](Room& r) { r.name = name; });
        });
    addInfo({"roomArea", QT_TRANSLATE_NOOP("idap", "Area"), "",
             QT_TRANSLATE_NOOP("idap", "Of its floor; of several rooms together.")},
            [](const Selected& s) {
              double area = 0;
              for (const RoomId id : s.all.rooms)
                if (const Room* room = s.home.rooms.find(id)) area += floorArea(*room);
              return areaText(area, s.settings.unit);
            });
    check({"roomAreaVisible", QT_TRANSLATE_NOOP("idap", "Area on the plan"),
           QT_TRANSLATE_NOOP("idap", "Show area"), ""},
          &Room::areaVisible);
    check({"roomFloorVisible", QT_TRANSLATE_NOOP("idap", "Has a floor"),
           QT_TRANSLATE_NOOP("idap", "Change floor"),
           QT_TRANSLATE_NOOP("idap", "Without, one sees down to the level below.")},
          &Room::floorVisible);
    finish({"roomFloor", QT_TRANSLATE_NOOP("idap", "Floor"), QT_TRANSLATE_NOOP("idap", "Change floor"),
            QT_TRANSLATE_NOOP("idap", "Boards, tiles or carpet.")},
           &Room::floor, QT_TRANSLATE_NOOP("idap", "Plain floor"), Color{0.72f, 0.70f, 0.67f});
    check({"roomCeilingVisible", QT_TRANSLATE_NOOP("idap", "Has a ceiling"),
           QT_TRANSLATE_NOOP("idap", "Change ceiling"),
           QT_TRANSLATE_NOOP("idap", "Without, it is open to above.")},
          &Room::ceilingVisible);
    finish({"roomCeiling", QT_TRANSLATE_NOOP("idap", "Ceiling"), QT_TRANSLATE_NOOP("idap", "Change ceiling"),
            ""},
           &Room::ceiling, QT_TRANSLATE_NOOP("idap", "White paint"), Color{});
    check({"roomCeilingFlat", QT_TRANSLATE_NOOP("idap", "Flat ceiling"),
           QT_TRANSLATE_NOOP("idap", "Change ceiling"),
           QT_TRANSLATE_NOOP("idap", "Level at the height of the storey, even where walls slope.")},
          &Room::ceilingFlat);
    addStyle(
        [](const Selected& s, auto&& f) {
          for (const RoomId id : s.all.rooms)
            if (const Room* room = s.home.rooms.find(id)) f(room->nameStyle);
        },
        [](const Home& home, const Elements& e, const std::function<void(TextStyle&)>& change) {
          return changeRooms(home, e, [&](Room& r) { change(r.nameStyle); });
        },
        "roomName");
  }

 private:
  void check(const RowText& text, bool Room::*member) {
    addCheck(
        text,
        [member](const Selected& s) { return s.ofRooms([member](const Room& r) { return r.*member; }); },
        [member](const Home& home, const Elements& e, bool on) {
          return changeRooms(home, e, [&](Room& r) { r.*member = on; });
        });
  }
  void finish(const RowText& text, Finish Room::*member, const char* plainWords, Color plain) {
    addFinish(
        text, plainWords,
        [member](const Selected& s) { return s.ofRooms([member](const Room& r) { return r.*member; }); },
        [member](const Home& home, const Elements& e, const Finish& value) {
          return changeRooms(home, e, [&](Room& r) { r.*member = value; });
        },
        plain);
  }
};

class DimensionSection : public Section {
 public:
  DimensionSection(PanelLink& link, QWidget* parent)
      : Section(link, "dimensionSection", QT_TRANSLATE_NOOP("idap", "Dimension"), parent) {
    addInfo({"dimensionLength", QT_TRANSLATE_NOOP("idap", "Length"), "",
             QT_TRANSLATE_NOOP("idap", "What it measures.")},
            [](const Selected& s) {
              const auto measured = s.ofDimensions([](const Dimension& d) {
                return std::hypot(length(d.end - d.start), d.endElevation - d.startElevation);
              });
              return measured.mixed ? Section::tr("Several values")
                                    : lengthText(measured.value, s.settings.unit);
            });
    addLength(
        {"dimensionOffset", QT_TRANSLATE_NOOP("idap", "Offset"),
         QT_TRANSLATE_NOOP("idap", "Move dimension line"),
         QT_TRANSLATE_NOOP("idap", "From what is measured to the line; negative on the other side.")},
        [](const Selected& s) { return s.ofDimensions([](const Dimension& d) { return d.offset; }); },
        [](const Home& home, const Elements& e, double offset) {
          return changeDimensions(home, e, [&](Dimension& d) { d.offset = offset; });
        });
    addLength(
        {"dimensionTextSize", QT_TRANSLATE_NOOP("idap", "Text size"),
         QT_TRANSLATE_NOOP("idap", "Change text size"),
         QT_TRANSLATE_NOOP("idap", "Height of its figures, measured on the plan.")},
        [](const Selected& s) { return s.ofDimensions([](const Dimension& d) { return d.textSize; }); },
        [](const Home& home, const Elements& e, double size) {
          return changeDimensions(home, e, [&](Dimension& d) { d.textSize = size; });
        },
        textSizes);
    addColor(
        {"dimensionColor", QT_TRANSLATE_NOOP("idap", "Colour"), QT_TRANSLATE_NOOP("idap", "Change colour"),
         ""},
        QT_TRANSLATE_NOOP("idap", "As the plan"),
        [](const Selected& s) { return s.ofDimensions([](const Dimension& d) { return d.color; }); },
        [](const Home& home, const Elements& e, const std::optional<Color>& color) {
          return changeDimensions(home, e, [&](Dimension& d) { d.color = color; });
        });
  }
};

class LabelSection : public StyledSection {
 public:
  LabelSection(PanelLink& link, QWidget* parent)
      : StyledSection(link, "labelSection", QT_TRANSLATE_NOOP("idap", "Text"), parent) {
    addTextArea(
        {"labelText", QT_TRANSLATE_NOOP("idap", "Text"), QT_TRANSLATE_NOOP("idap", "Change text"),
         QT_TRANSLATE_NOOP("idap", "As many lines as you like. Control+Enter or leaving the field applies.")},
        4, [](const Selected& s) { return s.ofLabels([](const Label& l) { return l.text; }); },
        [](const Home& home, const Elements& e, const std::string& text) {
          return changeLabels(home, e, [&](Label& l) { l.text = text; });
        });
    addStyle(
        [](const Selected& s, auto&& f) {
          for (const LabelId id : s.all.labels)
            if (const Label* label = s.home.labels.find(id)) f(label->style);
        },
        [](const Home& home, const Elements& e, const std::function<void(TextStyle&)>& change) {
          return changeLabels(home, e, [&](Label& l) { change(l.style); });
        },
        "label");
    addAngle(
        {"labelAngle", QT_TRANSLATE_NOOP("idap", "Angle"), QT_TRANSLATE_NOOP("idap", "Turn"),
         QT_TRANSLATE_NOOP("idap", "Counter-clockwise, in degrees.")},
        [](const Selected& s) { return s.ofLabels([](const Label& l) { return positiveDegrees(l.angle); }); },
        [](const Home& home, const Elements& e, double angle) {
          return changeLabels(home, e, [&](Label& l) { l.angle = radians(angle); });
        });
    addCheck(
        {"labelIn3D", QT_TRANSLATE_NOOP("idap", "In pictures too"),
         QT_TRANSLATE_NOOP("idap", "Show text in pictures"),
         QT_TRANSLATE_NOOP("idap", "The text stands or lies in the room itself, as a sign does.")},
        [](const Selected& s) { return s.ofLabels([](const Label& l) { return l.pitch.has_value(); }); },
        [](const Home& home, const Elements& e, bool on) {
          return changeLabels(home, e, [&](Label& l) {
            if (!on)
              l.pitch.reset();
            else if (!l.pitch)
              l.pitch = 0;
          });
        });
    addAngle(
        {"labelPitch", QT_TRANSLATE_NOOP("idap", "Pitch"), QT_TRANSLATE_NOOP("idap", "Tilt"),
         QT_TRANSLATE_NOOP("idap", "0 lies flat, 90 stands upright.")},
        [](const Selected& s) {
          Common<double> common;
          forEachIn3D(s, [&](const Label& l) { common.add(signedDegrees(*l.pitch)); });
          return common;
        },
        [](const Home& home, const Elements& e, double angle) {
          return changeLabels(home, e, [&](Label& l) {
            if (l.pitch) l.pitch = radians(angle);
          });
        });
    addLength(
        {"labelElevation", QT_TRANSLATE_NOOP("idap", "Elevation"), QT_TRANSLATE_NOOP("idap", "Raise"),
         QT_TRANSLATE_NOOP("idap", "Above the floor.")},
        [](const Selected& s) {
          Common<double> common;
          forEachIn3D(s, [&](const Label& l) { common.add(l.elevation); });
          return common;
        },
        [](const Home& home, const Elements& e, double elevation) {
          return changeLabels(home, e, [&](Label& l) { l.elevation = elevation; });
        });
  }

 private:
  static void forEachIn3D(const Selected& s, const std::function<void(const Label&)>& f) {
    for (const LabelId id : s.all.labels)
      if (const Label* label = s.home.labels.find(id); label && label->pitch) f(*label);
  }
};

class PolylineSection : public Section {
 public:
  PolylineSection(PanelLink& link, QWidget* parent)
      : Section(link, "polylineSection", QT_TRANSLATE_NOOP("idap", "Line"), parent) {
    addLength(
        {"lineThickness", QT_TRANSLATE_NOOP("idap", "Thickness"),
         QT_TRANSLATE_NOOP("idap", "Change thickness"), QT_TRANSLATE_NOOP("idap", "Measured on the plan.")},
        [](const Selected& s) { return s.ofPolylines([](const Polyline& l) { return l.thickness; }); },
        [](const Home& home, const Elements& e, double thickness) {
          return changeLines(home, e, [&](Polyline& l) { l.thickness = thickness; });
        },
        [](const Selected&) { return std::pair(0.0, 10.0); });
    addColor(
        {"lineColor", QT_TRANSLATE_NOOP("idap", "Colour"), QT_TRANSLATE_NOOP("idap", "Change colour"), ""},
        "",
        [](const Selected& s) {
          return s.ofPolylines([](const Polyline& l) { return std::optional(l.color); });
        },
        [](const Home& home, const Elements& e, const std::optional<Color>& color) {
          return changeLines(home, e, [&](Polyline& l) { l.color = color.value_or(l.color); });
        });
    choice({"lineDash", QT_TRANSLATE_NOOP("idap", "Dashes"), QT_TRANSLATE_NOOP("idap", "Change dashes"), ""},
           &Polyline::dash,
           {QT_TRANSLATE_NOOP("idap", "Solid"), QT_TRANSLATE_NOOP("idap", "Dots"),
            QT_TRANSLATE_NOOP("idap", "Dashes"), QT_TRANSLATE_NOOP("idap", "Dash, dot"),
            QT_TRANSLATE_NOOP("idap", "Dash, two dots")});
    const std::vector<const char*> arrows{
        QT_TRANSLATE_NOOP("idap", "None"), QT_TRANSLATE_NOOP("idap", "Filled arrow"),
        QT_TRANSLATE_NOOP("idap", "Open arrow"), QT_TRANSLATE_NOOP("idap", "Dot")};
    choice(
        {"lineStartArrow", QT_TRANSLATE_NOOP("idap", "Start"), QT_TRANSLATE_NOOP("idap", "Change arrow"), ""},
        &Polyline::startArrow, arrows);
    choice({"lineEndArrow", QT_TRANSLATE_NOOP("idap", "End"), QT_TRANSLATE_NOOP("idap", "Change arrow"), ""},
           &Polyline::endArrow, arrows);
    check({"lineClosed", QT_TRANSLATE_NOOP("idap", "Closed"), QT_TRANSLATE_NOOP("idap", "Close line"),
           QT_TRANSLATE_NOOP("idap", "Its end is joined to its start.")},
          &Polyline::closed);
    check({"lineCurved", QT_TRANSLATE_NOOP("idap", "Curved"), QT_TRANSLATE_NOOP("idap", "Curve line"),
           QT_TRANSLATE_NOOP("idap", "A smooth line through its points.")},
          &Polyline::curved);
  }

 private:
  void check(const RowText& text, bool Polyline::*member) {
    addCheck(
        text,
        [member](const Selected& s) {
          return s.ofPolylines([member](const Polyline& l) { return l.*member; });
        },
        [member](const Home& home, const Elements& e, bool on) {
          return changeLines(home, e, [&](Polyline& l) { l.*member = on; });
        });
  }
  template <class E>
  void choice(const RowText& text, E Polyline::*member, std::vector<const char*> options) {
    addChoice(
        text, std::move(options),
        [member](const Selected& s) {
          return s.ofPolylines([member](const Polyline& l) { return static_cast<int>(l.*member); });
        },
        [member](const Home& home, const Elements& e, int index) {
          return changeLines(home, e, [&](Polyline& l) { l.*member = static_cast<E>(index); });
        });
  }
};

}  // namespace

SectionEntry roomSection() {
  return {[](const Selected& s) { return s.kind == ElementKind::Room; },
          [](PanelLink& link, QWidget* parent) -> Section* { return new RoomSection(link, parent); }};
}
SectionEntry dimensionSection() {
  return {[](const Selected& s) { return s.kind == ElementKind::Dimension; },
          [](PanelLink& link, QWidget* parent) -> Section* { return new DimensionSection(link, parent); }};
}
SectionEntry labelSection() {
  return {[](const Selected& s) { return s.kind == ElementKind::Label; },
          [](PanelLink& link, QWidget* parent) -> Section* { return new LabelSection(link, parent); }};
}
SectionEntry polylineSection() {
  return {[](const Selected& s) { return s.kind == ElementKind::Polyline; },
          [](PanelLink& link, QWidget* parent) -> Section* { return new PolylineSection(link, parent); }};
}

}  // namespace idap
