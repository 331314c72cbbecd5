// Puts a piece of the catalog where people would: looks at every place that its manner suggests, drops those
// that are taken, and takes the best.
#include <algorithm>
#include <cmath>

#include "editor/tools/arrange/opening_spot.h"
#include "editor/tools/arrange/spots.h"
#include "editor/tools/place_furniture_tool.h"
#include "editor/tools/place_tool.h"
#include "model/edits/piece_edits.h"
#include "model/room_geometry.h"

namespace idap {

namespace {

constexpr double kFromSelected = 0.3;  // merit lost a metre away from what is selected,
constexpr double kFromPointer = 0.05;  // or from where the pointer was
constexpr double kNoAccess = 1.2;      // merit lost where that is taken,
constexpr double kOnWay = 4;           // where it stands in a door's way,
constexpr double kOnWindow = 2;        // or covers a window

struct Search {
  const RoomSpace& room;
  const Furniture& piece;
  Manner manner;
  std::optional<Vec2> near;
  double perMetre;     // merit lost a metre away from there
  FurnitureId chosen;  // the selected piece: things go onto it, beside it
  bool doorsMatter;
  std::string words;  // of the piece
};

// How good a place is with all that is in the room; none where it cannot be.
std::optional<double> judged(const Search& search, const Spot& spot) {
  const RoomSpace& room = search.room;
  const Furniture& piece = search.piece;
  const Corners corners = rectangle(spot.middle, {piece.size.x, piece.size.y}, spot.angle);
  const double low = spot.z, high = spot.z + piece.size.z;
  const bool on = search.manner == Manner::OnTop && spot.on;
  if (on) {
    if (!contains(room.area, spot.middle)) return std::nullopt;
  } else if (!room.holds(corners)) {
    return std::nullopt;
  }
  if (search.manner == Manner::AtWindow) {
    // What stands under the window is behind the curtain, or is moved; another curtain is not.
    for (const RoomSpace::Standing& other : room.furniture)
      if (other.manner == Manner::AtWindow && overlaps(corners, other.corners)) return std::nullopt;
  } else if (on ? !room.freeOnTop(corners, low, high, spot.on)
                : search.manner != Manner::Floor && !room.free(corners, low, high, spot.on))
    return std::nullopt;
  double merit = spot.merit;
  if (!on && search.manner != Manner::Floor && search.manner != Manner::AtWindow) {
    if (room.blocksWay(corners, low, high)) {
      if (search.doorsMatter) return std::nullopt;
      merit -= room.blocksDoorstep(corners, low, high) ? 2 * kOnWay : kOnWay;
    }
    if (room.coversWindow(corners, low, high)) {
      if (search.manner == Manner::OnWall) return std::nullopt;
      merit -= kOnWindow;
    }
    // Flames under curtains; hands in water with a view.
    if (says(search.words, "hob stove cooker") && room.coversWindow(corners, 0, 1.6)) merit -= 1;
    if (says(search.words, "sink") && room.coversWindow(corners, 0.95, 1.6))
      merit += 0.7 + (high > 1 ? kOnWindow : 0);
  }
  const bool used = search.manner == Manner::Bed || search.manner == Manner::Sofa ||
                    search.manner == Manner::Screen || search.manner == Manner::Desk ||
                    search.manner == Manner::Storage;
  if (used) {
    const Corners before = placeBefore(spot.middle, piece.size, spot.angle);
    if (!room.holds(before) || !room.free(before, 0.1, 1.5)) merit -= kNoAccess;
    // Nor may it stand where another one is to be used from.
    for (const RoomSpace::Standing& other : room.furniture)
      if (other.before && overlaps(corners, *other.before)) merit -= kNoAccess;
  }
  if (search.manner == Manner::Screen || search.manner == Manner::Sofa) {
    // A sofa and what is watched from it look at each other.
    const Manner partner = search.manner == Manner::Screen ? Manner::Sofa : Manner::Screen;
    const Vec2 front = rotated(Vec2{0, -1}, spot.angle);
    for (const RoomSpace::Standing& other : room.furniture) {
      if (other.manner != partner || other.piece->size.x < 1) continue;
      const Vec2 by = Vec2{other.piece->position.x, other.piece->position.y} - spot.middle;
      const Vec2 its = rotated(Vec2{0, -1}, other.piece->angle);
      if (dot(front, its) < -0.9 && dot(by, front) > 1) merit += 1.5 - 0.5 * std::abs(cross(front, by));
    }
  }
  if (search.manner == Manner::Table) {
    // Chairs and people around it.
    for (const double margin : {0.35, 0.8}) {
      const Corners around =
          rectangle(spot.middle, {piece.size.x + 2 * margin, piece.size.y + 2 * margin}, spot.angle);
      if (!room.holds(around) || !room.free(around, 0.1, 1.5)) merit -= 0.7;
    }
  }
  if (search.near) {
    // All places at one table are as near.
    Vec2 at = spot.middle;
    for (const RoomSpace::Standing& other : room.furniture)
      if (spot.on && other.id == spot.on) at = {other.piece->position.x, other.piece->position.y};
    merit -= search.perMetre * length(at - *search.near);
  }
  if (search.chosen && spot.on == search.chosen) merit += 3;
  return merit;
}

std::optional<Spot> best(const Search& search, const std::vector<Spot>& spots) {
  std::optional<Spot> found;
  double most = 0;
  for (const Spot& spot : spots)
    if (const auto merit = judged(search, spot); merit && (!found || *merit > most + 1e-9)) {
      found = spot;
      most = *merit;
    }
  return found;
}

// Lamps at the ceiling: over a table, in the middle, or between those that hang there.
std::vector<Spot> spotsAtCeiling(const RoomSpace& room, const Furniture& piece) {
  std::vector<Spot> spots = spotsAllOver(room, piece);
  for (const RoomSpace::Standing& other : room.furniture) {
    if (piece.size.z < 0.5 || other.manner != Manner::Table) continue;
    Spot over;
    over.middle = {other.piece->position.x, other.piece->position.y};
    over.angle = other.piece->angle;
    over.z = piece.position.z;
    over.merit = 0.5;
    spots.push_back(over);
  }
  for (Spot& spot : spots) {
    spot.merit *= 0.5;
    for (const RoomSpace::Standing& other : room.furniture)
      if (other.piece->lamp && other.piece->position.z > 1.5)
        spot.merit -=
            std::max(0.0, 1.5 - length(Vec2{other.piece->position.x, other.piece->position.y} - spot.middle));
  }
  return spots;
}

std::optional<Spot> find(Search search, const CatalogPiece& catalog) {
  const RoomSpace& room = search.room;
  const Furniture& piece = search.piece;
  const auto more = [](std::vector<Spot> a, const std::vector<Spot>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  };
  std::vector<Spot> first;
  switch (search.manner) {
    case Manner::Ceiling:
      first = spotsAtCeiling(room, piece);
      break;
    case Manner::Floor:
    case Manner::Table:
      first = spotsAllOver(room, piece);
      break;
    case Manner::Corner:
      first = spotsInCorners(room, piece);
      break;
    case Manner::AtWindow:
    case Manner::OnTop:
    case Manner::BesideBed:
    case Manner::LowTable:
    case Manner::Seat:
      first = spotsByOthers(room, piece, catalog, search.manner);
      break;
    case Manner::OnWall:
      first = more(spotsByOthers(room, piece, catalog, search.manner),
                   spotsAlongWalls(room, piece, search.manner));
      break;
    default:
      first = spotsAlongWalls(room, piece, search.manner);
  }
  if (const auto spot = best(search, first)) return spot;
  // Not as it should be, then: along a wall, anywhere, at last before a door.
  Search second = search;
  if (search.manner == Manner::Seat || search.manner == Manner::OnTop || search.manner == Manner::BesideBed ||
      search.manner == Manner::LowTable)
    second.manner = Manner::Storage;
  for (const bool doors : {true, false}) {
    second.doorsMatter = doors;
    if (const auto spot =
            best(second, more(spotsAlongWalls(room, piece, second.manner), spotsInCorners(room, piece))))
      return spot;
    if (search.manner == Manner::OnWall) continue;
    if (const auto spot = best(second, spotsAllOver(room, piece))) return spot;
  }
  return std::nullopt;
}

bool placeOpening(Editor& editor, const CatalogPiece& piece, std::optional<Vec2> near) {
  const std::optional<Opening> opening = openingSpot(editor, readyOpening(editor, piece, {}), piece, near);
  if (!opening) {
    editor.say(editor.home().walls.empty()
                   ? Text(QT_TRANSLATE_NOOP("idap", "Doors and windows stand in walls: draw walls first"))
                   : Text(QT_TRANSLATE_NOOP("idap", "No wall has room left for it")),
               Editor::Severity::Warning);
    return false;
  }
  OpeningId id;
  const char* name = piece.kind == PieceKind::Door ? QT_TRANSLATE_NOOP("idap", "Add door")
                                                   : QT_TRANSLATE_NOOP("idap", "Add window");
  if (!editor.apply(name, [&](const Home& home) {
        OpeningEdit edit = addOpening(home, *opening);
        id = edit.opening;
        return std::move(edit.home);
      }))
    return false;
  editor.select(only(id));
  return true;
}

}  // namespace

bool placeAutomatically(Editor& editor, const CatalogPiece& piece, std::optional<Vec2> near) {
  if (editor.document().inTransaction()) editor.tool().cancel(editor);
  // Where the user is at work: the piece or the room that is selected. The pointer tells the room only: it
  // may have been anywhere on its way to the catalog.
  double perMetre = kFromPointer;
  if (const Box3 box = bounds(editor.home(), editor.selection()); !box.empty()) {
    near = Vec2{box.centre().x, box.centre().y};
    perMetre = kFromSelected;
  } else if (near) {
    const RoomSpace around = roomSpace(editor.home(), editor.level(), near);
    if (around.closed && !contains(around.area, *near)) near.reset();
  }
  if (piece.kind == PieceKind::Door || piece.kind == PieceKind::Window)
    return placeOpening(editor, piece, near);

  Furniture ready = readyFurniture(editor, piece, {});
  const RoomSpace room = roomSpace(editor.home(), editor.level(), near);
  FurnitureId chosen;
  if (const auto one = single(editor.selection()); one && std::holds_alternative<FurnitureId>(*one))
    chosen = std::get<FurnitureId>(*one);
  const std::optional<Spot> spot =
      find({room, ready, mannerOf(piece), near, perMetre, chosen, true, wordsOf(piece)}, piece);
  if (spot) {
    ready.position = {spot->middle.x, spot->middle.y, spot->z};
    ready.angle = std::abs(spot->angle) < 1e-12 ? 0 : spot->angle;
  } else {
    Room shape;
    shape.points = room.area;
    const Vec2 middle = near && contains(room.area, *near) ? *near : roomCentre(shape);
    ready.position = {middle.x, middle.y, ready.position.z};
    editor.say(QT_TRANSLATE_NOOP("idap", "There is no free place left in this room: move the piece yourself"),
               Editor::Severity::Note);
  }
  FurnitureId id;
  if (!editor.apply(addingName(piece), [&](const Home& home) {
        FurnitureEdit edit = addFurniture(home, ready);
        id = edit.furniture;
        return std::move(edit.home);
      }))
    return false;
  editor.select(only(id));
  return true;
}

}  // namespace idap
