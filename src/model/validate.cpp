#include "model/validate.h"

#include <map>
#include <utility>

#include "base/error.h"
#include "model/element_rules.h"
#include "model/structure_rules.h"
#include "model/tables.h"

namespace idap {

namespace {

template <class T>
std::string nameOf(const T& element) {
  if constexpr (requires { element.name; })
    return toValidUtf8(element.name);
  else
    return {};
}

std::string describe(const char* kind, std::uint64_t id, const std::string& name) {
  std::string place = kind;
  if (id) place += ' ' + std::to_string(id);
  if (!name.empty()) place += " \"" + std::string(utf8Prefix(name, 80)) + '"';
  return place;
}

// Gathers complaints so that a thousand equal ones make one line.
class Complaints {
 public:
  void add(const char* kind, const std::string& place, const char* what) {
    Pile& pile = piles_[{kind, what}];
    if (pile.count++ < kNamed) pile.places.push_back(place);
  }
  void moveTo(ImportReport& report) {
    for (auto& [key, pile] : piles_) {
      std::string place;
      for (const std::string& p : pile.places) place += (place.empty() ? "" : ", ") + p;
      if (pile.count > kNamed) place += " and " + std::to_string(pile.count - kNamed) + " more";
      report.entries.push_back({std::move(place), key.second, pile.count});
    }
  }

 private:
  static constexpr std::size_t kNamed = 3;
  struct Pile {
    std::vector<std::string> places;
    std::size_t count = 0;
  };
  std::map<std::pair<std::string, std::string>, Pile> piles_;
};

template <class IdType, class T>
void mendTable(Home& home, Table<IdType, T> Home::*table, const char* kind, Complaints& complaints) {
  typename Table<IdType, T>::Chunk kept;
  bool changed = false;
  for (const auto& [id, element] : home.*table) {
    Judge look(home);
    judge(std::as_const(*element), look);
    if (look.clean()) {
      kept.emplace_back(id, element);
      continue;
    }
    changed = true;
    T mended = *element;
    Judge mend(home);
    judge(mended, mend);
    for (const char* what : mend.findings())
      complaints.add(kind, describe(kind, id.value, nameOf(*element)), what);
    if (!mend.dropped()) kept.emplace_back(id, std::make_shared<const T>(std::move(mended)));
  }
  if (changed) home.*table = Table<IdType, T>::of(std::move(kept));
}

void mendBackgrounds(Home& home, Complaints& complaints) {
  for (auto entry = home.backgrounds.begin(); entry != home.backgrounds.end();) {
    Judge mend(home);
    if (entry->first && !home.levels.contains(entry->first))
      mend.drop("on a level that does not exist: dropped");
    else
      judge(entry->second, mend);
    for (const char* what : mend.findings())
      complaints.add("background", describe("background of level", entry->first.value, ""), what);
    entry = mend.dropped() ? home.backgrounds.erase(entry) : std::next(entry);
  }
}

[[noreturn]] void refuse(const std::string& place, const char* what) {
  throw InvalidHome(place + ": " + what);
}

// What is wrong, without the words after the colon that say how a file would be mended.
void refuseFindings(const Judge& judge, const std::string& place) {
  if (judge.clean()) return;
  const std::string what = judge.findings().front();
  refuse(place, what.substr(0, what.find(": ")).c_str());
}

template <class IdType, class T>
void requireElements(const Home& home, const Table<IdType, T>& table, const std::vector<IdType>& ids,
                     const char* kind) {
  for (const IdType id : ids) {
    const T& element = *table.find(id);
    Judge look(home);
    judge(element, look);
    if (!look.clean()) refuseFindings(look, describe(kind, id.value, nameOf(element)));
  }
}

void requireIds(const Home& home, const HomeDiff& changed) {
  if (lastId(home) >= home.nextId || home.nextId > kMaxId) refuse("home", "the next free number is not free");
  forEachTable([&](auto table, auto changes, const char* kind) {
    if ((home.*table).size() > kMaxElements) refuse(kind, "over a million of them");
    for (const auto id : (changed.*changes).added) {
      if (!id) refuse(kind, "has no number");
      std::size_t uses = 0;
      forEachTable([&](auto other, auto, const char*) {
        using OtherId = typename std::remove_cvref_t<decltype((home.*other).begin()->first)>;
        uses += (home.*other).contains(OtherId{id.value}) ? 1 : 0;
      });
      if (uses > 1) refuse(describe(kind, id.value, ""), "number used twice");
    }
  });
}

void requireFrame(const Home& home) {
  Judge look(home);
  judgeFrame(home, look);
  refuseFindings(look, "home");
  for (const auto& [level, background] : home.backgrounds) {
    const std::string place = describe("background of level", level.value, "");
    if (level && !home.levels.contains(level)) refuse(place, "on a level that does not exist");
    Judge backgroundLook(home);
    judge(background, backgroundLook);
    refuseFindings(backgroundLook, place);
  }
}

}  // namespace

Home validated(Home home, ImportReport& report) {
  Complaints complaints;
  const Complaint complain = [&](const char* kind, std::uint64_t id, const std::string& name,
                                 const char* what) { complaints.add(kind, describe(kind, id, name), what); };
  mendAssets(home, complain);
  mendCounts(home, complain);
  mendIds(home, complain);
  mendTable(home, &Home::walls, "wall", complaints);
  mendDoubleWalls(home, complain);
  mendSelfNeighbours(home, complain);
  // Once more with the walls, whose neighbours may have been dropped.
  forEachTable([&](auto table, auto, const char* kind) { mendTable(home, table, kind, complaints); });
  mendGroupCircles(home, complain);
  mendBackgrounds(home, complaints);
  Judge frame(home);
  judgeFrame(home, frame);
  for (const char* what : frame.findings()) complaints.add("home", "home", what);
  complaints.moveTo(report);
  return home;
}

void requireValid(const Home& home) { requireValid(home, Home{}); }

void requireValid(const Home& home, const Home& validBefore) {
  if (!home.assets) refuse("home", "has no table of files");
  const HomeDiff changed = diff(validBefore, home);
  // Elements that did not change can still point at something that is gone.
  if (!changed.levels.removed.empty() || !changed.groups.removed.empty() || !changed.walls.removed.empty() ||
      (changed.assets && !validBefore.assets->empty()))
    return requireValid(home);
  if (changed.assets)
    for (const auto& [name, bytes] : *home.assets)
      if (!bytes || !usableAssetName(name))
        refuse("file " + toValidUtf8(name), "empty or of an unusable name");
  requireIds(home, changed);
  forEachTable([&](auto table, auto changes, const char* kind) {
    requireElements(home, home.*table, (changed.*changes).added, kind);
    requireElements(home, home.*table, (changed.*changes).changed, kind);
  });
  if (!changed.groups.empty())
    for (const auto& [id, group] : home.groups)
      if (!endsSomewhere(home, id))
        refuse(describe("group", id.value, group->name), "in a group that is inside it");
  if (!changed.walls.empty()) {
    if (const WallId twice = doubleWall(home))
      refuse(describe("wall", twice.value, ""), "lies exactly on another");
    for (const auto& [id, wall] : home.walls)
      if (wall->neighbourAtStart == id || wall->neighbourAtEnd == id)
        refuse(describe("wall", id.value, ""), "joined to itself");
  }
  requireFrame(home);
}

}  // namespace idap
