#include "model/edits/asset_merge.h"

#include <algorithm>
#include <map>
#include <set>

#include "model/assets.h"
#include "model/edits/arrange_edits.h"
#include "model/edits/table_edits.h"

namespace idap {

namespace {

std::vector<std::string> namesOf(const Assets& assets) {
  std::vector<std::string> names;
  for (const auto& [name, bytes] : assets) names.push_back(name);
  return names;
}

bool same(const SharedBytes& a, const SharedBytes& b) { return a == b || (a && b && *a == *b); }

// Files that belong together, a model with its textures, keep their names in one folder: "models/chair".
std::string folderOf(const std::string& name) {
  const auto first = name.find('/');
  if (first == std::string::npos) return {};
  const auto second = name.find('/', first + 1);
  return name.substr(0, second == std::string::npos ? first : second);
}

using Renaming = std::map<std::string, std::string>;  // from, to

// New names for the folders of files that differ from the home's of that name.
Renaming renaming(const Assets& there, const Assets& added) {
  std::set<std::string> clashing, folders;
  for (const auto& [name, bytes] : there) folders.insert(folderOf(name));
  for (const auto& [name, bytes] : added)
    if (const auto found = there.find(name); found != there.end() && !same(found->second, bytes))
      clashing.insert(folderOf(name));
  std::map<std::string, std::string> renamedFolder;
  for (const std::string& folder : clashing) {
    // What lies straight in "models" goes into a folder of its own below it.
    const bool top = folder.find('/') == std::string::npos;
    const std::string stem = folder.empty() ? "files/" : top ? folder + "/" : folder + "-";
    int number = 2;
    while (folders.contains(stem + std::to_string(number))) ++number;
    folders.insert(renamedFolder[folder] = stem + std::to_string(number));
  }
  Renaming names;
  for (const auto& [name, bytes] : added) {
    const std::string folder = folderOf(name);
    const auto found = renamedFolder.find(folder);
    if (found == renamedFolder.end()) continue;
    names[name] = found->second + "/" + name.substr(folder.empty() ? 0 : folder.size() + 1);
  }
  return names;
}

class Renamer {
 public:
  explicit Renamer(const Renaming& names) : names_(names) {}

  void operator()(std::string& name) const {
    if (const auto found = names_.find(name); found != names_.end()) name = found->second;
  }
  void operator()(Finish& finish) const {
    if (finish.texture) (*this)(finish.texture->asset);
  }
  void operator()(WallSide& side) const {
    (*this)(side.finish);
    if (side.baseboard) (*this)(side.baseboard->finish);
  }
  void operator()(Wall& wall) const {
    (*this)(wall.left);
    (*this)(wall.right);
    (*this)(wall.top);
  }
  void operator()(Room& room) const {
    (*this)(room.floor);
    (*this)(room.ceiling);
  }
  void operator()(Piece& piece) const {
    (*this)(piece.finish);
    for (auto& [slot, finish] : piece.slotFinishes) (*this)(finish);
    (*this)(piece.model.asset);
  }
  template <class IdType, class T>
  void operator()(Table<IdType, T>& table) const {
    changeWhere(
        table, [](const T&) { return true; }, [this](T& element) { (*this)(element); });
  }

 private:
  const Renaming& names_;
};

}  // namespace

Home withAssetsOf(Home& home, const Home& fragment) {
  Home part = withoutUnusedAssets(fragment);
  if (part.assets->empty()) return part;
  const Renaming names = renaming(*home.assets, *part.assets);
  Assets all = *home.assets;
  for (const auto& [name, bytes] : *part.assets) {
    const auto renamed = names.find(name);
    all.emplace(renamed == names.end() ? name : renamed->second, bytes);
  }
  if (all.size() != home.assets->size()) home.assets = std::make_shared<const Assets>(std::move(all));
  if (names.empty()) return part;
  const Renamer rename(names);
  rename(part.walls);
  rename(part.rooms);
  rename(part.openings);
  rename(part.furniture);
  return part;
}

Home withoutUnusedAssets(const Home& home) {
  if (home.assets->empty()) return home;
  const std::set<std::string> used = assetsInUse(home, namesOf(*home.assets));
  if (used.size() == home.assets->size()) return home;
  Home next = home;
  Assets kept = *home.assets;
  std::erase_if(kept, [&used](const auto& entry) { return !used.contains(entry.first); });
  next.assets = std::make_shared<const Assets>(std::move(kept));
  return next;
}

Home withoutNewUnusedAssets(const Home& before, Home home) {
  if (home.assets == before.assets) return home;
  const std::set<std::string> used = assetsInUse(home, namesOf(*home.assets));
  Assets kept = *home.assets;
  std::erase_if(kept, [&](const auto& entry) {
    return !used.contains(entry.first) && !before.assets->contains(entry.first);
  });
  home.assets =
      kept.size() == before.assets->size() ? before.assets : std::make_shared<const Assets>(std::move(kept));
  return home;
}

}  // namespace idap
