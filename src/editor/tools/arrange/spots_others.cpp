// Places by what stands in the room already.
#include <algorithm>
#include <cmath>

#include "editor/tools/arrange/spots.h"

namespace idap {

namespace {

Vec2 middleOf(const Piece& piece) { return {piece.position.x, piece.position.y}; }

// A place given in another piece's own axes.
Spot beside(const RoomSpace::Standing& other, Vec2 local, double turn, double z, double merit) {
  Spot spot;
  spot.middle = middleOf(*other.piece) + rotated(local, other.piece->angle);
  spot.angle = std::remainder(other.piece->angle + turn, 2 * kPi);
  spot.z = z;
  spot.merit = merit;
  return spot;
}

void besideBed(std::vector<Spot>& spots, const RoomSpace::Standing& bed, const Furniture& piece) {
  constexpr double kGap = 0.03;  // m, for the bedding
  const double x = (bed.piece->size.x + piece.size.x) / 2 + kGap, y = (bed.piece->size.y - piece.size.y) / 2;
  spots.push_back(beside(bed, {-x, y}, 0, piece.position.z, 0.01));
  spots.push_back(beside(bed, {x, y}, 0, piece.position.z, 0));
}

void onTop(std::vector<Spot>& spots, const RoomSpace::Standing& support, const Furniture& piece,
           const std::string& words) {
  const Furniture& table = *support.piece;
  const double top = topOf(table, support.manner, support.words);
  if (top <= 0 || piece.size.x > table.size.x * 1.3 || piece.size.y > table.size.y * 1.1) return;
  double merit = 0;
  const struct {
    const char *thing, *place;
  } kPairs[] = {{"bedside", "night nightstand bedside"},
                {"desk laptop monitor computer", "desk"},
                {"tv television", "bench media sideboard dresser"},
                {"kitchen microwave toaster kettle", "kitchen"},
                {"bowl tulip daisies candle", "dining table"},
                {"vase", "sideboard table dresser"}};
  for (const auto& pair : kPairs)
    if (says(words, pair.thing) && says(support.words, pair.place)) merit += 1.5;
  // A shade at eye height belongs on something low.
  merit -= 0.3 * std::abs(table.position.z + top - 0.65);
  const double z = table.position.z + top;
  const double x = std::max(0.0, (table.size.x - piece.size.x) / 2 - 0.03);
  const double y = std::max(0.0, (table.size.y - piece.size.y) / 2 - 0.03);
  const auto add = [&](Vec2 local, double worse) {
    Spot spot = beside(support, local, 0, z, merit - worse);
    spot.on = support.id;
    spots.push_back(spot);
  };
  // Screens stand back, what hands are on lies in front, and a lamp lights from the side.
  double bestX = 0, bestY = 0;
  if (says(words, "laptop")) bestY = -0.5;
  if (says(words, "monitor")) bestY = 0.8;
  if (says(words, "lamp") && table.size.x > 0.8) bestX = -1, bestY = 1;
  for (const double u : {0.0, -1.0, 1.0, -0.5, 0.5})
    for (const double v : {0.0, -0.5, 0.8, 1.0, -1.0})
      add({u * x, v * y}, 0.05 * std::abs(u - bestX) + 0.06 * std::abs(v - bestY));
}

// On the wall above what it belongs to, in the middle or flush with a side.
void above(std::vector<Spot>& spots, const RoomSpace& room, const RoomSpace::Standing& other,
           const Furniture& piece, const std::string& words) {
  const Vec2 behind =
      middleOf(*other.piece) + rotated(Vec2{0, other.piece->size.y / 2 + 0.03}, other.piece->angle);
  if (contains(room.area, behind)) return;  // no wall there
  const struct {
    const char *thing, *place;
    double merit;
  } kPairs[] = {{"hood", "hob stove cooker", 3},
                {"mirror", "washbasin basin vanity console dresser dressing chest", 1.5},
                {"kitchen", "sink base dishwasher", 1},
                {"tv television", "bench media sideboard", 1.5},
                {"picture painting frame art", "sofa bed sideboard", 0.6}};
  double merit = 0;
  for (const auto& pair : kPairs)
    if (says(words, pair.thing) && says(other.words, pair.place)) merit = std::max(merit, pair.merit);
  if (merit <= 0 || other.piece->position.z > piece.position.z) return;
  const double y = (other.piece->size.y - piece.size.y) / 2;
  const double flush = std::abs(other.piece->size.x - piece.size.x) / 2;
  spots.push_back(beside(other, {0, y}, 0, piece.position.z, merit));
  for (const double x : {-flush, flush})
    spots.push_back(beside(other, {x, y}, 0, piece.position.z, merit - 0.1));
}

void atTable(std::vector<Spot>& spots, const RoomSpace::Standing& at, const Furniture& piece,
             const std::string& words) {
  const Furniture& table = *at.piece;
  const Manner manner = at.manner;
  const bool stool = piece.size.z > 0.65 && piece.size.y < 0.5 && says(words, "bar");
  if (stool != (table.size.z > 0.85 && manner == Manner::Table)) return;
  const double tuck = 0.4 * piece.size.y;  // pushed under so far
  const double front = (table.size.y + piece.size.y) / 2 - tuck;
  // At the ends half as far, clear of the chairs at the corners.
  const double end = (table.size.x + piece.size.y - tuck) / 2;
  const auto add = [&](Vec2 local, double turn, double merit) {
    Spot spot = beside(at, local, turn, piece.position.z, merit);
    spot.on = at.id;
    spots.push_back(spot);
  };
  if (manner == Manner::Desk) return add({0, -front}, kPi, 1);
  const int seats = std::max(1, static_cast<int>((table.size.x - 0.05) / 0.6));
  for (int i = 0; i < seats; ++i) {
    const double x = table.size.x * ((i + 0.5) / seats - 0.5);
    add({x, -front}, kPi, 0.5 - 0.02 * i);
    add({x, front}, 0, 0.49 - 0.02 * i);
  }
  add({-end, 0}, kPi / 2, 0.2);
  add({end, 0}, -kPi / 2, 0.19);
}

void beforeSofa(std::vector<Spot>& spots, const RoomSpace::Standing& sofa, const Furniture& piece) {
  if (sofa.piece->size.x < 1.2) return;  // an armchair
  for (const double gap : {0.4, 0.5, 0.3, 0.65})
    spots.push_back(beside(sofa, {0, -(sofa.piece->size.y + piece.size.y) / 2 - gap}, 0, piece.position.z,
                           1 - std::abs(gap - 0.4)));
}

void atWindow(std::vector<Spot>& spots, const RoomSpace& room, const Furniture& piece) {
  for (const RoomSpace::Hole& hole : room.openings) {
    const Opening& window = *hole.opening;
    if (window.kind != OpeningKind::Window) continue;
    for (const double turn : {0.0, kPi}) {
      const Vec2 front = rotated(Vec2{0, -1}, window.angle + turn);
      const Vec2 middle = middleOf(window);
      // The inner face of the wall is where the room begins.
      double face = 0;
      while (face < 1 && !contains(room.area, middle + front * (face + 0.005))) face += 0.01;
      if (face >= 1) continue;
      Spot spot;
      spot.middle = middle + front * (face + 0.01 + piece.size.y / 2);
      spot.angle = std::remainder(window.angle + turn, 2 * kPi);
      spot.z = piece.position.z;
      spot.merit = 1 - std::abs(piece.size.x - window.size.x) / 4;
      spots.push_back(spot);
      break;
    }
  }
}

}  // namespace

std::vector<Spot> spotsByOthers(const RoomSpace& room, const Furniture& piece, const CatalogPiece& catalog,
                                Manner manner) {
  const std::string words = wordsOf(catalog);
  std::vector<Spot> spots;
  if (manner == Manner::AtWindow) atWindow(spots, room, piece);
  for (const RoomSpace::Standing& other : room.furniture) {
    const Manner its = other.manner;
    if (manner == Manner::BesideBed && its == Manner::Bed) besideBed(spots, other, piece);
    if (manner == Manner::OnWall) above(spots, room, other, piece, words);
    if (manner == Manner::OnTop) onTop(spots, other, piece, words);
    if (manner == Manner::Seat && (its == Manner::Table || its == Manner::Desk))
      atTable(spots, other, piece, words);
    if (manner == Manner::LowTable && its == Manner::Sofa) beforeSofa(spots, other, piece);
  }
  return spots;
}

}  // namespace idap
