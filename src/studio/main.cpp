#include <QApplication>
#include <QMessageBox>

#include "studio/window/main_window.h"

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setApplicationName(QStringLiteral("idap"));
  QApplication::setApplicationDisplayName(QStringLiteral("IDAP"));
  idap::MainWindow window(std::make_shared<const idap::Catalog>());
  window.show();
  if (argc > 1) window.openFile(argv[1]);
  return QApplication::exec();
}
