#include "editor/tools/select/move_drag.h"

#include <algorithm>
#include <limits>

#include "editor/hit_test_shapes.h"
#include "editor/tools/select/moving.h"
#include "editor/tools/select/opening_measures.h"
#include "model/edits/arrange_edits.h"
#include "model/edits/element_edits.h"
#include "model/wall_path.h"

namespace idap {

namespace {

constexpr const char* kMove = QT_TRANSLATE_NOOP("idap", "Move");
constexpr const char* kCopy = QT_TRANSLATE_NOOP("idap", "Duplicate");
constexpr double kWallReach = 0.3;  // m beside a wall where an opening still belongs into it

Vec2 planOf(Vec3 v) { return {v.x, v.y}; }

// Points of an element that should meet points and lines of others.
void addPoints(const Home& home, AnyId id, std::vector<Vec3>& points) {
  const auto add = [&points](Vec2 p, double z) { points.push_back({p.x, p.y, z}); };
  if (const auto* wallId = std::get_if<WallId>(&id)) {
    const Wall& wall = *home.walls.find(*wallId);
    add(wall.start, elevationOf(home, wall.level));
    add(wall.end, elevationOf(home, wall.level));
  } else if (const auto* roomId = std::get_if<RoomId>(&id)) {
    const Room& room = *home.rooms.find(*roomId);
    for (const Vec2 p : room.points) add(p, elevationOf(home, room.level));
  } else if (const auto* lineId = std::get_if<PolylineId>(&id)) {
    const Polyline& line = *home.polylines.find(*lineId);
    for (const Vec2 p : line.points) add(p, elevationOf(home, line.level));
  } else if (const auto* dimensionId = std::get_if<DimensionId>(&id)) {
    const Dimension& dimension = *home.dimensions.find(*dimensionId);
    const double floor = elevationOf(home, dimension.level);
    add(dimension.start, floor + dimension.startElevation);
    add(dimension.end, floor + dimension.endElevation);
  }
}

// What moves along although it is not selected: walls joined to those that are.
Elements withJoined(const Home& home, Elements elements) {
  const std::vector<WallId> walls = elements.walls;
  for (const WallId id : walls)
    if (const Wall* wall = home.walls.find(id))
      for (const WallId joined : {wall->neighbourAtStart, wall->neighbourAtEnd})
        if (joined) add(elements, joined);
  return elements;
}

}  // namespace

MoveDrag::MoveDrag(Editor& editor, const PointerEvent& press, Elements elements, AnyId lead)
    : EditDrag(editor, kMove, press, Cursor::Move), elements_(std::move(elements)) {
  study(editor, lead);
}

void MoveDrag::study(const Editor& editor, AnyId lead) {
  const Home& home = before();
  base_ = !elements_.walls.empty();
  across_ = wallNormal(home, elements_);
  alone_ = count(elements_) == 1;
  if (const auto* opening = std::get_if<OpeningId>(&lead); opening && alone_) {
    kind_ = Kind::Opening;
    opening_ = *opening;
    placed_ = *home.openings.find(opening_);
    return;
  }
  const Piece* piece = pieceOf(home, lead);
  if (piece || std::holds_alternative<GroupId>(lead)) {
    kind_ = Kind::Piece;
    piece_ = piece ? *piece : boxPiece(home, only(lead));
    // As it lies now tells how it wants to lie: with its back to a wall, on what is below it.
    PieceSnapRequest request;
    request.piece = piece_;
    request.tolerance = 0.005;
    request.ignored = elements_;
    const SnappedPiece rest = snapPiece(editor, request, false);
    mayTurn_ = piece && alone_ && rest.onWall;
    hangs_ = std::abs(rest.position.z - piece_.position.z) > 0.002;
    return;
  }
  addPoints(home, lead, points_);
  std::sort(points_.begin(), points_.end(), [this](Vec3 a, Vec3 b) {
    return length(project(plane(), a) - press().at) < length(project(plane(), b) - press().at);
  });
  if (points_.size() > 1) points_.resize(1);
}

void MoveDrag::aim(const Editor& editor, const PointerEvent& event) {
  Vec2 delta = event.at - press().at;
  if (event.modifiers.shift) (std::abs(delta.x) >= std::abs(delta.y) ? delta.y : delta.x) = 0;
  copies_ = event.modifiers.control;
  const Vec3 by = inWorld(plane(), delta);
  turn_ = 0;
  if (kind_ == Kind::Opening)
    aimOpening(editor, event, by);
  else if (kind_ == Kind::Piece)
    aimPiece(editor, by, event.modifiers.alt);
  else
    aimPoints(editor, by);
  if (event.modifiers.shift && kind_ != Kind::Opening) {
    // Snapping does not leave the axis.
    const Vec2 done = project(plane(), by_);
    const Vec2 kept = delta.x == 0 ? Vec2{0, done.y} : Vec2{done.x, 0};
    by_ = plane() == Plane::XY ? Vec3{kept.x, kept.y, by_.z} : inWorld(plane(), kept);
  }
  measure(editor);
  typeDistance();
}

void MoveDrag::aimPiece(const Editor& editor, Vec3 by, bool off) {
  PieceSnapRequest request;
  request.plane = plane();
  request.piece = piece_;
  request.piece.position += by;
  request.tolerance = std::clamp(tolerance(last()), 0.02, 0.3);
  request.mayTurn = mayTurn_ && plane() == Plane::XY;
  request.hangs = hangs_;
  request.ignored = copies_ ? copied_ : elements_;
  const SnappedPiece snapped = snapPiece(editor, request, off);
  by_ = snapped.position - piece_.position;
  turn_ = alone_ ? std::remainder(snapped.angle - piece_.angle, 2 * kPi) : 0;
  guides_ = snapped.guides;
}

void MoveDrag::aimOpening(const Editor& editor, const PointerEvent& event, Vec3 by) {
  Opening wanted = *before().openings.find(opening_);
  const Vec2 was = planOf(wanted.position);
  const Wall* host = before().walls.find(wanted.wall);
  const Vec2 front = rotated(Vec2{0, -1}, wanted.angle), right = rotated(Vec2{1, 0}, wanted.angle);
  wanted.position.z = std::max(0.0, wanted.position.z + by.z);
  Vec2 at = was + planOf(by);
  double reach = std::max(kWallReach, 2 * tolerance(event));
  if (plane() == Plane::XY) {
    // The pointer keeps its place along the opening; across it, it tells the wall and the side.
    at = event.at - right * dot(press().at - was, right);
    if (host) {
      const WallPath path(*host);
      const double s = path.nearest(at);
      const bool inside = length(path.point(s) - at) <= host->thickness / 2 + 3 * event.pixel;
      const Vec2 normal = perpendicular(path.direction(s));
      const double side = dot(front, perpendicular(path.direction(path.nearest(was)))) >= 0 ? 1 : -1;
      if (inside) at = path.point(s) + normal * (side * 1e-3);
    }
  } else {
    reach = 1e9;  // from the side it stays in its wall
    if (host) {
      const WallPath path(*host);
      const double s = path.nearest(at);
      const double side = dot(front, perpendicular(path.direction(path.nearest(was)))) >= 0 ? 1 : -1;
      at = path.point(s) + perpendicular(path.direction(s)) * (side * 1e-3);
    }
  }
  const Elements itself = copies_ ? copied_ : only(opening_);
  placed_.reset();
  if (host || plane() == Plane::XY) placed_ = snapOpening(editor, wanted, at, reach, itself);
  if (placed_ && !event.modifiers.alt && editor.settings().snapping) centreOpening(editor, itself);
  if (!placed_) {
    placed_ = wanted;
    if (plane() == Plane::XY) placed_->wall = {};
    const Vec2 free = was + planOf(by);
    placed_->position = {free.x, free.y, wanted.position.z};
  }
  if (plane() != Plane::XY && !event.modifiers.alt && editor.settings().snapping) {
    // Sills and heads line up with those of others, and with the floor.
    PieceSnapRequest request;
    request.plane = plane();
    request.piece = *placed_;
    request.tolerance = tolerance(event);
    request.ignored = itself;
    const SnappedPiece snapped = snapPiece(editor, request, false);
    placed_->position.z = std::max(0.0, snapped.position.z);
  }
  by_ = placed_->position - before().openings.find(opening_)->position;
}

// In the middle of its wall, when it is nearly there.
void MoveDrag::centreOpening(const Editor& editor, const Elements& itself) {
  const Wall* host = before().walls.find(placed_->wall);
  if (!host) return;
  const WallPath path(*host);
  const double middle = path.length() / 2;
  if (std::abs(path.nearest(planOf(placed_->position)) - middle) > tolerance(last())) return;
  const Vec2 centre = path.point(middle), aside = perpendicular(path.direction(middle));
  const double side = dot(rotated(Vec2{0, -1}, placed_->angle), aside) >= 0 ? 1 : -1;
  const auto centred = snapOpening(editor, *placed_, centre + aside * (side * 1e-3), 0, itself);
  if (!centred || length(planOf(centred->position) - planOf(placed_->position)) > 2 * tolerance(last()))
    return;
  placed_ = centred;
  if (plane() == Plane::XY) guides_.push_back({centre - aside * 0.5, centre + aside * 0.5});
}

void MoveDrag::aimPoints(const Editor& editor, Vec3 by) {
  by_ = by;
  if (across_) {
    const Vec2 along = *across_ * dot(*across_, planOf(by));
    by_ = {along.x, along.y, 0};
  }
  if (points_.empty()) return;
  const Vec3 reference = points_.front();
  const Vec2 wanted = project(plane(), reference + by_);
  const Elements ignored = copies_ ? copied_ : withJoined(before(), elements_);
  const SnappedPoint point = snapped(editor, wanted, ignored, !base_);
  const Vec3 more = inWorld(plane(), point.at - wanted);
  if (across_) {
    const Vec2 step = *across_ * dot(*across_, planOf(more));
    by_ += Vec3{step.x, step.y, 0};
  } else {
    by_ += more;
  }
}

void MoveDrag::measure(const Editor& editor) {
  measures_.clear();
  const Elements& ignored = copies_ ? copied_ : elements_;
  if (kind_ == Kind::Piece) {
    Piece there = piece_;
    there.position += by_;
    there.angle += turn_;
    measures_ = clearances(editor, plane(), there, ignored);
  } else if (kind_ == Kind::Opening && placed_) {
    measures_ = openingMeasures(editor.home(), plane(), *placed_, ignored);
  } else if (length(by_) > 0) {
    const Vec2 by = project(plane(), by_);
    if (length(by) > 1e-6) measures_ = {{press().at, press().at + by, true}};
  }
  if (measures_.empty()) {
    if (fields_.typing()) return;
    fields_.define({});
    return;
  }
  std::size_t strong = 0;
  if (chosen_ == Vec2{}) {
    for (std::size_t i = 1; i < measures_.size(); ++i)
      if (length(measures_[i].to - measures_[i].from) < length(measures_[strong].to - measures_[strong].from))
        strong = i;
  } else {
    double best = -2;
    for (std::size_t i = 0; i < measures_.size(); ++i) {
      const double likeness = dot(normalized(measures_[i].to - measures_[i].from), chosen_);
      if (likeness > best) best = likeness, strong = i;
    }
  }
  for (std::size_t i = 0; i < measures_.size(); ++i) measures_[i].strong = i == strong;
  const double value = length(measures_[strong].to - measures_[strong].from);
  if (fields_.fields().empty())
    fields_.define({{.label = QT_TRANSLATE_NOOP("idap", "Distance"), .value = value, .active = true}});
  fields_.show(0, value);
}

// Moves on so that the chosen distance is the typed one.
void MoveDrag::typeDistance() {
  const std::optional<double> typed = fields_.value(0);
  const auto strong =
      std::find_if(measures_.begin(), measures_.end(), [](const MeasureLine& m) { return m.strong; });
  if (!typed || strong == measures_.end()) return;
  const Vec2 line = strong->to - strong->from;
  const Vec2 direction = normalized(line);
  if (chosen_ == Vec2{}) chosen_ = direction;
  if (kind_ == Kind::Points) {
    by_ = inWorld(plane(), direction * *typed);
    strong->to = strong->from + direction * *typed;
    return;
  }
  const Vec2 step = direction * (length(line) - *typed);
  by_ += inWorld(plane(), step);
  if (kind_ == Kind::Opening && placed_) placed_->position += inWorld(plane(), step);
  strong->from += step;
  for (MeasureLine& other : measures_) {
    if (&other == &*strong) continue;
    const double along = dot(normalized(other.to - other.from), direction);
    // The one behind grows, those beside move along.
    other.from += step;
    if (std::abs(along) < 0.5) other.to += step;
  }
}

Home MoveDrag::change(const Home& before) {
  if (copies_) {
    CopyEdit edit = duplicateElements(before, elements_, by_);
    copied_ = edit.copies;
    Home next = std::move(edit.home);
    if (kind_ == Kind::Opening && placed_ && copied_.openings.size() == 1) {
      next.openings.set(copied_.openings.front(), *placed_);
    } else if (turn_ != 0) {
      const Vec2 about = planOf(piece_.position + by_);
      next = turnElements(next, copied_, about, turn_);
    }
    return next;
  }
  if (kind_ == Kind::Opening && placed_) {
    Home next = before;
    next.openings.set(opening_, *placed_);
    return next;
  }
  Home next = moved(before, elements_, by_);
  if (turn_ != 0) next = turnElements(next, elements_, planOf(piece_.position + by_), turn_);
  return next;
}

Home MoveDrag::settle(const Editor& editor, const Home& before, Home after) {
  return base_ ? withRooms(editor, before, std::move(after)) : after;
}

void MoveDrag::finish(Editor& editor) {
  if (copies_) {
    // Begun as a move: undo should call it what it became.
    editor.document().cancel();
    editor.document().begin(kCopy);
    move(editor, last());
  }
  EditDrag::finish(editor);
  if (copies_) editor.select(copied_);
}

Drag::Answer MoveDrag::key(Editor& editor, const KeyEvent& event) {
  if ((event.key == Key::Tab || event.key == Key::BackTab) && measures_.size() > 1) {
    std::size_t strong = 0;
    while (strong + 1 < measures_.size() && !measures_[strong].strong) ++strong;
    const std::size_t step = event.key == Key::Tab ? 1 : measures_.size() - 1;
    choose((strong + step) % measures_.size());
    return Answer::Used;
  }
  return EditDrag::key(editor, event);
}

void MoveDrag::choose(std::size_t measure) {
  fields_.clear();
  for (std::size_t i = 0; i < measures_.size(); ++i) measures_[i].strong = i == measure;
  const Vec2 line = measures_[measure].to - measures_[measure].from;
  chosen_ = normalized(line);
  fields_.show(0, length(line));
}

void MoveDrag::show(const Editor&, Overlay& overlay, double) const { overlay.measures = measures_; }

Text MoveDrag::hint() const {
  if (kind_ == Kind::Opening)
    return QT_TRANSLATE_NOOP(
        "idap",
        "Drop it into a wall. The side of the pointer is where it opens to. Ctrl copies, "
        "Tab chooses a distance to type.");
  if (measures_.empty())
    return QT_TRANSLATE_NOOP("idap", "Shift keeps to one axis, Ctrl copies, Alt stops snapping.");
  return QT_TRANSLATE_NOOP(
      "idap",
      "Type a distance and press Enter; Tab chooses which. Shift keeps to one axis, Ctrl "
      "copies, Alt stops snapping.");
}

}  // namespace idap
