#include "studio/view3d/view3d.h"

#include <cmath>

#include "studio/view3d/view3d_impl.h"
#include "studio/widgets/images.h"

namespace idap {

namespace {

constexpr double kMostPixels = 640.0 * 480;  // a live frame is traced with; larger windows are enlarged

// The element that a traced object stands for; none for the land and the sky.
std::optional<AnyId> memberOf(const ElementId& object) {
  return std::visit(
      [](const auto& id) -> std::optional<AnyId> {
        if constexpr (std::is_same_v<std::decay_t<decltype(id)>, std::monostate>)
          return std::nullopt;
        else
          return AnyId(id);
      },
      object);
}
// With its group in its stead.
std::optional<AnyId> elementOf(const Home& home, const ElementId& object) {
  const std::optional<AnyId> member = memberOf(object);
  return member ? std::optional(byGroup(home, *member)) : std::nullopt;
}

// Less than this from its face, a wall is all that would be seen.
constexpr double kFreeSight = 1.2;  // m

bool facesWall(const Home& home, const Camera& camera) {
  const Vec3 direction = viewDirection(camera);
  for (const double share : {0.25, 0.5, 0.75, 1.0}) {
    const Vec3 ahead = camera.eye + direction * (share * kFreeSight);
    const Vec3 back = keptOutOfWalls(home, camera.eye, ahead) - ahead;
    if (dot(back, direction) < -0.5 * length(back)) return true;  // not only to the side
  }
  return false;
}

// At eye height, where the home says that somebody stands and something is to be seen; or none.
std::optional<Camera> firstInside(const Home& home) {
  if (home.observer && !facesWall(home, *home.observer)) return home.observer;
  for (const auto& [id, camera] : home.cameras)
    if (!facesWall(home, *camera)) return *camera;
  return std::nullopt;
}

}  // namespace

View3d::View3d(Editor& editor, QWidget* parent)
    : QWidget(parent), impl_(std::make_unique<Impl>(this, editor)) {
  Impl& d = *impl_;
  setMinimumSize(80, 60);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setFocusPolicy(Qt::StrongFocus);
  setAcceptDrops(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  d.walking.setInterval(16);
  connect(&d.walking, &QTimer::timeout, this, [&d] { d.step(); });
  connect(&d.link, &LiveLink::framed, this, [&d](const LiveFrame& frame) { d.show(frame); });
  connect(&d.link, &LiveLink::failed, this, &View3d::failed);
  d.link.pause(true);

  Editor::Listener listener;
  listener.changed = [this, &d](Editor::Change change) {
    switch (change) {
      case Editor::Change::Document:
        d.placed = false;
        d.picture = {};
        d.seen.reset();
        d.submit();
        update();
        break;
      case Editor::Change::Home:
        d.submit();
        break;
      case Editor::Change::Selection:
        d.outlineSelection();
        update();
        break;
      default:
        break;
    }
  };
  d.subscription = editor.subscribe(std::move(listener));
}

View3d::~View3d() { impl_->editor.unsubscribe(impl_->subscription); }

QSize View3d::Impl::pixels() const {
  const double ratio = view->devicePixelRatioF();
  const double w = std::max(64.0, view->width() * ratio), h = std::max(48.0, view->height() * ratio);
  const double scale = std::min(1.0, std::sqrt(kMostPixels / (w * h)));
  return {int(std::lround(w * scale)), int(std::lround(h * scale))};
}

void View3d::Impl::submit() {
  if (!view->isVisible()) return;
  if (!placed) {
    placed = true;
    const std::optional<Camera> inside = firstInside(editor.home());
    camera = inside ? *inside : topCamera(editor.home(), aspect());
    manner = inside && !isOutside(editor.home(), inside->eye) ? Manner::Walk : Manner::Orbit;
    emit view->cameraMoved();
  }
  LiveRequest request;
  request.home = editor.home();
  request.catalog = editor.sharedCatalog();
  request.camera = camera;
  const QSize size = pixels();
  request.width = size.width();
  request.height = size.height();
  request.cut = cut;
  request.compensation = float(compensation);
  request.samples = samples;
  asked = link.submit(std::move(request));
}

void View3d::Impl::show(const LiveFrame& frame) {
  // An answer to an older request is worth showing all the same: it is what the eye saw a moment ago.
  if (frame.generation < shown) return;
  shown = frame.generation;
  picture = toQImage(frame.image);
  const bool other = seen != frame.view;
  seen = frame.view;
  shownSamples = frame.samples;
  shownFinished = frame.finished;
  if (other) outlineSelection();
  view->update();
  emit view->frameShown(frame.samples, frame.finished);
}

// A line around what is selected, as wide as two pixels of the features.
void View3d::Impl::outlineSelection() {
  outline = {};
  const Elements& selection = editor.selection();
  if (!seen || empty(selection)) return;
  const render::Features& f = seen->features;
  std::vector<char> chosen(seen->objects.size(), 0);
  bool any = false;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const auto id = elementOf(editor.home(), seen->objects[i]);
    chosen[i] = id && contains(selection, *id);
    any = any || chosen[i];
  }
  if (!any) return;
  outline = QImage(f.width, f.height, QImage::Format_ARGB32_Premultiplied);
  outline.fill(Qt::transparent);
  const QRgb line = view->palette().color(QPalette::Highlight).rgb();
  const auto is = [&](int x, int y) {
    const std::size_t i = f.index(x, y);
    return f.distance[i] > 0 && f.objectId[i] < chosen.size() && chosen[f.objectId[i]] != 0;
  };
  for (int y = 0; y < f.height; ++y)
    for (int x = 0; x < f.width; ++x) {
      const bool here = is(x, y);
      if ((x > 0 && is(x - 1, y) != here) || (y > 0 && is(x, y - 1) != here) ||
          (x + 1 < f.width && is(x + 1, y) != here) || (y + 1 < f.height && is(x, y + 1) != here))
        outline.setPixel(x, y, line);
    }
}

void View3d::Impl::look(const Camera& to) {
  camera = to;
  submit();
  emit view->cameraMoved();
}

const Camera& View3d::camera() const { return impl_->camera; }
void View3d::setCamera(const Camera& camera) {
  impl_->camera = camera;
  impl_->placed = true;
  impl_->manner = isOutside(impl_->editor.home(), camera.eye) ? Manner::Orbit : Manner::Walk;
  impl_->submit();
  emit cameraMoved();
}
View3d::Manner View3d::manner() const { return impl_->manner; }
void View3d::setManner(Manner manner) { impl_->manner = manner; }
CutAway View3d::cutAway() const { return impl_->cut; }
void View3d::setCutAway(CutAway cut) {
  impl_->cut = cut;
  impl_->submit();
}
bool View3d::stopsAtWalls() const { return impl_->stops; }
void View3d::setStopsAtWalls(bool stops) { impl_->stops = stops; }
double View3d::compensation() const { return impl_->compensation; }
void View3d::setCompensation(double stops) {
  impl_->compensation = stops;
  impl_->submit();
}
void View3d::setSamples(int samples) { impl_->samples = samples; }
void View3d::seeWholeHome() {
  setCamera(topCamera(impl_->editor.home(), impl_->aspect()));
  setManner(Manner::Orbit);
}
QImage View3d::picture() const { return impl_->picture; }
int View3d::samples() const { return impl_->shownSamples; }
bool View3d::upToDate() const { return impl_->asked > 0 && impl_->shown == impl_->asked; }

std::optional<AnyId> View3d::at(QPoint pixel) const {
  const auto i = impl_->featureAt(pixel);
  if (!i) return std::nullopt;
  const render::Features& f = impl_->seen->features;
  if (!(f.distance[*i] > 0) || f.objectId[*i] >= impl_->seen->objects.size()) return std::nullopt;
  return elementOf(impl_->editor.home(), impl_->seen->objects[f.objectId[*i]]);
}

std::optional<ElementPart> View3d::partAt(QPoint pixel) const {
  const auto i = impl_->featureAt(pixel);
  if (!i) return std::nullopt;
  const LiveView& seen = *impl_->seen;
  const std::uint32_t object = seen.features.objectId[*i];
  if (!(seen.features.distance[*i] > 0) || object >= seen.objects.size()) return std::nullopt;
  const std::optional<AnyId> element = memberOf(seen.objects[object]);
  if (!element) return std::nullopt;
  const std::vector<std::string>& parts = (*seen.parts)[object];
  const std::size_t slot = seen.features.slot[*i];
  return ElementPart{*element, slot < parts.size() ? parts[slot] : std::string()};
}

std::optional<Vec3> View3d::pointAt(QPoint pixel) const {
  const auto i = impl_->featureAt(pixel);
  if (!i || !(impl_->seen->features.distance[*i] > 0)) return std::nullopt;
  return impl_->ray(pixel).at(double(impl_->seen->features.distance[*i]));
}

void View3d::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (impl_->picture.isNull()) {
    painter.fillRect(rect(), palette().color(QPalette::Window).darker(107));
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect(), Qt::AlignCenter, tr("Preparing the view…"));
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(rect(), impl_->picture);
  if (!impl_->outline.isNull()) painter.drawImage(rect(), impl_->outline);
}

void View3d::resizeEvent(QResizeEvent*) { impl_->submit(); }

void View3d::showEvent(QShowEvent*) {
  impl_->link.pause(false);
  impl_->submit();
}

void View3d::hideEvent(QHideEvent*) { impl_->link.pause(true); }

}  // namespace idap
