#include "studio/catalog/model_preview.h"

#include <QMouseEvent>
#include <cmath>

#include "studio/view3d/live_link.h"
#include "studio/widgets/images.h"

namespace idap {

namespace {

constexpr double kFieldOfView = 0.6;  // radians
constexpr double kPerPixel = 0.01;    // radians a pixel of dragging turns
constexpr double kPerKey = 0.15;      // radians a key turns
constexpr double kMostTilt = 1.5, kLeastTilt = -0.2;
constexpr int kSamples = 64;

}  // namespace

ModelPreview::ModelPreview(Editor& editor, QWidget* parent)
    : QLabel(parent), editor_(editor), link_(std::make_unique<LiveLink>()) {
  setAlignment(Qt::AlignCenter);
  setFrameShape(QFrame::StyledPanel);
  setWordWrap(true);
  setCursor(Qt::OpenHandCursor);
  setFocusPolicy(Qt::StrongFocus);
  connect(link_.get(), &LiveLink::framed, this, [this](const LiveFrame& frame) {
    QPixmap pixmap = QPixmap::fromImage(toQImage(frame.image));
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    setPixmap(pixmap);
  });
  connect(link_.get(), &LiveLink::failed, this, [this](const QString& why) { setText(why); });
}

ModelPreview::~ModelPreview() = default;

void ModelPreview::show(const Furniture& piece, std::shared_ptr<const Assets> assets) {
  home_ = Home();
  home_.assets = std::move(assets);
  Furniture here = piece;
  here.level = {};
  here.group = {};
  here.visible = true;
  here.position = {0, 0, 0};
  size_ = here.size;
  home_.furniture.set(home_.newId<FurnitureId>(), std::move(here));
  submit();
}

void ModelPreview::look(double left, double down) {
  turn_ = std::remainder(turn_ + left, 2 * kPi);
  tilt_ = std::clamp(tilt_ + down, kLeastTilt, kMostTilt);
  submit();
}

void ModelPreview::submit() {
  if (home_.furniture.empty()) return;
  LiveRequest request;
  request.home = home_;
  request.catalog = editor_.sharedCatalog();
  request.samples = kSamples;
  request.lamps = LampPolicy::On;
  const QSize size = contentsRect().size() * devicePixelRatioF();
  request.width = std::max(64, size.width());
  request.height = std::max(48, size.height());
  Camera& camera = request.camera;
  camera.fieldOfView = kFieldOfView;
  camera.yaw = turn_;
  camera.pitch = tilt_;
  // As far away as the ball around it fills the picture.
  const double distance = near_ * length(size_) / 2 / std::sin(kFieldOfView / 2);
  camera.eye = Vec3{0, 0, size_.z / 2} - viewDirection(camera) * distance;
  link_->submit(std::move(request));
}

void ModelPreview::mousePressEvent(QMouseEvent* event) { at_ = event->position(); }

void ModelPreview::mouseMoveEvent(QMouseEvent* event) {
  if (!(event->buttons() & (Qt::LeftButton | Qt::MiddleButton))) return;
  const QPointF by = event->position() - at_;
  at_ = event->position();
  look(-kPerPixel * by.x(), kPerPixel * by.y());
}

void ModelPreview::wheelEvent(QWheelEvent* event) {
  near_ = std::clamp(near_ * std::exp(-event->angleDelta().y() / 1200.0), 0.2, 3.0);
  submit();
  event->accept();
}

void ModelPreview::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      return look(kPerKey, 0);
    case Qt::Key_Right:
      return look(-kPerKey, 0);
    case Qt::Key_Up:
      return look(0, kPerKey);
    case Qt::Key_Down:
      return look(0, -kPerKey);
    default:
      QLabel::keyPressEvent(event);
  }
}

}  // namespace idap
