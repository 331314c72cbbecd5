#include "studio/lists/furniture_list.h"

#include <QHeaderView>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QSettings>
#include <QSortFilterProxyModel>
#include <QTreeView>

#include "catalog/search_text.h"
#include "editor/commands/command.h"
#include "editor/selection.h"
#include "studio/lists/piece_table.h"
#include "studio/widgets/icons.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr int kRefresh = 120;  // ms: a drag brings sixty changes a second
const QString kHeaderKey = QStringLiteral("furnitureList/header");

// Sorted by any column, filtered by words in what people remember of a piece.
class PieceOrder : public QSortFilterProxyModel {
 public:
  PieceOrder(const PieceTable& table, QObject* parent) : QSortFilterProxyModel(parent), table_(table) {
    setRecursiveFilteringEnabled(true);
    setAutoAcceptChildRows(true);
    setSortRole(PieceTable::SortRole);
    setSortLocaleAware(true);
    setSortCaseSensitivity(Qt::CaseInsensitive);
  }

  void setWords(const QString& text) {
    words_ = searchWords(fromQt(text));
    invalidateFilter();
  }

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    if (words_.empty()) return true;
    std::string text;
    for (const PieceColumn column :
         {PieceColumn::Name, PieceColumn::Kind, PieceColumn::Level, PieceColumn::Creator}) {
      const QModelIndex index = table_.index(row, static_cast<int>(column), parent);
      text += foldedText(fromQt(table_.data(index, Qt::DisplayRole).toString())) + '\n';
    }
    return std::all_of(words_.begin(), words_.end(),
                       [&](const std::string& word) { return text.find(word) != std::string::npos; });
  }

 private:
  const PieceTable& table_;
  std::vector<std::string> words_;
};

// Rows next to each other become one range: thousands are selected at once.
QItemSelection rowsSelected(const QAbstractItemModel& model, std::vector<QModelIndex> rows) {
  std::sort(rows.begin(), rows.end(), [](const QModelIndex& a, const QModelIndex& b) {
    return a.parent() == b.parent() ? a.row() < b.row() : a.parent() < b.parent();
  });
  QItemSelection selection;
  for (std::size_t i = 0; i < rows.size();) {
    std::size_t last = i;
    while (last + 1 < rows.size() && rows[last + 1].parent() == rows[i].parent() &&
           rows[last + 1].row() == rows[last].row() + 1)
      ++last;
    const QModelIndex parent = rows[i].parent();
    selection.append(QItemSelectionRange(model.index(rows[i].row(), 0, parent),
                                         model.index(rows[last].row(), model.columnCount() - 1, parent)));
    i = last + 1;
  }
  return selection;
}

QString csvField(QString text) {
  if (!text.contains(u'"') && !text.contains(u',') && !text.contains(u'\n') && !text.contains(u'\r') &&
      text == text.trimmed())
    return text;
  return u'"' + text.replace(u'"', QStringLiteral("\"\"")) + u'"';
}

}  // namespace

struct FurnitureList::Impl : public QObject {
  FurnitureList* self;
  Editor& editor;
  PieceTable table;
  PieceOrder order;
  QTreeView* view = nullptr;
  QLineEdit* filter = nullptr;
  QLabel* count = nullptr;
  QLabel* total = nullptr;
  QTimer timer;
  int subscription = 0;
  bool stale = false;  // the home has changed since
  bool selectionStale = false;
  bool following = false;  // the rows are being selected as on the plans
  bool leading = false;    // the plans are being selected as here

  Impl(FurnitureList* list, Editor& e) : self(list), editor(e), table(e), order(table, nullptr) {
    order.setSourceModel(&table);
  }

  void build();
  void retranslate();
  void onChange(Editor::Change change);
  void refresh();
  void showTotals();
  void followSelection();
  void leadSelection();
  void resetColumns();
  void saveHeader();
  void showColumnMenu(QPoint at);
  void showRowMenu(QPoint at);
  std::vector<PieceColumn> columnsShown() const;
};

void FurnitureList::Impl::build() {
  view = new QTreeView;
  view->setObjectName(QStringLiteral("furnitureTable"));
  view->setModel(&order);
  view->setUniformRowHeights(true);
  view->setSelectionMode(QAbstractItemView::ExtendedSelection);
  view->setSelectionBehavior(QAbstractItemView::SelectRows);
  view->setSortingEnabled(true);
  view->setAlternatingRowColors(true);
  view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  view->setExpandsOnDoubleClick(false);
  view->setAllColumnsShowFocus(true);
  view->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  view->setContextMenuPolicy(Qt::CustomContextMenu);
  QHeaderView* header = view->header();
  header->setObjectName(QStringLiteral("furnitureHeader"));
  header->setSectionsMovable(true);
  header->setFirstSectionMovable(true);
  header->setStretchLastSection(false);
  header->setContextMenuPolicy(Qt::CustomContextMenu);
  header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  resetColumns();
  if (const QByteArray state = QSettings().value(kHeaderKey).toByteArray(); !state.isEmpty())
    header->restoreState(state);

  filter = new QLineEdit;
  filter->setObjectName(QStringLiteral("furnitureFilter"));
  filter->setClearButtonEnabled(true);
  filter->setMaximumWidth(filter->fontMetrics().averageCharWidth() * 36);
  count = new QLabel;
  count->setObjectName(QStringLiteral("furnitureCount"));
  total = new QLabel;
  total->setObjectName(QStringLiteral("furnitureTotal"));
  auto* bottom = new QHBoxLayout;
  bottom->setContentsMargins(4, 2, 8, 4);
  bottom->setSpacing(16);
  bottom->addWidget(filter, 1);
  bottom->addStretch(0);
  bottom->addWidget(count);
  bottom->addWidget(total);
  auto* layout = new QVBoxLayout(self);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(view, 1);
  layout->addLayout(bottom);

  timer.setSingleShot(true);
  timer.setInterval(kRefresh);
  connect(&timer, &QTimer::timeout, this, [this] { refresh(); });
  connect(filter, &QLineEdit::textChanged, this, [this](const QString& text) {
    order.setWords(text);
    if (!text.isEmpty()) view->expandAll();
    followSelection();
  });
  connect(view->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] { leadSelection(); });
  connect(header, &QHeaderView::customContextMenuRequested, this, [this](QPoint at) { showColumnMenu(at); });
  connect(header, &QHeaderView::sectionMoved, this, [this] { saveHeader(); });
  connect(header, &QHeaderView::sortIndicatorChanged, this, [this] { saveHeader(); });
  connect(view, &QWidget::customContextMenuRequested, this, [this](QPoint at) { showRowMenu(at); });
}

void FurnitureList::Impl::resetColumns() {
  QHeaderView* header = view->header();
  const int unit = view->fontMetrics().averageCharWidth();
  for (int i = 0; i < kPieceColumns; ++i) {
    const auto column = static_cast<PieceColumn>(i);
    header->moveSection(header->visualIndex(i), i);
    header->setSectionHidden(i, !shownAtFirst(column));
    header->resizeSection(i, unit * (i == 0 ? 30 : isNumber(column) ? 12 : 14));
  }
  view->sortByColumn(0, Qt::AscendingOrder);
}

void FurnitureList::Impl::saveHeader() { QSettings().setValue(kHeaderKey, view->header()->saveState()); }

void FurnitureList::Impl::retranslate() {
  filter->setPlaceholderText(FurnitureList::tr("Filter"));
  filter->setToolTip(
      FurnitureList::tr("Show only pieces whose name, kind, level or creator holds these words"));
  filter->setAccessibleName(FurnitureList::tr("Filter"));
  view->setAccessibleName(FurnitureList::tr("Furniture, doors and windows"));
  showTotals();
}

void FurnitureList::Impl::onChange(Editor::Change change) {
  switch (change) {
    case Editor::Change::Home:
      stale = true;
      if (!timer.isActive()) timer.start();
      break;
    case Editor::Change::Selection:
      selectionStale = true;
      if (!leading && !timer.isActive()) QTimer::singleShot(0, this, [this] { refresh(); });
      break;
    case Editor::Change::Document:
    case Editor::Change::Settings:
      table.rebuild();
      stale = false;
      selectionStale = true;
      showTotals();
      followSelection();
      break;
    default:
      break;
  }
}

// Hidden behind another panel it waits until it is seen.
void FurnitureList::Impl::refresh() {
  if (!self->isVisible()) return;
  if (stale) {
    stale = false;
    following = true;  // rows that go are not deselected by the user
    table.refresh();
    following = false;
    showTotals();
    selectionStale = true;
  }
  if (selectionStale && !leading) followSelection();
}

void FurnitureList::Impl::showTotals() {
  const PieceTable::Totals totals = table.totals();
  count->setText(FurnitureList::tr("Pieces: %1").arg(totals.pieces));
  total->setText(FurnitureList::tr("Total %1 %2")
                     .arg(QLocale().toString(totals.price, 'f', 2), toQt(editor.home().currency)));
  total->setVisible(totals.priced);
}

void FurnitureList::Impl::followSelection() {
  selectionStale = false;
  std::vector<QModelIndex> rows;
  const auto want = [&](std::uint64_t id) {
    const QModelIndex index = order.mapFromSource(table.indexOf(id));
    if (index.isValid()) rows.push_back(index);
  };
  const Elements& selected = editor.selection();
  for (const FurnitureId id : selected.furniture) want(id.value);
  for (const OpeningId id : selected.openings) want(id.value);
  for (const GroupId id : selected.groups) want(id.value);
  following = true;
  const QModelIndex first = rows.empty() ? QModelIndex() : rows.front();
  view->selectionModel()->select(rowsSelected(order, std::move(rows)), QItemSelectionModel::ClearAndSelect);
  if (first.isValid()) {
    view->selectionModel()->setCurrentIndex(first, QItemSelectionModel::NoUpdate);
    view->scrollTo(first);
  }
  following = false;
}

void FurnitureList::Impl::leadSelection() {
  if (following) return;
  Elements elements;
  for (const QModelIndex& index : view->selectionModel()->selectedRows()) {
    const auto row = table.rowAt(order.mapToSource(index));
    if (!row) continue;
    if (const auto* furniture = std::get_if<FurnitureId>(&*row)) elements.furniture.push_back(*furniture);
    if (const auto* opening = std::get_if<OpeningId>(&*row)) elements.openings.push_back(*opening);
    if (const auto* group = std::get_if<GroupId>(&*row)) elements.groups.push_back(*group);
  }
  std::sort(elements.furniture.begin(), elements.furniture.end());
  std::sort(elements.openings.begin(), elements.openings.end());
  std::sort(elements.groups.begin(), elements.groups.end());
  leading = true;
  editor.select(std::move(elements));
  leading = false;
  selectionStale = false;
}

std::vector<PieceColumn> FurnitureList::Impl::columnsShown() const {
  std::vector<PieceColumn> columns;
  const QHeaderView* header = view->header();
  for (int i = 0; i < header->count(); ++i) {
    const int logical = header->logicalIndex(i);
    if (!header->isSectionHidden(logical)) columns.push_back(static_cast<PieceColumn>(logical));
  }
  return columns;
}

void FurnitureList::Impl::showColumnMenu(QPoint at) {
  QHeaderView* header = view->header();
  QMenu menu;
  menu.setObjectName(QStringLiteral("furnitureColumns"));
  menu.setToolTipsVisible(true);
  for (int i = 0; i < kPieceColumns; ++i) {
    const auto column = static_cast<PieceColumn>(i);
    QAction* action = menu.addAction(columnTitle(column));
    action->setToolTip(columnTip(column));
    action->setCheckable(true);
    action->setChecked(!header->isSectionHidden(i));
    action->setEnabled(header->isSectionHidden(i) || columnsShown().size() > 1);
    connect(action, &QAction::toggled, this, [this, i](bool on) {
      view->header()->setSectionHidden(i, !on);
      saveHeader();
    });
  }
  menu.addSeparator();
  menu.addAction(FurnitureList::tr("Usual columns"), this, [this] {
    resetColumns();
    saveHeader();
  });
  menu.exec(header->mapToGlobal(at));
}

void FurnitureList::Impl::showRowMenu(QPoint at) {
  QMenu menu;
  menu.setObjectName(QStringLiteral("furnitureMenu"));
  menu.setToolTipsVisible(true);
  const QModelIndex current = view->indexAt(at);
  if (current.isValid())
    menu.addAction(FurnitureList::tr("Rename"), this, [this, current] {
      view->setColumnHidden(0, false);
      view->edit(current.siblingAtColumn(0));
    });
  for (const Command& command : commands()) {
    if (!command.inContextMenu || (command.enabled && !command.enabled(editor))) continue;
    QAction* action = menu.addAction(icon(command.id), translated(command.name));
    action->setToolTip(translated(command.tip));
    if (command.checked) {
      action->setCheckable(true);
      action->setChecked(command.checked(editor));
    }
    connect(action, &QAction::triggered, this, [this, run = command.run] { run(editor); });
  }
  if (!menu.isEmpty()) menu.exec(view->viewport()->mapToGlobal(at));
}

FurnitureList::FurnitureList(Editor& editor, QWidget* parent)
    : QWidget(parent), impl_(std::make_unique<Impl>(this, editor)) {
  setObjectName(QStringLiteral("furnitureList"));
  impl_->build();
  impl_->retranslate();
  impl_->followSelection();
  impl_->subscription =
      editor.subscribe({.changed = [this](Editor::Change change) { impl_->onChange(change); }});
}

FurnitureList::~FurnitureList() {
  impl_->editor.unsubscribe(impl_->subscription);
  impl_->saveHeader();
}

std::string FurnitureList::csv() const {
  Impl& impl = *impl_;
  if (impl.stale) impl.table.refresh(), impl.stale = false;
  const std::vector<PieceColumn> columns = impl.columnsShown();
  QString text;
  const auto line = [&](const std::function<QString(PieceColumn)>& cell) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (i > 0) text += u',';
      text += csvField(cell(columns[i]));
    }
    text += QStringLiteral("\r\n");
  };
  line([&](PieceColumn column) { return exportTitle(impl.editor, column); });
  const std::function<void(const QModelIndex&)> walk = [&](const QModelIndex& parent) {
    for (int i = 0; i < impl.order.rowCount(parent); ++i) {
      const QModelIndex index = impl.order.index(i, 0, parent);
      if (const auto row = impl.table.rowAt(impl.order.mapToSource(index)))
        line([&](PieceColumn column) { return exportText(impl.editor, *row, column); });
      walk(index);
    }
  };
  walk({});
  return fromQt(text);
}

void FurnitureList::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::LanguageChange) return;
  impl_->table.rebuild();
  impl_->retranslate();
  impl_->followSelection();
}

void FurnitureList::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  impl_->refresh();
}

}  // namespace idap
