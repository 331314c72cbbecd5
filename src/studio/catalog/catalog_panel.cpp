#include "studio/catalog/catalog_panel.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <QSplitter>
#include <QToolButton>

#include "base/error.h"
#include "catalog/library/own_library.h"
#include "catalog/library/own_models.h"
#include "editor/tools/place_tool.h"
#include "studio/catalog/catalog_model.h"
#include "studio/catalog/category_list.h"
#include "studio/catalog/chip_row.h"
#include "studio/catalog/favourites.h"
#include "studio/catalog/own_furniture_dialog.h"
#include "studio/catalog/piece_grid.h"
#include "studio/catalog/piece_tags.h"
#include "studio/catalog/thumbnail_store.h"
#include "studio/widgets/background_job.h"
#include "studio/widgets/icons.h"
#include "studio/widgets/length_field.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr std::size_t kChips = 12;
constexpr int kSideBySide = 30;  // of the font's height: from this width on categories stand beside the grid

std::set<std::string> toSet(const QStringList& list) {
  std::set<std::string> all;
  for (const QString& text : list) all.insert(fromQt(text));
  return all;
}

std::vector<std::string> toVector(const QStringList& list) {
  std::vector<std::string> all;
  for (const QString& text : list) all.push_back(fromQt(text));
  return all;
}

}  // namespace

struct CatalogPanel::Impl : public QObject {
  CatalogPanel* self;
  Editor& editor;
  CatalogModel model;
  Favourites favourites;
  int subscription = 0;
  BackgroundJob* reading = nullptr;
  bool readAgain = false;  // when that is done
  std::set<std::string> problemsTold;

  QLineEdit* search = nullptr;
  QToolButton* sizeButton = nullptr;
  QWidget* sizeRow = nullptr;
  QLabel* sizeLabels[3] = {};
  LengthField* sizes[3] = {};
  QToolButton* anySize = nullptr;
  ChipRow* chips = nullptr;
  QSplitter* splitter = nullptr;
  CategoryList* categories = nullptr;
  PieceGrid* grid = nullptr;
  QLabel* status = nullptr;
  QPushButton* import = nullptr;

  Impl(CatalogPanel* panel, Editor& e) : self(panel), editor(e) {}

  void build(ThumbnailStore& thumbnails);
  void retranslate();
  void readLibraries(bool again);
  void applyQuery();
  void onFiltered();
  void onSettings();
  void place(const CatalogPiecePtr& piece);
  void showMenu(const CatalogPiecePtr& piece, QPoint at);
  void askToDelete(const CatalogPiecePtr& piece);
  QString describe(const CatalogPiece& piece) const;
  void layOut();
  bool eventFilter(QObject* object, QEvent* event) override;
};

void CatalogPanel::Impl::build(ThumbnailStore& thumbnails) {
  search = new QLineEdit;
  search->setObjectName(QStringLiteral("catalogSearch"));
  search->setClearButtonEnabled(true);
  search->installEventFilter(this);
  sizeButton = new QToolButton;
  sizeButton->setObjectName(QStringLiteral("catalogSizeFilter"));
  sizeButton->setCheckable(true);
  sizeButton->setToolButtonStyle(Qt::ToolButtonTextOnly);
  auto* top = new QHBoxLayout;
  top->addWidget(search, 1);
  top->addWidget(sizeButton);

  sizeRow = new QWidget;
  auto* sizeLayout = new QHBoxLayout(sizeRow);
  sizeLayout->setContentsMargins(0, 0, 0, 0);
  sizeLayout->setSpacing(3);
  static constexpr const char* kNames[] = {"catalogMaxWidth", "catalogMaxDepth", "catalogMaxHeight"};
  for (int i = 0; i < 3; ++i) {
    sizeLabels[i] = new QLabel;
    sizes[i] = new LengthField(nullptr, editor.settings().unit);
    sizes[i]->setObjectName(QString::fromLatin1(kNames[i]));
    sizes[i]->setOptional(true);
    sizes[i]->setNone();
    sizes[i]->setRange(0.01, 100);
    sizeLabels[i]->setBuddy(sizes[i]);
    sizeLayout->addWidget(sizeLabels[i]);
    sizeLayout->addWidget(sizes[i], 1);
    connect(sizes[i], &ValueField::valueChanged, this, [this] { applyQuery(); });
    connect(sizes[i], &ValueField::cleared, this, [this] { applyQuery(); });
  }
  anySize = new QToolButton;
  anySize->setObjectName(QStringLiteral("catalogAnySize"));
  anySize->setText(QStringLiteral("✕"));
  anySize->setAutoRaise(true);
  sizeLayout->addWidget(anySize);
  sizeRow->hide();

  chips = new ChipRow;
  chips->setObjectName(QStringLiteral("catalogTags"));
  categories = new CategoryList;
  categories->setObjectName(QStringLiteral("catalogCategories"));
  grid = new PieceGrid(model, thumbnails);
  grid->setObjectName(QStringLiteral("catalogGrid"));
  grid->describe = [this](const CatalogPiece& piece) { return describe(piece); };
  splitter = new QSplitter(Qt::Vertical);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(categories);
  splitter->addWidget(grid);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({190, 460});

  status = new QLabel;
  status->setObjectName(QStringLiteral("catalogStatus"));
  status->setForegroundRole(QPalette::PlaceholderText);
  status->setMinimumWidth(1);
  import = new QPushButton;
  import->setObjectName(QStringLiteral("catalogImport"));
  import->setAutoDefault(false);
  auto* bottom = new QHBoxLayout;
  bottom->addWidget(status, 1);
  bottom->addWidget(import);

  auto* layout = new QVBoxLayout(self);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->setSpacing(4);
  layout->addLayout(top);
  layout->addWidget(sizeRow);
  layout->addWidget(chips);
  layout->addWidget(splitter, 1);
  layout->addLayout(bottom);

  connect(search, &QLineEdit::textChanged, this, [this](const QString& text) {
    // Looked for everywhere: a word that the chosen category does not know would find nothing.
    if (!text.isEmpty() && model.query().words.empty()) {
      const QSignalBlocker quiet(categories);
      categories->choose(CategoryList::kAll);
    }
    applyQuery();
  });
  connect(search, &QLineEdit::returnPressed, this, [this] {
    if (const CatalogPiecePtr first = model.piece(model.index(0))) place(first);
  });
  connect(sizeButton, &QToolButton::toggled, this, [this](bool on) {
    sizeRow->setVisible(on);
    if (on) sizes[0]->setFocus();
    applyQuery();
  });
  connect(anySize, &QToolButton::clicked, this, [this] {
    for (LengthField* field : sizes) field->setNone();
    applyQuery();
  });
  connect(chips, &ChipRow::changed, this, [this] { applyQuery(); });
  connect(categories, &CategoryList::chosenChanged, this, [this] {
    chips->setChips({}, {});
    applyQuery();
    grid->scrollToTop();
  });
  connect(grid, &PieceGrid::chosen, this, [this](const CatalogPiecePtr& piece) { place(piece); });
  connect(grid, &PieceGrid::dropped, this,
          [this](const CatalogPiecePtr& piece) { favourites.addRecent(toQt(piece->id)); });
  connect(grid, &PieceGrid::menuRequested, this,
          [this](const CatalogPiecePtr& piece, QPoint at) { showMenu(piece, at); });
  connect(import, &QPushButton::clicked, self, &CatalogPanel::importRequested);
  connect(&model, &CatalogModel::filtered, this, [this] { onFiltered(); });
  connect(&favourites, &Favourites::changed, this, [this] {
    model.setLiked(toSet(favourites.liked()));
    if (categories->chosen() == CategoryList::kLiked) applyQuery();
    onFiltered();
  });
  self->installEventFilter(this);
}

void CatalogPanel::Impl::retranslate() {
  search->setPlaceholderText(CatalogPanel::tr("Search furniture"));
  search->setToolTip(CatalogPanel::tr(
      "Names, tags, categories and creators, in English or Thai. Enter places the first piece found"));
  search->setAccessibleName(CatalogPanel::tr("Search furniture"));
  sizeButton->setText(CatalogPanel::tr("Size"));
  sizeButton->setToolTip(CatalogPanel::tr("Show only pieces that fit into a space"));
  const QString letters[] = {CatalogPanel::tr("W", "width"), CatalogPanel::tr("D", "depth"),
                             CatalogPanel::tr("H", "height")};
  const QString tips[] = {CatalogPanel::tr("At most this wide; empty: any width"),
                          CatalogPanel::tr("At most this deep; empty: any depth"),
                          CatalogPanel::tr("At most this high; empty: any height")};
  for (int i = 0; i < 3; ++i) {
    sizeLabels[i]->setText(letters[i]);
    sizes[i]->setToolTip(tips[i]);
  }
  anySize->setToolTip(CatalogPanel::tr("Any size"));
  categories->setToolTip(CatalogPanel::tr("Kinds of furniture"));
  categories->setAccessibleName(CatalogPanel::tr("Categories"));
  grid->setAccessibleName(CatalogPanel::tr("Furniture"));
  grid->setEmptyText(CatalogPanel::tr("Nothing found. Try fewer words, another category or any size."));
  import->setText(CatalogPanel::tr("Import…"));
  import->setToolTip(CatalogPanel::tr("Bring in a furniture library or a model file of your own"));
  onFiltered();
}

// The built-in pieces at once; those of the libraries when they are read.
void CatalogPanel::Impl::readLibraries(bool again) {
  if (reading) {
    readAgain = again;
    return;
  }
  const auto catalog = editor.sharedCatalog();
  reading = runInBackground<CatalogModel::Contents>(
      this, CatalogPanel::tr("Reading furniture libraries"),
      [catalog, again](const Progress&) {
        if (again) catalog->reread();
        return CatalogModel::contentsOf(*catalog, true);
      },
      [this](CatalogModel::Contents contents) {
        reading = nullptr;
        model.setContents(std::move(contents));
        if (std::exchange(readAgain, false)) readLibraries(true);
        for (const std::string& problem : editor.catalog().problems())
          if (problemsTold.insert(problem).second)
            editor.say({QT_TRANSLATE_NOOP("idap", "A furniture library cannot be read: %1"), {problem}},
                       Editor::Severity::Warning);
      },
      [this](std::exception_ptr) {
        reading = nullptr;
        onFiltered();
      });
}

void CatalogPanel::Impl::applyQuery() {
  PieceQuery query;
  query.words = fromQt(search->text());
  const std::string chosen = categories->chosen();
  if (chosen == CategoryList::kLiked) {
    query.only = toVector(favourites.liked());
  } else if (chosen == CategoryList::kRecent) {
    query.only = toVector(favourites.recent());
  } else {
    query.category = chosen;
  }
  if (sizeRow->isVisibleTo(self))
    for (int i = 0; i < 3; ++i)
      if (!sizes[i]->none()) query.maxSize[i] = sizes[i]->value();
  query.tags = chips->on();
  const CatalogPiecePtr before = grid->currentPiece();
  model.setQuery(std::move(query));
  // The first hit is what Enter places.
  QModelIndex current = before ? model.indexOf(before->id) : QModelIndex();
  if (!search->text().isEmpty() && search->hasFocus()) current = model.index(0);
  if (current.isValid()) grid->setCurrentIndex(current);
}

void CatalogPanel::Impl::onFiltered() {
  std::size_t liked = 0, recent = 0;
  for (const QString& id : favourites.liked()) liked += model.find(fromQt(id)) != nullptr;
  for (const QString& id : favourites.recent()) recent += model.find(fromQt(id)) != nullptr;
  categories->show({model.passing(), liked, recent, model.categories()});
  std::vector<ChipRow::Chip> tags;
  std::vector<std::string> useful = usefulTags(model.beforeTags(), kChips);
  for (const std::string& tag : chips->on())
    if (std::find(useful.begin(), useful.end(), tag) == useful.end()) useful.insert(useful.begin(), tag);
  for (const std::string& tag : useful) tags.push_back({tag, tagName(tag)});
  chips->setChips(std::move(tags), chips->on());
  const QString count = CatalogPanel::tr("Pieces: %1").arg(model.rowCount());
  status->setText(reading ? CatalogPanel::tr("Reading libraries…") : count);
  status->setToolTip(count);
}

void CatalogPanel::Impl::onSettings() {
  for (LengthField* field : sizes) field->setUnit(editor.settings().unit);
  model.setLanguage(editor.settings().language);
}

void CatalogPanel::Impl::place(const CatalogPiecePtr& piece) {
  std::optional<Vec2> near;
  const PointerEvent& last = editor.lastPointer();
  if (last.plane == Plane::XY && !(last.at == Vec2{})) near = last.at;
  if (placeAutomatically(editor, *piece, near)) favourites.addRecent(toQt(piece->id));
}

void CatalogPanel::Impl::showMenu(const CatalogPiecePtr& piece, QPoint at) {
  QMenu menu;
  menu.setObjectName(QStringLiteral("catalogMenu"));
  menu.setToolTipsVisible(true);
  menu.addAction(CatalogPanel::tr("Place in the room"), this, [this, piece] { place(piece); })
      ->setToolTip(CatalogPanel::tr("Puts it where it fits"));
  menu.addAction(CatalogPanel::tr("Place with the pointer"), this,
                 [this, piece] {
                   editor.setTool(makePlaceTool(piece, false));
                   favourites.addRecent(toQt(piece->id));
                 })
      ->setToolTip(
          CatalogPanel::tr("It follows the pointer and stays where you click, as often as you like"));
  menu.addSeparator();
  const QString id = toQt(piece->id);
  QAction* like = menu.addAction(CatalogPanel::tr("Favourite"));
  like->setCheckable(true);
  like->setChecked(favourites.isLiked(id));
  connect(like, &QAction::toggled, this, [this, id](bool on) { favourites.setLiked(id, on); });
  if (OwnFurnitureDialog::isOwn(piece->id)) {
    menu.addSeparator();
    menu.addAction(CatalogPanel::tr("Change…"), this, [this, piece] {
      auto* dialog = new OwnFurnitureDialog(editor, piece->id, self);
      dialog->setAttribute(Qt::WA_DeleteOnClose);
      connect(dialog, &OwnFurnitureDialog::saved, self, &CatalogPanel::reload);
      dialog->open();
    });
    menu.addAction(CatalogPanel::tr("Delete…"), this, [this, piece] { askToDelete(piece); });
  }
  menu.exec(at);
}

void CatalogPanel::Impl::askToDelete(const CatalogPiecePtr& piece) {
  auto* box = new QMessageBox(
      QMessageBox::Question, CatalogPanel::tr("Delete furniture"),
      CatalogPanel::tr("Delete %1 from the catalog?").arg(toQt(piece->nameIn(editor.settings().language))),
      QMessageBox::Yes | QMessageBox::Cancel, self);
  box->setObjectName(QStringLiteral("deleteOwn"));
  box->setInformativeText(CatalogPanel::tr("Homes that it stands in keep it."));
  box->setAttribute(Qt::WA_DeleteOnClose);
  connect(box, &QMessageBox::finished, this, [this, piece](int answer) {
    if (answer != QMessageBox::Yes) return;
    try {
      OwnLibrary library;
      if (usesOwnFurniture(editor.home()))
        editor.document().amend([&library](const Home& home) { return withOwnModels(home, library); });
      library.remove(piece->id);
      library.save();
    } catch (const Error& error) {
      editor.say({QT_TRANSLATE_NOOP("idap", "The catalog could not be changed: %1"), {error.what()}},
                 Editor::Severity::Error);
    }
    self->reload();
  });
  box->open();
}

QString CatalogPanel::Impl::describe(const CatalogPiece& piece) const {
  const LengthUnit unit = editor.settings().unit;
  QStringList lines;
  lines << QStringLiteral("<b>%1</b>").arg(toQt(piece.nameIn(editor.settings().language)).toHtmlEscaped());
  lines << QStringLiteral("%1 × %2 × %3")
               .arg(lengthText(piece.size.x, unit), lengthText(piece.size.y, unit),
                    lengthText(piece.size.z, unit))
               .toHtmlEscaped();
  if (piece.price)
    lines << CatalogPanel::tr("Price: %1 %2")
                 .arg(QLocale().toString(*piece.price, 'f', 2), toQt(editor.home().currency))
                 .toHtmlEscaped();
  if (!piece.creator.empty()) lines << CatalogPanel::tr("By %1").arg(toQt(piece.creator)).toHtmlEscaped();
  if (!piece.license.empty())
    lines << CatalogPanel::tr("Licence: %1").arg(toQt(piece.license).left(80)).toHtmlEscaped();
  if (!piece.library.empty())
    lines << CatalogPanel::tr("Library: %1").arg(toQt(piece.library)).toHtmlEscaped();
  return lines.join(QStringLiteral("<br>"));
}

void CatalogPanel::Impl::layOut() {
  const bool wide = self->width() >= kSideBySide * self->fontMetrics().height();
  const Qt::Orientation wanted = wide ? Qt::Horizontal : Qt::Vertical;
  if (splitter->orientation() == wanted) return;
  splitter->setOrientation(wanted);
  splitter->setSizes(wide ? QList<int>{200, self->width() - 200} : QList<int>{190, 460});
}

bool CatalogPanel::Impl::eventFilter(QObject* object, QEvent* event) {
  if (object == self && event->type() == QEvent::Resize) layOut();
  if (event->type() != QEvent::KeyPress) return false;
  const auto* key = static_cast<QKeyEvent*>(event);
  if (object == search && key->key() == Qt::Key_Down && model.rowCount() > 0) {
    grid->setFocus(Qt::TabFocusReason);
    grid->setCurrentIndex(model.index(0));
    return true;
  }
  if (object == search && key->key() == Qt::Key_Escape && !search->text().isEmpty()) {
    search->clear();
    return true;
  }
  return false;
}

CatalogPanel::CatalogPanel(Editor& editor, ThumbnailStore& thumbnails, QWidget* parent)
    : QWidget(parent), impl_(std::make_unique<Impl>(this, editor)) {
  setObjectName(QStringLiteral("catalogPanel"));
  impl_->model.setLanguage(editor.settings().language);
  impl_->model.setLiked(toSet(impl_->favourites.liked()));
  impl_->build(thumbnails);
  setFocusProxy(impl_->search);
  impl_->model.setContents(CatalogModel::contentsOf(editor.catalog(), editor.catalog().librariesRead()));
  impl_->retranslate();
  if (!impl_->model.complete()) QTimer::singleShot(0, impl_.get(), [this] { impl_->readLibraries(false); });
  impl_->subscription = editor.subscribe({.changed = [this](Editor::Change change) {
    if (change == Editor::Change::Settings) impl_->onSettings();
  }});
}

CatalogPanel::~CatalogPanel() {
  impl_->editor.unsubscribe(impl_->subscription);
  removeEventFilter(impl_.get());
}

void CatalogPanel::focusSearch() {
  impl_->search->setFocus(Qt::ShortcutFocusReason);
  impl_->search->selectAll();
}

void CatalogPanel::reload() { impl_->readLibraries(true); }

void CatalogPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) impl_->retranslate();
  if (event->type() == QEvent::FontChange) impl_->layOut();
}

}  // namespace idap
