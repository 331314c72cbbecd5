#include "model/assets.h"

#include <algorithm>

namespace idap {

namespace {

class Gatherer {
 public:
  void add(const std::optional<TextureRef>& texture) {
    if (texture) names_.insert(texture->asset);
  }
  void add(const Finish& finish) { add(finish.texture); }
  void add(const WallSide& side) {
    add(side.finish);
    if (side.baseboard) add(side.baseboard->finish);
  }
  void add(const Piece& piece) {
    add(piece.finish);
    for (const auto& [slot, finish] : piece.slotFinishes) add(finish);
    const std::string& model = piece.model.asset;
    if (model.empty()) return;
    names_.insert(model);
    if (const auto slash = model.rfind('/'); slash != std::string::npos)
      folders_.insert(model.substr(0, slash + 1));
  }
  void add(const std::string& name) { names_.insert(name); }

  bool wants(const std::string& name) const {
    if (names_.contains(name)) return true;
    for (auto slash = name.find('/'); slash != std::string::npos; slash = name.find('/', slash + 1)) {
      const std::string folder = name.substr(0, slash + 1);
      if (!folders_.contains(folder)) continue;
      // A model put straight into models/ brings the files there, not all other models' folders.
      const bool shared = folder.find('/') + 1 == folder.size();
      if (!shared || name.find('/', slash + 1) == std::string::npos) return true;
    }
    return false;
  }

 private:
  std::set<std::string> names_, folders_;
};

}  // namespace

std::set<std::string> assetsInUse(const Home& home, const std::vector<std::string>& available) {
  Gatherer gatherer;
  gatherer.add(home.environment.ground);
  gatherer.add(home.environment.skyTexture);
  for (const auto& [id, wall] : home.walls) {
    gatherer.add(wall->left);
    gatherer.add(wall->right);
    gatherer.add(wall->top);
  }
  for (const auto& [id, room] : home.rooms) {
    gatherer.add(room->floor);
    gatherer.add(room->ceiling);
  }
  for (const auto& [id, opening] : home.openings) gatherer.add(*opening);
  for (const auto& [id, piece] : home.furniture) gatherer.add(*piece);
  for (const auto& [id, picture] : home.pictures) gatherer.add(picture->asset);
  for (const auto& [level, background] : home.backgrounds) gatherer.add(background.asset);
  std::set<std::string> used;
  std::copy_if(available.begin(), available.end(), std::inserter(used, used.end()),
               [&gatherer](const std::string& name) { return gatherer.wants(name); });
  return used;
}

}  // namespace idap
