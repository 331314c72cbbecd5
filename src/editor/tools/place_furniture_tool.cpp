#include "editor/tools/place_furniture_tool.h"

#include <algorithm>
#include <cmath>

#include "editor/snap.h"
#include "editor/tools/drawn_point.h"
#include "editor/tools/place_tool.h"
#include "editor/tools/placing_tool.h"
#include "editor/tools/side_fields.h"
#include "editor/tools/unseen.h"
#include "model/edits/piece_edits.h"

namespace idap {

namespace {

constexpr double kLeastReach = 0.05, kMostReach = 0.4;  // m that a piece jumps to a wall, whatever the zoom
constexpr double kReachPixels = 14;

const ToolInfo kInfo{"place",
                     QT_TRANSLATE_NOOP("idap", "Place"),
                     QT_TRANSLATE_NOOP("idap", "Put a piece of the catalog into the home"),
                     QT_TRANSLATE_NOOP("idap", "Click where the piece is to stand, or type its distances"),
                     "",
                     {{"R", QT_TRANSLATE_NOOP("idap", "turn by 90°")},
                      {"0-9", QT_TRANSLATE_NOOP("idap", "type a distance")},
                      {"Tab", QT_TRANSLATE_NOOP("idap", "the next distance")},
                      {"Enter", QT_TRANSLATE_NOOP("idap", "place it")},
                      {"Alt", QT_TRANSLATE_NOOP("idap", "no snapping")},
                      {"Esc", QT_TRANSLATE_NOOP("idap", "stop")}}};

class PlaceFurnitureTool : public PlacingTool {
 public:
  PlaceFurnitureTool(CatalogPiecePtr piece, bool once) : PlacingTool(once), catalogPiece_(std::move(piece)) {}

  const ToolInfo& info() const override { return kInfo; }

  void begin(Editor& editor) override { makeReady(editor); }

  // Half done is the piece in the air; Escape therefore puts the tool away.
  bool cancel(Editor& editor) override {
    const bool typed = sides_.typing();
    drop(editor);
    return typed;
  }

  Response key(Editor& editor, const KeyEvent& event) override {
    if (preview_) {
      switch (sides_.key(event, editor.settings().unit)) {
        case TypedFields::Answer::Changed:
          show(editor);
          return {};
        case TypedFields::Answer::Apply:
          return place(editor);
        case TypedFields::Answer::Wrong:
          return {};
        case TypedFields::Answer::Unused:
          break;
      }
      if (event.key == Key::Enter) return place(editor);
    }
    if (event.key == Key::Character && !event.modifiers.control && !event.modifiers.alt &&
        (event.text == "r" || event.text == "R")) {
      angle_ = std::remainder(angle_ + (event.modifiers.shift ? -kPi / 2 : kPi / 2), 2 * kPi);
      turned_ = true;
      if (preview_) follow(editor, editor.lastPointer());
      return {};
    }
    return {.used = false};
  }

  Overlay overlay(const Editor&, Plane plane, double) const override {
    Overlay overlay;
    if (!preview_ || plane != plane_) return overlay;
    if (!sides_.typing()) overlay.guides = snapped_.guides;
    sides_.into(overlay, pointer_);
    if (snapped_.stacked) overlay.note = QT_TRANSLATE_NOOP("idap", "Stands on top");
    return overlay;
  }

  Cursor cursor(const Editor&, Plane) const override { return Cursor::Move; }

 private:
  void makeReady(const Editor& editor) {
    piece_ = readyFurniture(editor, *catalogPiece_, {});
    height_ = piece_.position.z;
  }

  Elements ignored() const {
    Elements elements;
    if (preview_) elements.furniture.push_back(preview_);
    return elements;
  }

  void follow(Editor& editor, const PointerEvent& event) override {
    if (sides_.typing()) return;  // it stays where the typed distances put it
    pointer_ = event.at;
    if (!preview_ || event.plane != plane_) {
      plane_ = event.plane;
      unseen_ = unseenCoordinate(editor, plane_, event.at);
    }
    if (piece_.level != editor.level()) makeReady(editor);  // another ceiling
    piece_.angle = angle_;
    if (plane_ == Plane::XY) {
      piece_.position = {event.at.x, event.at.y, height_};
    } else {
      // The pointer holds it by its middle, and no lower than the floor.
      const Vec3 at = inSpace(plane_, event.at, unseen_);
      piece_.position = {at.x, at.y, std::max(0.0, at.z - editor.elevation() - piece_.size.z / 2)};
    }
    PieceSnapRequest request;
    request.plane = plane_;
    request.piece = piece_;
    request.tolerance = std::clamp(kReachPixels * event.pixel, kLeastReach, kMostReach);
    request.hangs = catalogPiece_->ceilingMounted || catalogPiece_->elevation > 0;
    request.mayStack = !request.hangs;
    request.mayTurn =
        !turned_ && !catalogPiece_->ceilingMounted && catalogPiece_->kind != PieceKind::Staircase;
    request.ignored = ignored();
    snapped_ = snapPiece(editor, request, event.modifiers.alt);
    piece_.position = snapped_.position;
    piece_.angle = snapped_.angle;
    const Vec3 middle = piece_.position + Vec3{0, 0, piece_.size.z / 2 + editor.elevation()};
    sides_.show(clearances(editor, plane_, piece_, request.ignored), project(plane_, middle));
    show(editor);
  }

  void show(Editor& editor) {
    Furniture shown = piece_;
    const Vec3 by = inWorld(plane_, sides_.shift());
    shown.position += by;
    if (!editor.document().inTransaction()) editor.document().begin(addingName(*catalogPiece_));
    editor.preview([&](const Home& home) {
      FurnitureEdit edit = addFurniture(home, shown);
      preview_ = edit.furniture;
      return std::move(edit.home);
    });
  }

  Response place(Editor& editor) override {
    if (!preview_) return {};
    const FurnitureId id = preview_;
    preview_ = {};
    sides_.clear();
    editor.document().commit();
    editor.select(only(id));
    return {.finished = once_};
  }

  void drop(Editor& editor) override {
    if (preview_) editor.document().cancel();
    preview_ = {};
    sides_.clear();
    snapped_ = {};
  }

  CatalogPiecePtr catalogPiece_;
  Furniture piece_;
  double height_ = 0;  // m above the level, where it is put in the plan
  double angle_ = 0;
  bool turned_ = false;  // by the user: walls turn it no more
  Plane plane_ = Plane::XY;
  Vec2 pointer_;
  double unseen_ = 0;
  SnappedPiece snapped_;
  SideFields sides_;
  FurnitureId preview_;  // none: not in the air
};

}  // namespace

const char* addingName(const CatalogPiece& piece) {
  switch (piece.kind) {
    case PieceKind::Lamp:
      return QT_TRANSLATE_NOOP("idap", "Add lamp");
    case PieceKind::Staircase:
      return QT_TRANSLATE_NOOP("idap", "Add stairs");
    default:
      return QT_TRANSLATE_NOOP("idap", "Add furniture");
  }
}

std::unique_ptr<Tool> makePlaceFurnitureTool(CatalogPiecePtr piece, bool once) {
  return std::make_unique<PlaceFurnitureTool>(std::move(piece), once);
}

}  // namespace idap
