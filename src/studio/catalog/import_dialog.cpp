#include "studio/catalog/import_dialog.h"

#include <QDialogButtonBox>
#include <QKeyEvent>
#include <QStackedWidget>

#include "base/file.h"
#include "base/zip.h"
#include "editor/selection.h"
#include "editor/snap.h"
#include "model/edits/piece_edits.h"
#include "studio/catalog/catalog_panel.h"
#include "studio/catalog/import_pages.h"
#include "studio/widgets/background_job.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

// A library: an archive with the table of one, whatever its ending.
bool isLibrary(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  if (extension == ".sh3f") return true;
  if (extension != ".zip") return false;
  return ZipReader(file).contains("PluginFurnitureCatalog.properties");
}

struct Found {
  std::shared_ptr<const ModelImport> model;  // null: a library
  LibraryPreview library;
};

// Near where the pointer was last, else in the middle of the level's first room.
Vec2 placeFor(const Editor& editor) {
  const PointerEvent& last = editor.lastPointer();
  if (last.plane == Plane::XY && !(last.at == Vec2{})) return last.at;
  for (const auto& [id, room] : editor.home().rooms) {
    if (!(room->level == editor.level()) || room->points.empty()) continue;
    Vec2 sum;
    for (const Vec2& point : room->points) sum += point;
    return sum / double(room->points.size());
  }
  return {};
}

}  // namespace

struct ImportDialog::Impl : public QObject {
  ImportDialog* self;
  Editor& editor;
  QStackedWidget* pages = nullptr;
  ImportStart* start = nullptr;
  LibraryPage* library = nullptr;
  ModelPage* model = nullptr;
  QDialogButtonBox* buttons = nullptr;
  QPushButton* back = nullptr;
  QPushButton* finish = nullptr;
  std::filesystem::path file;
  BackgroundJob* job = nullptr;

  Impl(ImportDialog* dialog, Editor& e) : self(dialog), editor(e) {}
  ~Impl() override { delete job; }

  void build();
  void retranslate();
  void turnTo(QWidget* page);
  void read(const std::filesystem::path& path);
  void onFailed(std::exception_ptr error);
  void importLibrary();
  void importPiece();
};

void ImportDialog::Impl::build() {
  start = new ImportStart;
  library = new LibraryPage;
  model = new ModelPage(editor);
  pages = new QStackedWidget;
  pages->addWidget(start);
  pages->addWidget(library);
  pages->addWidget(model);
  buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  finish = buttons->addButton(QString(), QDialogButtonBox::AcceptRole);
  finish->setObjectName(QStringLiteral("importFinish"));
  back = buttons->addButton(QString(), QDialogButtonBox::ResetRole);
  back->setObjectName(QStringLiteral("importBack"));
  back->setAutoDefault(false);
  auto* layout = new QVBoxLayout(self);
  layout->addWidget(pages, 1);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, self, &QDialog::reject);
  connect(finish, &QPushButton::clicked, this, [this] {
    if (pages->currentWidget() == library)
      importLibrary();
    else
      importPiece();
  });
  connect(back, &QPushButton::clicked, this, [this] { turnTo(start); });
  connect(start, &ImportStart::fileChosen, this, [this](const QString& chosen) { read(fromQt(chosen)); });
  connect(start, &ImportStart::cancelled, this, [this] {
    if (job) job->cancel();
  });
  turnTo(start);
}

void ImportDialog::Impl::retranslate() {
  self->setWindowTitle(ImportDialog::tr("Import furniture"));
  start->retranslate();
  library->retranslate();
  model->retranslate();
  back->setText(ImportDialog::tr("Another file"));
  finish->setText(pages->currentWidget() == library ? ImportDialog::tr("Add to the catalog")
                                                    : ImportDialog::tr("Put into the home"));
}

void ImportDialog::Impl::turnTo(QWidget* page) {
  pages->setCurrentWidget(page);
  back->setVisible(page != start);
  finish->setVisible(page != start);
  retranslate();
}

void ImportDialog::Impl::read(const std::filesystem::path& path) {
  if (job) return;
  file = path;
  turnTo(start);
  start->setProblem({});
  const QString what = ImportDialog::tr("Reading %1").arg(toQt(path.filename().string()));
  start->setBusy(what);
  job = runInBackground<Found>(
      nullptr, what,
      [path](const Progress& progress) {
        Found found;
        if (isLibrary(path))
          found.library = previewLibrary(path, progress);
        else
          found.model = std::make_shared<const ModelImport>(readModelImport(path, progress));
        return found;
      },
      [this](const Found& found) {
        job = nullptr;
        start->setBusy({});
        if (found.model) {
          model->show(found.model);
          turnTo(model);
          return;
        }
        const auto target = installedLibrary(file, userDataFolder() / "furniture");
        std::error_code ignored;
        library->show(found.library, toQt(target.filename().string()),
                      std::filesystem::exists(target, ignored));
        turnTo(library);
      },
      [this](std::exception_ptr error) { onFailed(error); });
  connect(job, &BackgroundJob::progressed, this, [this] { start->setProgress(job ? job->fraction() : 0); });
}

void ImportDialog::Impl::onFailed(std::exception_ptr error) {
  job = nullptr;
  start->setBusy({});
  turnTo(start);
  start->setProblem(errorText(error));
}

void ImportDialog::Impl::importLibrary() {
  if (job) return;
  turnTo(start);
  const QString what = ImportDialog::tr("Copying %1").arg(toQt(file.filename().string()));
  start->setBusy(what);
  const auto catalog = editor.sharedCatalog();
  job = runInBackground<bool>(
      nullptr, what,
      [catalog, path = file](const Progress&) {
        installLibrary(path, userDataFolder() / "furniture");
        catalog->reread();
        return true;
      },
      [this](bool) {
        job = nullptr;
        for (QWidget* widget : QApplication::allWidgets())
          if (auto* panel = qobject_cast<CatalogPanel*>(widget)) panel->reload();
        editor.say({QT_TRANSLATE_NOOP("idap", "%1 is part of the catalog now"), {file.filename().string()}});
        emit self->libraryImported();
        self->accept();
      },
      [this](std::exception_ptr error) { onFailed(error); });
}

void ImportDialog::Impl::importPiece() {
  const ModelImport& import = *model->model();
  const std::string folder = freeAssetFolder(*editor.home().assets, import.name);
  Furniture piece = model->furniture(folder);
  const Vec2 at = placeFor(editor);
  piece.level = editor.level();
  piece.position = {at.x, at.y, piece.position.z};
  const PieceKind kind = model->kind();
  std::optional<Opening> opening;
  if (kind == PieceKind::Door || kind == PieceKind::Window) {
    Opening made;
    static_cast<Piece&>(made) = piece;
    made.kind = kind == PieceKind::Door ? OpeningKind::Door : OpeningKind::Window;
    made.cutsBothSides = true;
    constexpr double kAnywhere = 1000;  // m: into the nearest wall there is
    const auto inWall = snapOpening(editor, made, at, kAnywhere);
    opening = inWall ? *inWall : made;
    opening->position.z = piece.position.z;
  }
  Elements selected;
  const bool done = editor.apply(QT_TRANSLATE_NOOP("idap", "Import a piece"), [&](const Home& home) {
    Home after = home;
    auto assets = std::make_shared<Assets>(*home.assets);
    for (const auto& [name, bytes] : model->files(folder)) assets->emplace(name, bytes);
    after.assets = std::move(assets);
    if (opening) {
      OpeningEdit edit = addOpening(after, *opening);
      selected.openings = {edit.opening};
      return edit.home;
    }
    FurnitureEdit edit = addFurniture(after, piece);
    selected.furniture = {edit.furniture};
    return edit.home;
  });
  if (!done) return;  // the user was told why
  editor.select(selected);
  emit self->pieceImported();
  self->accept();
}

ImportDialog::ImportDialog(Editor& editor, QWidget* parent)
    : QDialog(parent), impl_(std::make_unique<Impl>(this, editor)) {
  setObjectName(QStringLiteral("importDialog"));
  impl_->build();
  const int unit = fontMetrics().height();
  resize(48 * unit, 34 * unit);
}

ImportDialog::~ImportDialog() = default;

void ImportDialog::chooseFile(const std::filesystem::path& file) { impl_->read(file); }

// Enter ends what is typed into a field; a button that has the keyboard takes it itself.
void ImportDialog::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter) QDialog::keyPressEvent(event);
}

void ImportDialog::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) impl_->retranslate();
}

}  // namespace idap
