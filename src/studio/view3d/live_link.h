// The live render thread as the GUI thread sees it: requests go out at once, the newest frame comes back as a
// signal.
#pragma once

#include <QObject>
#include <memory>

#include "scene/live/live_render.h"

namespace idap {

class LiveLink : public QObject {
  Q_OBJECT
 public:
  explicit LiveLink(QObject* parent = nullptr);
  ~LiveLink() override;

  std::uint64_t submit(LiveRequest request);  // the thread starts with the first
  void pause(bool paused);

 signals:
  void framed(const idap::LiveFrame& frame);  // frames nobody could have seen are left out
  void failed(const QString& why);

 private:
  struct Mailbox;
  void deliver();

  std::shared_ptr<Mailbox> mailbox_;
  std::unique_ptr<LiveRender> render_;
  bool paused_ = false;
};

}  // namespace idap
