// The studio: idap-studio [FILE…]. `idap` starts it.
#include <QApplication>
#include <QCommandLineParser>
#include <QTimer>
#include <cstdio>
#include <cstring>

#include "base/log.h"
#include "base/platform.h"
#include "studio/print/print_command.h"
#include "studio/widgets/icons.h"
#include "studio/window/language.h"
#include "studio/window/main_window.h"

namespace {

// A window is usable when it has been drawn and its event loop has nothing left to do.
void measureStart() {
  QTimer::singleShot(0, [] {
    std::printf("{\"start_s\": %.3f, \"peak_rss_mb\": %.0f}\n", idap::processAgeSeconds(),
                idap::peakMemoryMegabytes());
    std::fflush(stdout);
    QApplication::closeAllWindows();
  });
}

}  // namespace

// `idap print` becomes this program without a window.
int printWithoutWindow(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  // What Qt has to say of a machine without a desktop is of no use to who prints.
  qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
  QApplication application(argc, argv);
  const QStringList arguments = QApplication::arguments().mid(2);
  const qsizetype language = arguments.indexOf(QStringLiteral("--language"));
  idap::applyLanguage(language >= 0 ? arguments.value(language + 1) : QStringLiteral("en"));
  return idap::runPrintCommand(arguments);
}

int main(int argc, char** argv) {
  idap::setUpProcess();
  idap::setUpLogging();
  if (argc > 1 && std::strcmp(argv[1], "--print-job") == 0) return printWithoutWindow(argc, argv);
  if (!idap::hasDisplay()) {  // where Qt would end the program by a signal
    std::fputs(
        "idap: there is no display to open the studio on; 'idap render FILE -o picture.png' needs none\n",
        stderr);
    return 1;
  }
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("idap"));  // the folder of the settings
  QApplication::setApplicationName(QStringLiteral("idap"));
  QApplication::setApplicationDisplayName(QStringLiteral("IDAP"));
  QApplication::setApplicationVersion(QStringLiteral(IDAP_VERSION));
  QApplication::setDesktopFileName(QStringLiteral("idap"));
  QApplication::setWindowIcon(idap::icon("idap"));

  QCommandLineParser arguments;
  arguments.setApplicationDescription(
      QStringLiteral("IDAP: draw or open a home, furnish it, and see it as it would really look."));
  arguments.addHelpOption();
  arguments.addVersionOption();
  arguments.addPositionalArgument(QStringLiteral("FILE"),
                                  QStringLiteral("Homes to open (.idap, .sh3d), each in a window"),
                                  QStringLiteral("[FILE...]"));
  const QCommandLineOption measure(
      QStringLiteral("measure-start"),
      QStringLiteral("Print how long the start took and how much memory, and quit"));
  arguments.addOption(measure);
  arguments.process(application);

  auto* window = new idap::MainWindow(std::make_shared<const idap::Catalog>());
  window->setAttribute(Qt::WA_DeleteOnClose);
  window->show();
  const QStringList files = arguments.positionalArguments();
  if (!files.isEmpty()) window->openFile(files.first().toStdString());
  idap::MainWindow* last = window;
  for (qsizetype i = 1; i < files.size(); ++i) {
    last = last->newWindow();
    last->openFile(files[i].toStdString());
  }
  if (arguments.isSet(measure))
    QTimer::singleShot(0, measureStart);
  else if (files.isEmpty())
    QTimer::singleShot(0, window, &idap::MainWindow::offerRestore);
  return QApplication::exec();
}
