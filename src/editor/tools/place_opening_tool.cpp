#include "editor/tools/place_opening_tool.h"

#include <algorithm>
#include <cmath>

#include "editor/snap.h"
#include "editor/tools/placing_tool.h"
#include "editor/tools/typed_fields.h"
#include "editor/tools/unseen.h"
#include "editor/tools/wall_room.h"
#include "model/edits/piece_edits.h"
#include "model/wall_path.h"

namespace idap {

namespace {

constexpr double kReach = 0.4;  // m from a wall at which an opening jumps into it, at least
constexpr double kReachPixels = 40;
constexpr double kSillPixels = 10;                         // from the usual sill at which it snaps to it
constexpr std::size_t kBefore = 0, kAfter = 1, kSill = 2;  // fields: along the wall, and the height

double angleOf(Vec2 direction) { return std::atan2(direction.y, direction.x); }

class PlaceOpeningTool : public PlacingTool {
 public:
  explicit PlaceOpeningTool(OpeningToPlace what) : PlacingTool(what.once), what_(std::move(what)) {}

  const ToolInfo& info() const override { return *what_.info; }

  void begin(Editor& editor) override {
    ready_ = what_.make(editor);
    if (!ready_)
      editor.say(QT_TRANSLATE_NOOP("idap", "The catalog has no piece of this kind"),
                 Editor::Severity::Warning);
  }

  bool cancel(Editor& editor) override {
    const bool typed = fields_.typing();
    drop(editor);
    return typed;
  }

  Response pointer(Editor& editor, const PointerEvent& event) override {
    if (!ready_) return {.used = false, .finished = true};
    return PlacingTool::pointer(editor, event);
  }

  Response key(Editor& editor, const KeyEvent& event) override {
    if (preview_ && opening_.wall) {
      switch (fields_.key(event, editor.settings().unit)) {
        case TypedFields::Answer::Changed:
          // Both ends cannot hold: the one typed last does.
          if (fields_.active() != kSill && fields_.value(fields_.active()))
            fields_.clear(fields_.active() == kBefore ? kAfter : kBefore);
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
      way_ = (way_ + (event.modifiers.shift ? 3 : 1)) % 4;
      if (preview_) follow(editor, editor.lastPointer());
      return {};
    }
    return {.used = false};
  }

  Overlay overlay(const Editor& editor, Plane plane, double) const override {
    Overlay overlay;
    if (!preview_ || plane != plane_) return overlay;
    if (!opening_.wall) {
      overlay.note = QT_TRANSLATE_NOOP("idap", "Move it to a wall");
      return overlay;
    }
    const Opening shown = placed(editor.home());
    const Wall* wall = editor.home().walls.find(shown.wall);
    if (!wall) return overlay;
    const WallPath path(*wall);
    const double middle = path.nearest({shown.position.x, shown.position.y}), half = shown.size.x / 2;
    const double z = editor.elevation() + shown.position.z;
    const auto point = [&](double distance) {
      const Vec2 p = path.point(distance);
      return project(plane, {p.x, p.y, z});
    };
    overlay.measures.push_back(
        {point(free_.from), point(middle - half), fields_.typing() && fields_.active() == kBefore});
    overlay.measures.push_back(
        {point(middle + half), point(free_.to), fields_.typing() && fields_.active() == kAfter});
    if (plane != Plane::XY && shown.position.z > 0) {
      const Vec2 low = point(middle);
      overlay.measures.push_back(
          {{low.x, editor.elevation()}, low, fields_.typing() && fields_.active() == kSill});
    }
    fields_.into(overlay, pointer_);
    return overlay;
  }

  Cursor cursor(const Editor&, Plane) const override { return Cursor::Move; }

 private:
  void follow(Editor& editor, const PointerEvent& event) override {
    if (fields_.typing()) return;  // it stays where the typed distances put it
    pointer_ = event.at;
    plane_ = event.plane;
    const Home& home = editor.home();
    Opening wanted = *ready_;
    wanted.level = editor.level();
    Elements ignored;
    if (preview_) ignored.openings.push_back(preview_);
    Vec2 at = event.at;
    double reach = std::max(kReach, kReachPixels * event.pixel);
    if (plane_ != Plane::XY) {
      const WallId host = hostSeen(editor, event.at.x);
      const Wall* wall = home.walls.find(host);
      if (!wall) {
        wanted.position = inSpace(plane_, event.at, unseenCoordinate(editor, plane_, event.at));
        wanted.position.z = ready_->position.z;
        opening_ = wanted;
        show(editor);
        return;
      }
      at = pointSeen(*wall, event.at.x);
      reach = wall->thickness;
      wanted.wall = host;
      wanted.position.z = sill(editor, *wall, event);
    } else {
      wanted.position = {at.x, at.y, wanted.position.z};
      wanted.wall = host_;
    }
    std::optional<Opening> found = snapOpening(editor, wanted, at, reach, ignored);
    if (found && way_ >= 2) {
      // Opened to the other side: as if the pointer were there.
      if (const Wall* wall = home.walls.find(found->wall)) {
        const WallPath path(*wall);
        const double distance = path.nearest(at);
        wanted.wall = found->wall;
        const Vec2 side = perpendicular(path.direction(distance));
        const Vec2 foot = path.point(distance), by = at - foot;
        // On the centre line itself the left counts as the pointer's side.
        const Vec2 mirrored = dot(by, side) > 0 ? foot - by : foot + side * std::max(length(by), 1e-3);
        found = snapOpening(editor, wanted, mirrored, reach, ignored);
      }
    }
    opening_ = found.value_or(wanted);
    if (!found) opening_.wall = {};
    if (way_ % 2 == 1) opening_.mirrored = !opening_.mirrored;
    if (opening_.wall) host_ = opening_.wall;
    measure(home);
    show(editor);
  }

  // Where an upright plane shows no depth: the wall it was in last, if it is seen across the plane, else the
  // nearest to the eye that runs along the plane there.
  WallId hostSeen(const Editor& editor, double across) const {
    const Home& home = editor.home();
    const auto seen = [&](const Wall& wall) {
      const double a = project(plane_, {wall.start.x, wall.start.y, 0}).x;
      const double b = project(plane_, {wall.end.x, wall.end.y, 0}).x;
      return std::abs(b - a) > 0.5 * length(wall.end - wall.start) && std::min(a, b) <= across &&
             across <= std::max(a, b);
    };
    WallId selected;
    if (const auto one = single(editor.selection()); one && std::holds_alternative<WallId>(*one))
      selected = std::get<WallId>(*one);
    for (const WallId id : {host_, selected})
      if (const Wall* wall = home.walls.find(id); wall && wall->level == editor.level() && seen(*wall))
        return id;
    WallId best;
    double nearest = -std::numeric_limits<double>::infinity();
    for (const auto& [id, wall] : home.walls) {
      if (wall->level != editor.level() || !seen(*wall)) continue;
      const Vec2 at = pointSeen(*wall, across);
      if (const double near = nearness(plane_, {at.x, at.y, 0}); near > nearest) {
        nearest = near;
        best = id;
      }
    }
    return best;
  }

  // The point of a wall's centre line that is seen at a place across the plane.
  Vec2 pointSeen(const Wall& wall, double across) const {
    const double a = project(plane_, {wall.start.x, wall.start.y, 0}).x;
    const double b = project(plane_, {wall.end.x, wall.end.y, 0}).x;
    const double t = std::abs(b - a) < 1e-9 ? 0.5 : std::clamp((across - a) / (b - a), 0.0, 1.0);
    const WallPath path(wall);
    return path.point(path.nearest(wall.start + (wall.end - wall.start) * t));
  }

  double sill(const Editor& editor, const Wall& wall, const PointerEvent& event) const {
    const double room = std::max(0.0, std::min(wall.heightAtStart, wall.heightAtEnd) - ready_->size.z);
    const double wanted = std::clamp(event.at.y - editor.elevation() - ready_->size.z / 2, 0.0, room);
    if (event.modifiers.alt || !editor.settings().snapping) return wanted;
    const double usual = std::min(ready_->position.z, room);
    // Doors stand on the floor whatever the pointer does; windows near their usual sill take it.
    if (ready_->kind != OpeningKind::Window && usual == 0) return 0;
    return std::abs(wanted - usual) < std::max(0.05, kSillPixels * event.pixel) ? usual : wanted;
  }

  // The free stretch of the wall around the opening, and the lengths left of it.
  void measure(const Home& home) {
    const Wall* wall = home.walls.find(opening_.wall);
    if (!wall) return;
    const WallPath path(*wall);
    distance_ = path.nearest({opening_.position.x, opening_.position.y});
    free_ = {0, path.length()};
    for (const Stretch& stretch : freeStretches(home, opening_.wall, opening_.position.z,
                                                opening_.position.z + opening_.size.z, preview_))
      if (stretch.from <= distance_ && distance_ <= stretch.to) free_ = stretch;
    const Vec2 direction = path.direction(distance_);
    const double across = plane_ == Plane::YZ ? direction.y : direction.x;
    const bool upright = plane_ == Plane::XY && std::abs(direction.x) < std::abs(direction.y);
    const bool forward = upright ? direction.y > 0 : across > 0;
    const char* first = upright ? QT_TRANSLATE_NOOP("idap", "Bottom") : QT_TRANSLATE_NOOP("idap", "Left");
    const char* second = upright ? QT_TRANSLATE_NOOP("idap", "Top") : QT_TRANSLATE_NOOP("idap", "Right");
    if (fields_.fields().empty() || fields_.fields()[kBefore].label != (forward ? first : second))
      fields_.define({{forward ? first : second, Field::Kind::Length},
                      {forward ? second : first, Field::Kind::Length},
                      {QT_TRANSLATE_NOOP("idap", "Sill height"), Field::Kind::Length}});
    fields_.show(kBefore, distance_ - opening_.size.x / 2 - free_.from);
    fields_.show(kAfter, free_.to - distance_ - opening_.size.x / 2);
    fields_.show(kSill, opening_.position.z);
  }

  // With what was typed.
  Opening placed(const Home& home) const {
    Opening shown = opening_;
    const Wall* wall = home.walls.find(opening_.wall);
    if (!wall) return shown;
    if (const auto typed = fields_.value(kSill)) shown.position.z = std::max(0.0, *typed);
    const double half = opening_.size.x / 2;
    double distance = distance_;
    if (const auto typed = fields_.value(kBefore)) distance = free_.from + *typed + half;
    if (const auto typed = fields_.value(kAfter)) distance = free_.to - *typed - half;
    if (distance == distance_) return shown;
    const WallPath path(*wall);
    if (path.length() > 2 * half) distance = std::clamp(distance, half, path.length() - half);
    const double turn = angleOf(path.direction(distance)) - angleOf(path.direction(distance_));
    const Vec2 was = path.point(distance_), is = path.point(distance);
    const Vec2 beside = rotated(Vec2{shown.position.x, shown.position.y} - was, turn);
    shown.position = {is.x + beside.x, is.y + beside.y, shown.position.z};
    shown.angle = std::remainder(shown.angle + turn, 2 * kPi);
    return shown;
  }

  void show(Editor& editor) {
    if (!editor.document().inTransaction()) editor.document().begin(what_.editName);
    editor.preview([&](const Home& home) {
      OpeningEdit edit = addOpening(home, placed(home));
      preview_ = edit.opening;
      return std::move(edit.home);
    });
  }

  Response place(Editor& editor) override {
    if (!preview_) return {};
    if (!opening_.wall) {
      editor.say(QT_TRANSLATE_NOOP("idap", "Doors and windows stand in walls: click on or beside one"),
                 Editor::Severity::Warning);
      if (once_) drop(editor);
      return {.finished = once_};
    }
    const OpeningId id = preview_;
    preview_ = {};
    fields_.define({});
    editor.document().commit();
    editor.select(only(id));
    return {.finished = once_};
  }

  void drop(Editor& editor) override {
    if (preview_) editor.document().cancel();
    preview_ = {};
    fields_.define({});
  }

  OpeningToPlace what_;
  std::optional<Opening> ready_;
  Opening opening_;  // where the pointer wants it
  WallId host_;      // the wall it was in last
  int way_ = 0;      // 1: hinges at the other end; 2: to the other side; 3: both
  Plane plane_ = Plane::XY;
  Vec2 pointer_;
  double distance_ = 0;  // along its wall
  Stretch free_;
  TypedFields fields_;
  OpeningId preview_;  // none: not in the air
};

}  // namespace

std::unique_ptr<Tool> makePlaceOpeningTool(OpeningToPlace what) {
  return std::make_unique<PlaceOpeningTool>(std::move(what));
}

}  // namespace idap
