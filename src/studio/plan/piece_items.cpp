#include "studio/plan/piece_items.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "model/visibility.h"
#include "studio/plan/opening_shape.h"
#include "studio/plan/pictures.h"
#include "studio/plan/symbol_store.h"

namespace idap {

namespace {

// The extent along the line of sight, as nearness: from the outline on a plane that shows it.
std::pair<double, double> farAndNear(Plane plane, const Piece& piece, double elevation) {
  if (plane == Plane::XY) {
    if (piece.pitch == 0 && piece.roll == 0) return {piece.position.z, piece.position.z + piece.size.z};
    const Box2 box = bounds(outline(Plane::XZ, piece, elevation));
    return {box.min.y - elevation, box.max.y - elevation};
  }
  const Box2 box = bounds(outline(Plane::XY, piece, elevation));
  return plane == Plane::XZ ? std::pair(-box.max.y, -box.min.y) : std::pair(box.min.x, box.max.x);
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n"), last = text.find_last_not_of(" \t\r\n");
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

std::vector<Color> colorsOf(const Symbol& symbol, const Piece& piece, const Home& home, Pictures& pictures) {
  std::vector<Color> colors;
  for (const SymbolSlot& slot : symbol.slots) {
    std::optional<Color> color;
    for (const auto& [name, finish] : piece.slotFinishes)
      if (trimmed(name) == trimmed(slot.name)) color = pictures.colorOf(home, finish);
    if (!color) color = pictures.colorOf(home, piece.finish);
    colors.push_back(color.value_or(slot.color));
  }
  return colors;
}

}  // namespace

PieceItems::PieceItems(Plane plane, std::shared_ptr<const Catalog> catalog,
                       std::shared_ptr<SymbolStore> symbols)
    : plane_(plane), catalog_(std::move(catalog)), symbols_(std::move(symbols)) {}

void PieceItems::rebuild(const Home& home, LevelId level, Pictures& pictures) {
  level_ = level;
  waiting_ = 0;
  std::unordered_map<std::uint64_t, std::unique_ptr<PieceItem>> old;
  old.swap(byId_);
  for (const auto& [id, piece] : home.furniture) {
    // What is the same keeps its symbol.
    if (const auto at = old.find(id.value); at != old.end() && at->second->furniture == piece)
      byId_[id.value] = std::move(at->second);
    put(id.value, piece, nullptr, home, pictures);
  }
  for (const auto& [id, opening] : home.openings) put(id.value, nullptr, opening, home, pictures);
  sort();
}

void PieceItems::update(const HomeDiff& diff, const Home& home, Pictures& pictures) {
  if (!diff.levels.empty() || !diff.groups.empty()) {  // these decide on what is shown
    rebuild(home, level_, pictures);
    return;
  }
  if (diff.furniture.empty() && diff.openings.empty()) return;
  for (const auto* ids : {&diff.furniture.added, &diff.furniture.changed, &diff.furniture.removed})
    for (const FurnitureId id : *ids) put(id.value, home.furniture.shared(id), nullptr, home, pictures);
  for (const auto* ids : {&diff.openings.added, &diff.openings.changed, &diff.openings.removed})
    for (const OpeningId id : *ids) put(id.value, nullptr, home.openings.shared(id), home, pictures);
  sort();
}

void PieceItems::put(std::uint64_t id, std::shared_ptr<const Furniture> furniture,
                     std::shared_ptr<const Opening> opening, const Home& home, Pictures& pictures) {
  const Piece* piece = furniture ? static_cast<const Piece*>(furniture.get()) : opening.get();
  if (!piece || !(piece->level == level_) || !isShown(home, *piece)) {
    byId_.erase(id);
    return;
  }
  auto& item = byId_[id];
  if (!item) item = std::make_unique<PieceItem>();
  item->id = id;
  item->furniture = std::move(furniture);
  item->opening = std::move(opening);
  const double elevation = elevationOf(home, piece->level);
  item->outline = outline(plane_, *piece, elevation);
  item->box = idap::bounds(item->outline);
  if (item->opening && plane_ == Plane::XY) add(item->box, openingBox(home, *item->opening));
  std::tie(item->far, item->near) = farAndNear(plane_, *piece, elevation);
  // From above what reaches higher lies on top; from the side the section goes between middles.
  item->order = plane_ == Plane::XY ? item->near : (item->near + item->far) / 2;
  item->turn = plane_ == Plane::XY ? piece->angle : 0;
  item->place = project(plane_, piece->position + Vec3{0, 0, elevation});
  symbolOf(*item, home, pictures);
}

void PieceItems::symbolOf(PieceItem& item, const Home& home, Pictures& pictures) {
  if (item.opening && plane_ == Plane::XY) return;  // drawn by the signs of architects
  const Piece& piece = item.piece();
  SymbolKey key = symbolKey(piece, plane_, *home.assets, catalog_.get());
  if (key == item.key && item.exact) {
    item.colors = colorsOf(*item.symbol, piece, home, pictures);
    return;
  }
  // A symbol of another size of the same model serves until the new one is there; of another turn it does
  // not.
  if (!item.key.empty() && key.substr(0, key.find('\n')) != item.key.substr(0, item.key.find('\n')))
    item.symbol.reset();
  item.key = std::move(key);
  const SymbolPtr symbol = symbols_->get(item.key, home, catalog_, piece, plane_);
  item.exact = symbol != nullptr;
  if (symbol) item.symbol = symbol;
  if (!symbol) ++waiting_;
  if (item.symbol) item.colors = colorsOf(*item.symbol, piece, home, pictures);
}

void PieceItems::takeSymbols(const Home& home, Pictures& pictures, DirtyBoxes& dirty) {
  if (waiting_ == 0) return;
  waiting_ = 0;
  for (auto& [id, item] : byId_) {
    if (item->exact || item->key.empty()) continue;
    symbolOf(*item, home, pictures);
    if (item->exact) dirty.add(item->box);
  }
}

void PieceItems::takeColors(const Home& home, Pictures& pictures) {
  for (auto& [id, item] : byId_)
    if (item->symbol) item->colors = colorsOf(*item->symbol, item->piece(), home, pictures);
}

void PieceItems::completeSymbols(const Home& home, Pictures& pictures) {
  for (auto& [id, item] : byId_) {
    if (item->exact || item->key.empty()) continue;
    item->symbol = symbols_->make(item->key, home, catalog_, item->piece(), plane_);
    item->exact = true;
    item->colors = colorsOf(*item->symbol, item->piece(), home, pictures);
  }
}

const PieceItem* PieceItems::find(std::uint64_t id) const {
  const auto at = byId_.find(id);
  return at == byId_.end() ? nullptr : at->second.get();
}

Box2 PieceItems::bounds() const {
  Box2 all;
  for (const PieceItem* item : order_) idap::add(all, item->box);
  return all;
}

void PieceItems::sort() {
  order_.clear();
  order_.reserve(byId_.size());
  for (const auto& [id, item] : byId_) order_.push_back(item.get());
  std::sort(order_.begin(), order_.end(), [](const PieceItem* a, const PieceItem* b) {
    return a->order != b->order ? a->order < b->order : a->id < b->id;
  });
}

}  // namespace idap
