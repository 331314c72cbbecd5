// What selected elements of any kind have in common: the level they are on, whether they show; and deleting
// them, where they are of several kinds and no command of theirs is at hand.
#include <QPushButton>

#include "model/edits/level_edits.h"
#include "model/edits/piece_edits.h"
#include "studio/properties/sections.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

template <class IdType, class T>
void put(Home& home, Table<IdType, T> Home::*table, const std::vector<IdType>& ids, LevelId level) {
  home = changeEach(home, table, ids, [level](T& element) { element.level = level; });
}

// Walls take what is in them along, and part from walls that stay.
Home onLevel(const Home& home, const Elements& elements, LevelId level) {
  Elements all = withGroups(home, elements);
  const auto goes = [&](WallId id) {
    return std::find(all.walls.begin(), all.walls.end(), id) != all.walls.end();
  };
  for (const auto& [id, opening] : home.openings)
    if (opening->wall && goes(opening->wall)) all.openings.push_back(id);
  Home next = home;
  put(next, &Home::walls, all.walls, level);
  put(next, &Home::rooms, all.rooms, level);
  put(next, &Home::openings, all.openings, level);
  put(next, &Home::furniture, all.furniture, level);
  put(next, &Home::dimensions, all.dimensions, level);
  put(next, &Home::labels, all.labels, level);
  put(next, &Home::polylines, all.polylines, level);
  for (const auto& [id, wall] : next.walls) {
    Wall joined = *wall;
    for (WallId* neighbour : {&joined.neighbourAtStart, &joined.neighbourAtEnd})
      if (*neighbour && goes(*neighbour) != goes(id)) *neighbour = {};
    if (!(joined == *wall)) next.walls.set(id, joined);
  }
  for (const auto& [id, opening] : next.openings) {
    // A door that leaves its wall behind stands free.
    const Wall* wall = next.walls.find(opening->wall);
    if (!wall || wall->level == opening->level) continue;
    Opening freed = *opening;
    freed.wall = {};
    next.openings.set(id, freed);
  }
  return next;
}

Common<LevelId> levelOf(const Selected& s) {
  Common<LevelId> common;
  const auto add = [&common](const auto& of) {
    if (of.mixed) common.mixed = true;
    if (of.any) common.add(of.value);
  };
  const auto level = [](const auto& element) { return element.level; };
  add(s.ofPieces(level));
  add(s.ofWalls(level));
  add(s.ofRooms(level));
  add(s.ofDimensions(level));
  add(s.ofLabels(level));
  add(s.ofPolylines(level));
  return common;
}

class CommonSection : public Section {
 public:
  CommonSection(PanelLink& panelLink, QWidget* parent)
      : Section(panelLink, "commonSection", QT_TRANSLATE_NOOP("idap", "Selection"), parent) {
    level_ = new QComboBox(body());
    level_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    level_->setMinimumContentsLength(6);
    level_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    addRow({"commonLevel", QT_TRANSLATE_NOOP("idap", "Level"), "",
            QT_TRANSLATE_NOOP(
                "idap", "Puts all that is selected on another level, at the same height above its floor.")},
           level_);
    connect(level_, &QComboBox::activated, this, [this](int index) {
      const LevelId to = levels_[static_cast<std::size_t>(index)];
      Editor& editor = link().editor();
      const Elements moved = elements();
      if (link().apply(QT_TRANSLATE_NOOP("idap", "Change level"),
                       [&](const Home& home) { return onLevel(home, moved, to); })) {
        editor.setLevel(to);
        editor.select(moved);
      }
    });
    onRefresh([this](const Selected& s) { showLevels(s); });
    addCheck(
        {"commonVisible", QT_TRANSLATE_NOOP("idap", "Visible"),
         QT_TRANSLATE_NOOP("idap", "Change visibility"),
         QT_TRANSLATE_NOOP("idap", "Of the pieces among them.")},
        [](const Selected& s) {
          return s.kind == ElementKind::Mixed ? s.ofPieces([](const Piece& p) { return p.visible; })
                                              : Common<bool>();
        },
        [](const Home& home, const Elements& e, bool on) {
          return changePieces(home, e, [&](Piece& p) { p.visible = on; });
        });
    addButton(
        {"commonDelete", QT_TRANSLATE_NOOP("idap", "Delete all of it"), "",
         QT_TRANSLATE_NOOP("idap", "Takes all that is selected out of the home. Undo brings it back.")},
        [](const Selected& s) { return s.kind == ElementKind::Mixed; },
        [this] {
          const Elements gone = elements();
          link().apply(QT_TRANSLATE_NOOP("idap", "Delete"),
                       [&](const Home& home) { return deleteElements(home, gone); });
        });
  }

 private:
  void showLevels(const Selected& s) {
    const Common<LevelId> common = levelOf(s);
    setRowShown(level_, common.any && s.home.levels.size() > 1);
    if (!common.any) return;
    const std::vector<LevelId> levels = levelsInOrder(s.home);
    QStringList names;
    for (const LevelId id : levels) names << toQt(s.home.levels.find(id)->name);
    if (levels != levels_ || names != names_) {
      levels_ = levels;
      names_ = names;
      level_->clear();
      level_->addItems(names);
    }
    const auto at = std::find(levels_.begin(), levels_.end(), common.value);
    const int index = common.mixed || at == levels_.end() ? -1 : static_cast<int>(at - levels_.begin());
    level_->setPlaceholderText(common.mixed ? Section::tr("Several levels") : QString());
    if (level_->currentIndex() != index) level_->setCurrentIndex(index);
  }

  QComboBox* level_;
  std::vector<LevelId> levels_;
  QStringList names_;
};

}  // namespace

SectionEntry commonSection() {
  return {[](const Selected& s) { return s.kind != ElementKind::None; },
          [](PanelLink& link, QWidget* parent) -> Section* { return new CommonSection(link, parent); }};
}

}  // namespace idap
