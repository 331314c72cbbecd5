#include "studio/catalog/category_list.h"

#include <QStyledItemDelegate>

#include "studio/widgets/icons.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr const char* kHeading = "*libraries";

enum Role { IdRole = Qt::UserRole, CountRole };

// A name on the left, a number on the right.
class CountDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyleOptionViewItem plain = option;
    initStyleOption(&plain, index);
    const QString name = plain.text;
    plain.text.clear();
    const QWidget* widget = option.widget;
    widget->style()->drawControl(QStyle::CE_ItemViewItem, &plain, painter, widget);
    painter->save();
    painter->setFont(plain.font);
    const bool heading = !(index.flags() & Qt::ItemIsSelectable);
    const bool selected = option.state & QStyle::State_Selected;
    const QPalette::ColorGroup group =
        option.state & QStyle::State_Active ? QPalette::Active : QPalette::Inactive;
    QColor color = option.palette.color(group, selected ? QPalette::HighlightedText : QPalette::Text);
    QColor faint = color;
    faint.setAlphaF(0.6f);
    const int indent = heading ? 6 : option.decorationSize.width() + 12;
    const QRect area = option.rect.adjusted(indent, 0, -8, 0);
    int right = area.right();
    if (!heading) {
      const QString count = index.data(CountRole).toString();
      painter->setPen(faint);
      painter->drawText(area, Qt::AlignRight | Qt::AlignVCenter, count);
      right -= plain.fontMetrics.horizontalAdvance(count) + 8;
    }
    const bool none = !heading && index.data(CountRole).toULongLong() == 0;
    painter->setPen(heading || none ? faint : color);
    const int width = right - area.left();
    painter->drawText(QRect(area.left(), area.top(), width, area.height()), Qt::AlignLeft | Qt::AlignVCenter,
                      plain.fontMetrics.elidedText(name, Qt::ElideRight, width));
    painter->restore();
  }

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const QSize size = QStyledItemDelegate::sizeHint(option, index);
    return {1, std::max(size.height(), option.fontMetrics.height() + 6)};
  }
};

QIcon iconOf(const std::string& id) {
  if (id == CategoryList::kAll) return icon("furniture");
  if (id == CategoryList::kLiked) return icon("favourite");
  if (id == CategoryList::kRecent) return icon("recent");
  if (id == kHeading) return {};
  const QIcon own = icon(("category-" + id).c_str());
  return own.isNull() ? icon("category-other") : own;
}

struct Row {
  std::string id;
  QString name;
  std::size_t count = 0;
  bool heading = false;
};

}  // namespace

CategoryList::CategoryList(QWidget* parent) : QListWidget(parent) {
  setItemDelegate(new CountDelegate(this));
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setUniformItemSizes(true);
  connect(this, &QListWidget::currentItemChanged, this, &CategoryList::chosenChanged);
}

void CategoryList::show(const Counts& counts) {
  std::vector<Row> rows{{kAll, tr("All furniture"), counts.all},
                        {kLiked, tr("Favourites"), counts.liked},
                        {kRecent, tr("Recently used"), counts.recent}};
  bool builtin = true;
  for (const auto& category : counts.categories) {
    if (builtin && !category.builtin) rows.push_back({kHeading, tr("From libraries"), 0, true});
    builtin = category.builtin;
    rows.push_back({category.id, category.name, category.count});
  }
  const std::string before = chosen();
  {
    const QSignalBlocker quiet(this);
    while (count() > static_cast<int>(rows.size())) delete takeItem(count() - 1);
    while (count() < static_cast<int>(rows.size())) addItem(new QListWidgetItem);
    for (int i = 0; i < count(); ++i) {
      const Row& row = rows[static_cast<std::size_t>(i)];
      QListWidgetItem* entry = item(i);
      entry->setText(row.name);
      entry->setToolTip(row.heading ? QString() : row.name);
      entry->setData(IdRole, toQt(row.id));
      if (const QString id = toQt(row.id); entry->icon().isNull() || entry->data(IdRole).toString() != id)
        entry->setIcon(iconOf(row.id));
      entry->setData(CountRole, qulonglong(row.count));
      entry->setFlags(row.heading ? Qt::ItemFlags() : Qt::ItemIsEnabled | Qt::ItemIsSelectable);
      entry->setData(Qt::AccessibleTextRole,
                     row.heading ? row.name : QStringLiteral("%1 (%2)").arg(row.name).arg(row.count));
    }
    choose(before);
  }
  if (chosen() != before) emit chosenChanged();
}

std::string CategoryList::chosen() const {
  const QListWidgetItem* entry = currentItem();
  return entry ? fromQt(entry->data(IdRole).toString()) : std::string(kAll);
}

void CategoryList::choose(const std::string& id) {
  for (int i = 0; i < count(); ++i)
    if (fromQt(item(i)->data(IdRole).toString()) == id) {
      setCurrentRow(i);
      return;
    }
  setCurrentRow(0);
}

}  // namespace idap
