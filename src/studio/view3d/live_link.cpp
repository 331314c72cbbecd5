#include "studio/view3d/live_link.h"

#include <mutex>
#include <optional>
#include <utility>

#include "studio/widgets/texts.h"

namespace idap {

struct LiveLink::Mailbox {
  std::mutex mutex;
  std::optional<LiveFrame> frame;  // the newest that was not fetched
};

LiveLink::LiveLink(QObject* parent) : QObject(parent), mailbox_(std::make_shared<Mailbox>()) {}
LiveLink::~LiveLink() { render_.reset(); }

std::uint64_t LiveLink::submit(LiveRequest request) {
  if (!render_) {
    const auto box = mailbox_;
    render_ = std::make_unique<LiveRender>(
        LiveRender::Sink{[this, box](LiveFrame frame) {
                           bool first = false;
                           {
                             const std::lock_guard lock(box->mutex);
                             first = !box->frame;
                             box->frame = std::move(frame);
                           }
                           if (first)
                             QMetaObject::invokeMethod(
                                 this, [this] { deliver(); }, Qt::QueuedConnection);
                         },
                         [this](const std::string& why) {
                           QMetaObject::invokeMethod(
                               this, [this, why] { emit failed(toQt(why)); }, Qt::QueuedConnection);
                         }});
    render_->pause(paused_);
  }
  return render_->submit(std::move(request));
}

void LiveLink::pause(bool paused) {
  paused_ = paused;
  if (render_) render_->pause(paused);
}

void LiveLink::deliver() {
  std::optional<LiveFrame> frame;
  {
    const std::lock_guard lock(mailbox_->mutex);
    frame = std::exchange(mailbox_->frame, std::nullopt);
  }
  if (frame) emit framed(*frame);
}

}  // namespace idap
