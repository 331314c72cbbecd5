// Groups: name, place and size of the whole.
#include <QPushButton>

#include "editor/selection.h"
#include "model/edits/piece_edits.h"
#include "studio/properties/sections.h"

namespace idap {

namespace {

// Scales all pieces of the selection about the middle of its base, in proportion: turned pieces keep their
// right angles.
Home scaled(const Home& home, const Elements& e, double factor) {
  const Box3 box = bounds(home, e);
  const Vec3 about{(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2, box.min.z};
  return changePieces(home, e, [&](Piece& piece) {
    const Vec3 floor{0, 0, elevationOf(home, piece.level)};
    piece.position = about + (piece.position + floor - about) * factor - floor;
    piece.size = piece.size * factor;
  });
}

Home changeGroups(const Home& home, const Elements& e, const std::function<void(Group&)>& change) {
  return changeEach(home, &Home::groups, e.groups, change);
}

class GroupSection : public Section {
 public:
  GroupSection(PanelLink& panelLink, QWidget* parent)
      : Section(panelLink, "groupSection", QT_TRANSLATE_NOOP("idap", "Group"), parent) {
    addText(
        {"groupName", QT_TRANSLATE_NOOP("idap", "Name"), QT_TRANSLATE_NOOP("idap", "Change name"), ""},
        [](const Selected& s) { return ofGroups(s, &Group::name); },
        [](const Home& home, const Elements& e, const std::string& name) {
          return changeGroups(home, e, [&](Group& g) { g.name = name; });
        });
    addCheck(
        {"groupVisible", QT_TRANSLATE_NOOP("idap", "Visible"), QT_TRANSLATE_NOOP("idap", "Change visibility"),
         QT_TRANSLATE_NOOP("idap", "Hides or shows all of it.")},
        [](const Selected& s) { return ofGroups(s, &Group::visible); },
        [](const Home& home, const Elements& e, bool on) {
          return changeGroups(home, e, [&](Group& g) { g.visible = on; });
        });
    addPlace({"groupX", QT_TRANSLATE_NOOP("idap", "X"), QT_TRANSLATE_NOOP("idap", "Move"),
              QT_TRANSLATE_NOOP("idap", "The middle of the whole, to the right of the origin."), true},
             0);
    addPlace({"groupY", QT_TRANSLATE_NOOP("idap", "Y"), QT_TRANSLATE_NOOP("idap", "Move"),
              QT_TRANSLATE_NOOP("idap", "The middle of the whole, up the plan from the origin."), true},
             1);
    addPlace({"groupElevation", QT_TRANSLATE_NOOP("idap", "Elevation"), QT_TRANSLATE_NOOP("idap", "Raise"),
              QT_TRANSLATE_NOOP("idap", "Its lowest point above the floor of the level drawn."), true},
             2);
    addSize({"groupWidth", QT_TRANSLATE_NOOP("idap", "Width"), QT_TRANSLATE_NOOP("idap", "Change width"),
             QT_TRANSLATE_NOOP("idap", "Of the whole; all its pieces change in proportion."), true},
            0);
    addSize({"groupDepth", QT_TRANSLATE_NOOP("idap", "Depth"), QT_TRANSLATE_NOOP("idap", "Change depth"),
             QT_TRANSLATE_NOOP("idap", "Of the whole; all its pieces change in proportion."), true},
            1);
    addSize({"groupHeight", QT_TRANSLATE_NOOP("idap", "Height"), QT_TRANSLATE_NOOP("idap", "Change height"),
             QT_TRANSLATE_NOOP("idap", "Of the whole; all its pieces change in proportion."), true},
            2);
    addButton(
        {"ungroup", QT_TRANSLATE_NOOP("idap", "Ungroup"), "",
         QT_TRANSLATE_NOOP("idap", "Its pieces stay where they are, each on its own.")},
        [](const Selected&) { return true; }, [this] { dissolve(); });
  }

 private:
  template <class V>
  static Common<V> ofGroups(const Selected& s, V Group::*member) {
    Common<V> common;
    for (const GroupId id : s.elements.groups)
      if (const Group* group = s.home.groups.find(id)) common.add(group->*member);
    return common;
  }
  // Of one group alone: several have no size in common worth typing.
  static std::optional<Box3> box(const Selected& s) {
    if (s.count != 1) return std::nullopt;
    const Box3 whole = bounds(s.home, s.elements);
    return whole.empty() ? std::nullopt : std::optional(whole);
  }
  static double placeOf(const Box3& box, int axis) {
    return axis == 2 ? box.min.z : (box.min[axis] + box.max[axis]) / 2;
  }
  void addPlace(const RowText& text, int axis) {
    addLength(
        text,
        [axis](const Selected& s) {
          Common<double> common;
          if (const auto whole = box(s)) common.add(placeOf(*whole, axis) - (axis == 2 ? s.elevation : 0));
          return common;
        },
        [this, axis](const Home& home, const Elements& e, double to) {
          if (axis == 2) to += link().editor().elevation();
          Vec3 by{0, 0, 0};
          by[axis] = to - placeOf(bounds(home, e), axis);
          return moveElements(home, e, by);
        });
  }
  void addSize(const RowText& text, int axis) {
    addLength(
        text,
        [axis](const Selected& s) {
          Common<double> common;
          if (const auto whole = box(s)) common.add(whole->max[axis] - whole->min[axis]);
          return common;
        },
        [axis](const Home& home, const Elements& e, double size) {
          const Box3 whole = bounds(home, e);
          return scaled(home, e, size / (whole.max[axis] - whole.min[axis]));
        },
        [](const Selected&) { return std::pair(0.001, 1000.0); });
  }
  void dissolve() {
    Editor& editor = link().editor();
    const Elements groups = elements();
    const Home before = editor.home();
    const bool done = link().apply(QT_TRANSLATE_NOOP("idap", "Ungroup"), [&](const Home& home) {
      Home next = home;
      for (const GroupId id : groups.groups) next = idap::ungroup(next, id);
      return next;
    });
    if (!done) return;
    Elements members;
    const auto is = [&](GroupId id) {
      return std::find(groups.groups.begin(), groups.groups.end(), id) != groups.groups.end();
    };
    for (const auto& [id, piece] : before.furniture)
      if (is(piece->group)) members.furniture.push_back(id);
    for (const auto& [id, opening] : before.openings)
      if (is(opening->group)) members.openings.push_back(id);
    for (const auto& [id, group] : before.groups)
      if (is(group->parent)) members.groups.push_back(id);
    editor.select(members);
  }
};

}  // namespace

SectionEntry groupSection() {
  return {[](const Selected& s) { return s.kind == ElementKind::Group; },
          [](PanelLink& link, QWidget* parent) -> Section* { return new GroupSection(link, parent); }};
}

}  // namespace idap
