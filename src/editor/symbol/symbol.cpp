#include "editor/symbol/symbol.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "editor/symbol/area_tracing.h"
#include "editor/symbol/depth_raster.h"
#include "editor/symbol/seen_lines.h"
#include "editor/symbol/welded_mesh.h"

namespace idap {

namespace {

constexpr double kLongSide = 400;     // cells of the raster on the longer side
constexpr double kFinestCell = 5e-4;  // m
constexpr float kSloped = 0.8f;       // cosine: faces turned further away are drawn darker
constexpr std::size_t kMostPoints = 1600;
constexpr float kCoarse = 0.035f;  // of the longer side

// World axes as right, up and towards the eye.
Transform toPlane(Plane plane) {
  switch (plane) {
    case Plane::XZ:
      return {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}, {}};
    case Plane::YZ:
      return {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {}};
    default:
      return {};
  }
}

Transform toSymbol(const SurfaceModel& model, const Piece& piece, Plane plane) {
  Piece still = piece;
  still.position = {};
  if (plane == Plane::XY) still.angle = 0;
  Transform t = toPlane(plane) * placement(still);
  constexpr double kThinnest = 1e-4;
  if (model.unitBox)
    t = t * Transform::scaling({std::max(piece.size.x, kThinnest), std::max(piece.size.y, kThinnest),
                                std::max(piece.size.z, kThinnest)});
  return t;
}

SymbolRing coarsened(const std::vector<SymbolRing>& rings, float tolerance) {
  const auto extent = [](const SymbolRing& ring) {
    Vec2f low{1e30f, 1e30f}, high{-1e30f, -1e30f};
    for (const Vec2f p : ring) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return (high.x - low.x) * (high.y - low.y);
  };
  const auto largest =
      std::max_element(rings.begin(), rings.end(),
                       [&](const SymbolRing& a, const SymbolRing& b) { return extent(a) < extent(b); });
  return largest == rings.end() ? SymbolRing{} : simplifiedRing(*largest, tolerance);
}

}  // namespace

Symbol makeSymbol(const SurfaceModel& model, const Piece& piece, Plane plane) {
  Symbol symbol;
  symbol.size = {piece.size.x, piece.size.y};
  for (const SurfaceModel::Slot& slot : model.slots) {
    const Material& m = slot.material;
    SymbolSlot& to = symbol.slots.emplace_back();
    to.name = slot.name;
    to.color = m.color;
    if (m.texture) to.picture = m.texture->bytes;
    to.clear = float(std::clamp(std::max(m.transmission, 1 - m.opacity), 0.0, 1.0));
  }
  const WeldedMesh mesh = weld(model.mesh, toFloat(toSymbol(model, piece, plane)));
  if (mesh.triangles.empty()) return symbol;
  const Box3f box = mesh.bounds();
  const Vec3f size = box.size();
  const double longest = std::max(double(size.x), double(size.y));
  if (!std::isfinite(longest) || longest <= 0) return symbol;
  DepthRaster raster(box, float(std::max(longest / kLongSide, kFinestCell)));
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    // A label for each slot, and another for where it is turned away.
    const std::uint32_t label = 2 * mesh.slots[t] + (std::abs(mesh.normals[t].z) < kSloped ? 1 : 0);
    raster.fill(mesh.positions[corners[0]], mesh.positions[corners[1]], mesh.positions[corners[2]],
                label + 1);
  }
  symbol.outline = traceOutline(raster);
  symbol.coarse = coarsened(symbol.outline, float(longest) * kCoarse);
  for (TracedArea& area : traceAreas(raster)) {
    const std::uint32_t label = area.label - 1;
    symbol.areas.push_back(
        {std::min<std::uint32_t>(label / 2, std::uint32_t(std::max<std::size_t>(model.slots.size(), 1) - 1)),
         label % 2 == 1, std::move(area.rings)});
  }
  symbol.lines = seenLines(mesh, raster);
  std::size_t points = 0, kept = 0;
  while (kept < symbol.lines.size() && points < kMostPoints) points += symbol.lines[kept++].points.size();
  symbol.lines.resize(kept);
  return symbol;
}

SymbolKey symbolKey(const Piece& piece, Plane plane, const Assets& assets, const Catalog* catalog) {
  const ModelRef& ref = piece.model;
  char text[256];
  SymbolKey key;
  const void* source = catalog;
  if (!ref.asset.empty()) {
    const auto file = assets.find(ref.asset);
    source = file == assets.end() ? nullptr : file->second.get();
    key = ref.asset;
  } else {
    key = ref.catalogId;
    for (const auto& [name, value] : ref.parameters) {
      std::snprintf(text, sizeof text, " %s=%.5g", name.c_str(), value);
      key += text;
    }
  }
  const auto turn = [](double angle) { return std::lround(std::remainder(angle, 2 * kPi) * 500); };
  const bool plan = plane == Plane::XY;
  // The first line: what a symbol of another size has in common with this one, so that it can stand in.
  std::snprintf(text, sizeof text, " %p %d %d %ld %ld %ld", source, int(plane), piece.mirrored ? 1 : 0,
                plan ? 0L : turn(piece.angle), turn(piece.pitch), turn(piece.roll));
  key += text;
  const auto& r = ref.rotation;
  if (!ref.asset.empty() && !(r == ModelRef{}.rotation)) {
    for (const Vec3& axis : r) {
      std::snprintf(text, sizeof text, " %.3f %.3f %.3f", axis.x, axis.y, axis.z);
      key += text;
    }
  }
  std::snprintf(text, sizeof text, "\n%ld %ld %ld", std::lround(piece.size.x * 1000),
                std::lround(piece.size.y * 1000), std::lround(piece.size.z * 1000));
  return key + text;
}

}  // namespace idap
