// Doors and windows: what they are, where in which wall, and to which side they open.
#include <QPushButton>

#include "model/edits/piece_edits.h"
#include "model/wall_path.h"
#include "studio/properties/sections.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

Home changeOpenings(const Home& home, const Elements& e, const std::function<void(Opening&)>& change) {
  return changeEach(home, &Home::openings, withGroups(home, e).openings, change);
}

Vec2 onPlan(const Opening& opening) { return {opening.position.x, opening.position.y}; }

// Metres from the wall's start to the near side of the opening, or from its far side to the wall's end.
double clearOf(const Opening& opening, const Wall& wall, bool fromStart) {
  const WallPath path(wall);
  const double middle = path.nearest(onPlan(opening)), half = opening.size.x / 2;
  return fromStart ? middle - half : path.length() - middle - half;
}

// Its middle at a distance from the wall's start, as far from the centre line as before.
void slide(Opening& opening, const Wall& wall, double middle) {
  const WallPath path(wall);
  const Vec2 at = onPlan(opening);
  const double before = path.nearest(at);
  const Vec2 along = path.direction(before);
  const double offset = dot(at - path.point(before), perpendicular(along));
  middle = std::clamp(middle, 0.0, path.length());
  const Vec2 next = path.direction(middle);
  const Vec2 place = path.point(middle) + perpendicular(next) * offset;
  opening.position = {place.x, place.y, opening.position.z};
  opening.angle += std::atan2(next.y, next.x) - std::atan2(along.y, along.x);
}

// Opens to the other side of the wall, its hinges staying where they are along it.
void turnRound(Opening& opening) {
  // The part in the wall lies behind or before the middle of the box; it must not move.
  const double inWall = opening.size.y * (0.5 - (opening.wallDistance + opening.wallThickness / 2));
  const Vec2 back = rotated(Vec2{0, 1}, opening.angle);
  opening.position.x += 2 * inWall * back.x;
  opening.position.y += 2 * inWall * back.y;
  opening.angle = std::remainder(opening.angle + kPi, 2 * kPi);
  opening.mirrored = !opening.mirrored;
}

class OpeningSection : public Section {
 public:
  OpeningSection(PanelLink& panelLink, QWidget* parent)
      : Section(panelLink, "openingSection", QT_TRANSLATE_NOOP("idap", "In the wall"), parent) {
    addChoice(
        {"openingKind", QT_TRANSLATE_NOOP("idap", "Kind"), QT_TRANSLATE_NOOP("idap", "Change kind"),
         QT_TRANSLATE_NOOP("idap", "How it is counted in lists and drawn on the plan.")},
        {QT_TRANSLATE_NOOP("idap", "Door"), QT_TRANSLATE_NOOP("idap", "Window"),
         QT_TRANSLATE_NOOP("idap", "Bare opening")},
        [](const Selected& s) { return s.ofOpenings([](const Opening& o) { return int(o.kind); }); },
        [](const Home& home, const Elements& e, int kind) {
          return changeOpenings(home, e, [kind](Opening& o) { o.kind = static_cast<OpeningKind>(kind); });
        });
    addDistance(
        {"openingFromStart", QT_TRANSLATE_NOOP("idap", "From wall start"), QT_TRANSLATE_NOOP("idap", "Move"),
         QT_TRANSLATE_NOOP("idap", "Along the middle of the wall, from its start to the opening."), true},
        true);
    addDistance(
        {"openingToEnd", QT_TRANSLATE_NOOP("idap", "To wall end"), QT_TRANSLATE_NOOP("idap", "Move"),
         QT_TRANSLATE_NOOP("idap", "Along the middle of the wall, from the opening to its end."), true},
        false);
    addInfo({"openingWall", QT_TRANSLATE_NOOP("idap", "Wall"), "",
             QT_TRANSLATE_NOOP("idap", "The wall it is in, and follows.")},
            [](const Selected& s) {
              const auto wall = s.ofOpenings([](const Opening& o) { return o.wall; });
              if (!wall.any || wall.mixed) return QString();
              const Wall* found = s.home.walls.find(wall.value);
              if (!found) return Section::tr("In no wall");
              return Section::tr("%1 long, %2 thick")
                  .arg(lengthText(WallPath(*found).length(), s.settings.unit),
                       lengthText(found->thickness, s.settings.unit));
            });
    addButton(
        {"openingHand", QT_TRANSLATE_NOOP("idap", "Hinges on the other side"), "",
         QT_TRANSLATE_NOOP("idap", "Left-handed becomes right-handed.")},
        [](const Selected& s) {
          const auto swings = s.ofOpenings([](const Opening& o) { return !o.sashes.empty(); });
          return swings.any && (swings.mixed || swings.value);
        },
        [this] {
          link().apply(QT_TRANSLATE_NOOP("idap", "Change hinges"), [this](const Home& home) {
            return changeOpenings(home, elements(), [](Opening& o) { o.mirrored = !o.mirrored; });
          });
        });
    addButton(
        {"openingDirection", QT_TRANSLATE_NOOP("idap", "Opens to the other side"), "",
         QT_TRANSLATE_NOOP("idap", "Turned round in its wall; the hinges stay where they are.")},
        [](const Selected& s) { return s.ofOpenings([](const Opening& o) { return o.kind; }).any; },
        [this] {
          link().apply(QT_TRANSLATE_NOOP("idap", "Change direction of opening"),
                       [this](const Home& home) { return changeOpenings(home, elements(), turnRound); });
        });
    addButton(
        {"openingSelectWall", QT_TRANSLATE_NOOP("idap", "Select its wall"), "",
         QT_TRANSLATE_NOOP("idap", "Shows the properties of the wall it is in.")},
        [](const Selected& s) {
          const auto wall = s.ofOpenings([](const Opening& o) { return o.wall; });
          return wall.any && !wall.mixed && s.home.walls.contains(wall.value);
        },
        [this] {
          const Editor& editor = link().editor();
          for (const OpeningId id : elements().openings)
            if (const Opening* opening = editor.home().openings.find(id)) {
              Elements wall;
              wall.walls = {opening->wall};
              link().editor().select(wall);
              return;
            }
        });
  }

 private:
  void addDistance(const RowText& text, bool fromStart) {
    addLength(
        text,
        [fromStart](const Selected& s) {
          Common<double> common;
          for (const OpeningId id : s.all.openings)
            if (const Opening* opening = s.home.openings.find(id))
              if (const Wall* wall = s.home.walls.find(opening->wall))
                common.add(clearOf(*opening, *wall, fromStart));
          return common;
        },
        [fromStart](const Home& home, const Elements& e, double clear) {
          return changeOpenings(home, e, [&](Opening& opening) {
            const Wall* wall = home.walls.find(opening.wall);
            if (!wall) return;
            const double middle = clear + opening.size.x / 2;
            slide(opening, *wall, fromStart ? middle : WallPath(*wall).length() - middle);
          });
        },
        [](const Selected& s) {
          // As far as the narrowest choice lets it stay in its wall.
          double most = 1e4;
          for (const OpeningId id : s.all.openings)
            if (const Opening* opening = s.home.openings.find(id))
              if (const Wall* wall = s.home.walls.find(opening->wall))
                most = std::min(most, WallPath(*wall).length() - opening->size.x);
          return std::pair(0.0, std::max(0.0, most));
        });
  }
};

}  // namespace

SectionEntry openingSection() {
  return {[](const Selected& s) {
            return s.kind == ElementKind::Piece && s.elements.furniture.empty() &&
                   !s.elements.openings.empty();
          },
          [](PanelLink& link, QWidget* parent) -> Section* { return new OpeningSection(link, parent); }};
}

}  // namespace idap
