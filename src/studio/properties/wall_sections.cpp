// Walls: shape, heights, what they look like on either side, where their ends are.
#include <array>

#include "model/edits/wall_edits.h"
#include "model/wall_path.h"
#include "studio/properties/sections.h"

namespace idap {

namespace {

// Patterns that plans hatch walls with, as Sweet Home 3D's files name them.
constexpr std::array<const char*, 8> kPatterns{
    "",           "background",      "hatchUp",           "hatchDown",
    "crossHatch", "reversedHatchUp", "reversedHatchDown", "reversedCrossHatch"};

bool onlyWalls(const Selected& s) { return s.kind == ElementKind::Wall; }

Home changeWalls(const Home& home, const Elements& e, const std::function<void(Wall&)>& change) {
  Home next = home;
  for (const WallId id : e.walls)
    if (const Wall* wall = next.walls.find(id)) {
      Wall copy = *wall;
      change(copy);
      if (!(copy == *wall)) next = replaceWall(next, id, copy);
    }
  return next;
}

double angleOf(const Wall& wall) {
  const Vec2 along = wall.end - wall.start;
  return std::atan2(along.y, along.x);
}

class WallSection : public Section {
 public:
  WallSection(PanelLink& link, QWidget* parent)
      : Section(link, "wallSection", QT_TRANSLATE_NOOP("idap", "Wall"), parent) {
    addLength(
        {"wallLength", QT_TRANSLATE_NOOP("idap", "Length"), QT_TRANSLATE_NOOP("idap", "Change length"),
         QT_TRANSLATE_NOOP("idap",
                           "Along its middle. Its start stays, its end moves, with the wall joined there."),
         true},
        [](const Selected& s) { return s.ofWalls([](const Wall& w) { return WallPath(w).length(); }); },
        [](const Home& home, const Elements& e, double length) {
          Home next = home;
          for (const WallId id : e.walls)
            if (const Wall* wall = next.walls.find(id)) {
              const double factor = length / WallPath(*wall).length();
              next = moveWallEnd(next, id, WallEnd::End, wall->start + (wall->end - wall->start) * factor);
            }
          return next;
        },
        [](const Selected&) { return std::pair(0.01, 1e4); });
    addAngle(
        {"wallAngle", QT_TRANSLATE_NOOP("idap", "Angle"), QT_TRANSLATE_NOOP("idap", "Turn wall"),
         QT_TRANSLATE_NOOP("idap", "Of its direction, counter-clockwise from the right. Its start stays."),
         true},
        [](const Selected& s) {
          return s.ofWalls([](const Wall& w) { return positiveDegrees(angleOf(w)); });
        },
        [](const Home& home, const Elements& e, double angle) {
          Home next = home;
          for (const WallId id : e.walls)
            if (const Wall* wall = next.walls.find(id)) {
              const Vec2 along = rotated(Vec2{length(wall->end - wall->start), 0}, radians(angle));
              next = moveWallEnd(next, id, WallEnd::End, wall->start + along);
            }
          return next;
        });
    addLength(
        {"wallThickness", QT_TRANSLATE_NOOP("idap", "Thickness"),
         QT_TRANSLATE_NOOP("idap", "Change thickness"),
         QT_TRANSLATE_NOOP("idap", "Half of it on either side of the middle."), true},
        [](const Selected& s) { return s.ofWalls([](const Wall& w) { return w.thickness; }); },
        [](const Home& home, const Elements& e, double thickness) {
          return changeWalls(home, e, [&](Wall& w) { w.thickness = thickness; });
        },
        [](const Selected&) { return std::pair(0.001, 10.0); });
    const auto heights = [](const Selected&) { return std::pair(0.01, 1000.0); };
    addLength(
        {"wallHeight", QT_TRANSLATE_NOOP("idap", "Height"), QT_TRANSLATE_NOOP("idap", "Change height"),
         QT_TRANSLATE_NOOP("idap", "Above the floor, from end to end.")},
        [](const Selected& s) {
          Common<double> common;
          for (const WallId id : s.all.walls)
            if (const Wall* wall = s.home.walls.find(id))
              common.add(wall->heightAtStart), common.add(wall->heightAtEnd);
          return common;
        },
        [](const Home& home, const Elements& e, double height) {
          return changeWalls(home, e, [&](Wall& w) { w.heightAtStart = w.heightAtEnd = height; });
        },
        heights);
    addLength(
        {"wallHeightStart", QT_TRANSLATE_NOOP("idap", "Height at start"),
         QT_TRANSLATE_NOOP("idap", "Change height"),
         QT_TRANSLATE_NOOP("idap", "For a wall with a sloping top.")},
        [](const Selected& s) { return s.ofWalls([](const Wall& w) { return w.heightAtStart; }); },
        [](const Home& home, const Elements& e, double height) {
          return changeWalls(home, e, [&](Wall& w) { w.heightAtStart = height; });
        },
        heights);
    addLength(
        {"wallHeightEnd", QT_TRANSLATE_NOOP("idap", "Height at end"),
         QT_TRANSLATE_NOOP("idap", "Change height"),
         QT_TRANSLATE_NOOP("idap", "For a wall with a sloping top.")},
        [](const Selected& s) { return s.ofWalls([](const Wall& w) { return w.heightAtEnd; }); },
        [](const Home& home, const Elements& e, double height) {
          return changeWalls(home, e, [&](Wall& w) { w.heightAtEnd = height; });
        },
        heights);
    addNumber(
        {"wallArc", QT_TRANSLATE_NOOP("idap", "Arc"), QT_TRANSLATE_NOOP("idap", "Bend wall"),
         QT_TRANSLATE_NOOP("idap",
                           "How far a round wall goes round: 0 is straight, 180 half a circle, "
                           "negative to the other side."),
         true},
        QStringLiteral("°"), 2,
        [](const Selected& s) { return s.ofWalls([](const Wall& w) { return degrees(w.arcExtent); }); },
        [](const Home& home, const Elements& e, double angle) {
          return changeWalls(home, e, [&](Wall& w) { w.arcExtent = radians(angle); });
        },
        [](const Selected&) { return std::pair(-355.0, 355.0); });
    addChoice(
        {"wallPattern", QT_TRANSLATE_NOOP("idap", "Pattern"), QT_TRANSLATE_NOOP("idap", "Change pattern"),
         QT_TRANSLATE_NOOP("idap", "How it is hatched on the plan.")},
        {QT_TRANSLATE_NOOP("idap", "Filled"), QT_TRANSLATE_NOOP("idap", "Empty"),
         QT_TRANSLATE_NOOP("idap", "Hatched upwards"), QT_TRANSLATE_NOOP("idap", "Hatched downwards"),
         QT_TRANSLATE_NOOP("idap", "Cross-hatched"), QT_TRANSLATE_NOOP("idap", "Hatched upwards, dark"),
         QT_TRANSLATE_NOOP("idap", "Hatched downwards, dark"),
         QT_TRANSLATE_NOOP("idap", "Cross-hatched, dark")},
        [](const Selected& s) {
          return s.ofWalls([](const Wall& w) {
            const auto at = std::find(kPatterns.begin(), kPatterns.end(), w.pattern);
            return at == kPatterns.end() ? -1 : static_cast<int>(at - kPatterns.begin());
          });
        },
        [](const Home& home, const Elements& e, int pattern) {
          return changeWalls(home, e,
                             [&](Wall& w) { w.pattern = kPatterns[static_cast<std::size_t>(pattern)]; });
        });
    addFinish(
        {"wallTop", QT_TRANSLATE_NOOP("idap", "Top"), QT_TRANSLATE_NOOP("idap", "Change finish"),
         QT_TRANSLATE_NOOP("idap", "Seen where the wall is lower than the room.")},
        QT_TRANSLATE_NOOP("idap", "White paint"),
        [](const Selected& s) { return s.ofWalls([](const Wall& w) { return w.top; }); },
        [](const Home& home, const Elements& e, const Finish& finish) {
          return changeWalls(home, e, [&](Wall& w) { w.top = finish; });
        },
        Color{});
  }
};

class WallSideSection : public Section {
 public:
  WallSideSection(PanelLink& link, WallSide Wall::*side, const char* name, const char* title, QWidget* parent)
      : Section(link, name, title, parent) {
    addFinish(
        {"sideFinish", QT_TRANSLATE_NOOP("idap", "Finish"), QT_TRANSLATE_NOOP("idap", "Change finish"),
         QT_TRANSLATE_NOOP("idap",
                           "Paint, paper or tiles of this side. Left and right are seen from the "
                           "start of the wall to its end.")},
        QT_TRANSLATE_NOOP("idap", "White paint"),
        [side](const Selected& s) { return s.ofWalls([side](const Wall& w) { return (w.*side).finish; }); },
        [side](const Home& home, const Elements& e, const Finish& finish) {
          return changeWalls(home, e, [&](Wall& w) { (w.*side).finish = finish; });
        },
        Color{});
    addCheck(
        {"sideBaseboard", QT_TRANSLATE_NOOP("idap", "Skirting board"),
         QT_TRANSLATE_NOOP("idap", "Change skirting board"),
         QT_TRANSLATE_NOOP("idap", "A board along the foot of the wall.")},
        [side](const Selected& s) {
          return s.ofWalls([side](const Wall& w) { return (w.*side).baseboard.has_value(); });
        },
        [side](const Home& home, const Elements& e, bool on) {
          return changeWalls(home, e, [&](Wall& w) {
            auto& board = (w.*side).baseboard;
            if (!on)
              board.reset();
            else if (!board)
              board = Baseboard{};
          });
        });
    addBoard({"boardHeight", QT_TRANSLATE_NOOP("idap", "Board height"),
              QT_TRANSLATE_NOOP("idap", "Change skirting board"), ""},
             side, &Baseboard::height);
    addBoard({"boardThickness", QT_TRANSLATE_NOOP("idap", "Board thickness"),
              QT_TRANSLATE_NOOP("idap", "Change skirting board"), ""},
             side, &Baseboard::thickness);
    addFinish(
        {"boardFinish", QT_TRANSLATE_NOOP("idap", "Board finish"),
         QT_TRANSLATE_NOOP("idap", "Change skirting board"), ""},
        QT_TRANSLATE_NOOP("idap", "As the wall"),
        [side](const Selected& s) {
          Common<Finish> common;
          forEachBoard(s, side, [&](const Baseboard& b) { common.add(b.finish); });
          return common;
        },
        [side](const Home& home, const Elements& e, const Finish& finish) {
          return changeWalls(home, e, [&](Wall& w) {
            if (auto& board = (w.*side).baseboard) board->finish = finish;
          });
        });
  }

 private:
  static void forEachBoard(const Selected& s, WallSide Wall::*side,
                           const std::function<void(const Baseboard&)>& f) {
    for (const WallId id : s.all.walls)
      if (const Wall* wall = s.home.walls.find(id); wall && (wall->*side).baseboard)
        f(*(wall->*side).baseboard);
  }
  void addBoard(const RowText& text, WallSide Wall::*side, double Baseboard::*member) {
    addLength(
        text,
        [side, member](const Selected& s) {
          Common<double> common;
          forEachBoard(s, side, [&](const Baseboard& b) { common.add(b.*member); });
          return common;
        },
        [side, member](const Home& home, const Elements& e, double value) {
          return changeWalls(home, e, [&](Wall& w) {
            if (auto& board = (w.*side).baseboard) (*board).*member = value;
          });
        },
        [](const Selected&) { return std::pair(0.001, 10.0); });
  }
};

class WallEndsSection : public Section {
 public:
  WallEndsSection(PanelLink& link, QWidget* parent)
      : Section(link, "wallEndsSection", QT_TRANSLATE_NOOP("idap", "Ends"), parent) {
    add({"wallStartX", QT_TRANSLATE_NOOP("idap", "Start X"), QT_TRANSLATE_NOOP("idap", "Move end of wall"),
         QT_TRANSLATE_NOOP("idap", "Where its middle begins; a wall joined there follows."), true},
        WallEnd::Start, &Vec2::x);
    add({"wallStartY", QT_TRANSLATE_NOOP("idap", "Start Y"), QT_TRANSLATE_NOOP("idap", "Move end of wall"),
         QT_TRANSLATE_NOOP("idap", "Where its middle begins; a wall joined there follows."), true},
        WallEnd::Start, &Vec2::y);
    add({"wallEndX", QT_TRANSLATE_NOOP("idap", "End X"), QT_TRANSLATE_NOOP("idap", "Move end of wall"),
         QT_TRANSLATE_NOOP("idap", "Where its middle ends; a wall joined there follows."), true},
        WallEnd::End, &Vec2::x);
    add({"wallEndY", QT_TRANSLATE_NOOP("idap", "End Y"), QT_TRANSLATE_NOOP("idap", "Move end of wall"),
         QT_TRANSLATE_NOOP("idap", "Where its middle ends; a wall joined there follows."), true},
        WallEnd::End, &Vec2::y);
  }

 private:
  void add(const RowText& text, WallEnd end, double Vec2::*axis) {
    addLength(
        text,
        [end, axis](const Selected& s) {
          return s.ofWalls([&](const Wall& w) { return (end == WallEnd::Start ? w.start : w.end).*axis; });
        },
        [end, axis](const Home& home, const Elements& e, double at) {
          Home next = home;
          for (const WallId id : e.walls)
            if (const Wall* wall = next.walls.find(id)) {
              Vec2 to = end == WallEnd::Start ? wall->start : wall->end;
              to.*axis = at;
              next = moveWallEnd(next, id, end, to);
            }
          return next;
        });
  }
};

}  // namespace

SectionEntry wallSection() {
  return {onlyWalls,
          [](PanelLink& link, QWidget* parent) -> Section* { return new WallSection(link, parent); }};
}
SectionEntry wallLeftSection() {
  return {onlyWalls, [](PanelLink& link, QWidget* parent) -> Section* {
            return new WallSideSection(link, &Wall::left, "wallLeftSection",
                                       QT_TRANSLATE_NOOP("idap", "Left side"), parent);
          }};
}
SectionEntry wallRightSection() {
  return {onlyWalls, [](PanelLink& link, QWidget* parent) -> Section* {
            return new WallSideSection(link, &Wall::right, "wallRightSection",
                                       QT_TRANSLATE_NOOP("idap", "Right side"), parent);
          }};
}
SectionEntry wallEndsSection() {
  return {onlyWalls,
          [](PanelLink& link, QWidget* parent) -> Section* { return new WallEndsSection(link, parent); }};
}

}  // namespace idap
