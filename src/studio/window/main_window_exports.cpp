// What the window writes into files for other programs.
#include <QFileDialog>
#include <QFileInfo>

#include "base/file.h"
#include "catalog/catalog.h"
#include "catalog/library/own_library.h"
#include "formats/gltf/gltf_writer.h"
#include "scene/scene_builder.h"
#include "studio/lists/furniture_list.h"
#include "studio/widgets/background_job.h"
#include "studio/widgets/texts.h"
#include "studio/window/main_window_impl.h"

namespace idap {

namespace {

constexpr double kAspect = 1.5;  // of stored points of view, whose pictures have no shape of their own

// What the renderer sees of the home, lamps as they are switched, with every stored point of view.
void writeScene(const Home& home, const std::filesystem::path& file, const Progress& progress) {
  const Catalog catalog;
  const BuiltScene built = buildScene(home, catalog, BuildOptions{}, progress);
  std::vector<GltfCamera> cameras;
  for (const auto& [id, camera] : home.cameras)
    cameras.push_back({camera->name, toRenderCamera(*camera, built, kAspect), kAspect});
  progress.check();
  writeFileAtomically(file, writeGlb(*built.scene, cameras, built.centre));
}

// Asks where to write. suffix: without the dot; suggested: a name without it.
QFileDialog* saveDialog(QWidget* window, const QString& title, const QString& kind, const QString& suffix,
                        const QString& folder, const QString& suggested) {
  const QString extension = QStringLiteral(".") + suffix;
  auto* dialog =
      new QFileDialog(window, title, folder, kind + QStringLiteral(" (*") + extension + QStringLiteral(")"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(suffix);
  dialog->selectFile(suggested + extension);
  return dialog;
}

}  // namespace

void MainWindow::Impl::exportFurniture() {
  auto* dialog = saveDialog(w, MainWindow::tr("Export own furniture"), MainWindow::tr("Furniture libraries"),
                            QStringLiteral("sh3f"), preferences.lastFolder(), MainWindow::tr("My furniture"));
  dialog->setObjectName(QStringLiteral("furnitureFileDialog"));
  QObject::connect(dialog, &QFileDialog::fileSelected, w, [this](const QString& file) {
    try {
      const OwnLibrary library;
      if (library.pieces().empty()) throw Error("there is no furniture of your own yet");
      writeFileAtomically(fromQt(file), library.pack());
      editor.say({QT_TRANSLATE_NOOP("idap", "Exported your furniture as %1"), {fromQt(file)}});
    } catch (const Error& error) {
      editor.say({QT_TRANSLATE_NOOP("idap", "Your furniture could not be exported: %1"), {error.what()}},
                 Editor::Severity::Error);
    }
  });
  dialog->open();
}

void MainWindow::Impl::exportCsv() {
  auto* dialog = saveDialog(w, MainWindow::tr("Export the furniture list"), MainWindow::tr("Tables"),
                            QStringLiteral("csv"), preferences.lastFolder(), files->title());
  dialog->setObjectName(QStringLiteral("csvDialog"));
  QObject::connect(dialog, &QFileDialog::fileSelected, w, [this](const QString& file) {
    const std::string csv = furniture->csv();
    try {
      writeFileAtomically(fromQt(file), std::as_bytes(std::span(csv)));
      editor.say({QT_TRANSLATE_NOOP("idap", "Exported the furniture list as %1"), {fromQt(file)}});
    } catch (const Error& error) {
      editor.say({QT_TRANSLATE_NOOP("idap", "The furniture list could not be written: %1"), {error.what()}},
                 Editor::Severity::Error);
    }
  });
  dialog->open();
}

void MainWindow::Impl::exportScene() {
  auto* dialog = saveDialog(w, MainWindow::tr("Export in three dimensions"), MainWindow::tr("Scenes"),
                            QStringLiteral("glb"), preferences.lastFolder(), files->title());
  dialog->setObjectName(QStringLiteral("sceneDialog"));
  QObject::connect(dialog, &QFileDialog::fileSelected, w, [this](const QString& chosen) {
    auto* job = new BackgroundJob(
        MainWindow::tr("Exporting %1").arg(QFileInfo(chosen).fileName()),
        [home = editor.document().snapshot().home, file = fromQt(chosen)](const Progress& progress) {
          writeScene(home, file, progress);
        },
        [this, file = fromQt(chosen)](std::exception_ptr error) {
          if (const QString reason = errorText(error); !reason.isEmpty())
            editor.say({QT_TRANSLATE_NOOP("idap", "%1 could not be written: %2"), {file, fromQt(reason)}},
                       Editor::Severity::Error);
          else if (!error)
            editor.say({QT_TRANSLATE_NOOP("idap", "Exported the home in three dimensions as %1"), {file}});
        },
        w);
    emit files->jobStarted(job);
  });
  dialog->open();
}

}  // namespace idap
