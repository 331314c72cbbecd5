#include <gtest/gtest.h>

#include <QApplication>
#include <QStandardPaths>
#include <QTemporaryDir>

// Tests never read or write the files of whoever runs them.
int main(int argc, char** argv) {
  const QTemporaryDir folder;
  for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME"})
    qputenv(name, folder.filePath(QString::fromLatin1(name).toLower()).toLocal8Bit());
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  QApplication::setApplicationName(QStringLiteral("idap-test"));
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
