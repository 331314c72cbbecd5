#include "gui/support/gui_support.h"

#include <QDir>
#include <QPixmap>
#include <QTest>

namespace idap::test {

bool waitFor(const std::function<bool()>& condition, int milliseconds) {
  return QTest::qWaitFor(condition, milliseconds);
}

void shoot(QWidget& widget, const char* name) {
  const QString folder = qEnvironmentVariable("IDAP_SHOTS");
  if (folder.isEmpty()) return;
  QDir().mkpath(folder);
  widget.grab().save(QDir(folder).filePath(QString::fromUtf8(name) + QStringLiteral(".png")));
}

}  // namespace idap::test
