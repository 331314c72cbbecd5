#include "studio/widgets/material_list.h"

#include <QDrag>
#include <QKeyEvent>
#include <QMimeData>
#include <QScrollBar>
#include <QStandardItemModel>
#include <QStyledItemDelegate>

#include "catalog/material.h"
#include "studio/widgets/material_swatches.h"
#include "studio/widgets/mime_types.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

enum Role { IdRole = Qt::UserRole, HeaderRole };

constexpr int kDragged = 64;  // pixels of the swatch beside the pointer
constexpr int kSwatch = 13;   // letters wide, at least

// A swatch with its name under it, or the title of a group over the whole width.
class Delegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const auto* view = static_cast<const QListView*>(option.widget);
    const int width = view->viewport()->width() - 1;
    const int line = option.fontMetrics.height();
    if (index.data(HeaderRole).toBool()) return {width, line * 3 / 2};
    const int columns = std::max(1, width / (kSwatch * option.fontMetrics.averageCharWidth()));
    const int side = width / columns;
    return {side, side * 3 / 5 + line + 4};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    painter->save();
    const QString name = index.data(Qt::DisplayRole).toString();
    const QFontMetrics& metrics = option.fontMetrics;
    if (index.data(HeaderRole).toBool()) {
      QFont bold = option.font;
      bold.setBold(true);
      painter->setFont(bold);
      painter->setPen(option.palette.color(QPalette::Active, QPalette::Text));
      painter->drawText(option.rect.adjusted(3, 0, 0, -2), Qt::AlignLeft | Qt::AlignBottom, name);
      painter->restore();
      return;
    }
    const bool chosen = option.state & QStyle::State_Selected;
    const bool hovered = option.state & QStyle::State_MouseOver;
    if (chosen || hovered) {
      QColor ground = option.palette.color(QPalette::Highlight);
      if (!chosen) ground.setAlphaF(0.3f);
      painter->fillRect(option.rect.adjusted(1, 1, -1, -1), ground);
    }
    const int line = metrics.height();
    const QRect box = option.rect.adjusted(4, 4, -4, -line - 3);
    const QPixmap swatch = MaterialSwatches::shared().material(fromQt(index.data(IdRole).toString()));
    if (!swatch.isNull()) {
      painter->setRenderHint(QPainter::SmoothPixmapTransform);
      // Its middle: squeezed, wood would look like another wood.
      const double share = static_cast<double>(box.height()) / box.width();
      const QRectF part(0, swatch.height() * (1 - share) / 2, swatch.width(), swatch.height() * share);
      painter->drawPixmap(QRectF(box), swatch, part);
    }
    QColor frame = option.palette.color(QPalette::Text);
    frame.setAlphaF(0.35f);
    painter->setPen(frame);
    painter->setBrush(Qt::NoBrush);
    painter->drawRect(box.adjusted(0, 0, -1, -1));
    painter->setPen(option.palette.color(chosen ? QPalette::HighlightedText : QPalette::Text));
    const QRect words(option.rect.left() + 2, option.rect.bottom() - line - 1, option.rect.width() - 4, line);
    painter->drawText(words, Qt::AlignHCenter | Qt::AlignVCenter,
                      metrics.elidedText(name, Qt::ElideRight, words.width()));
    painter->restore();
  }
};

bool holdsWords(const QString& text, const QString& query) {
  for (const QString& word : query.split(QLatin1Char(' '), Qt::SkipEmptyParts))
    if (!text.contains(word, Qt::CaseInsensitive)) return false;
  return true;
}

}  // namespace

QString MaterialList::groupName(const std::string& group) {
  static const std::map<std::string, const char*> kNames{
      {"wood", QT_TRANSLATE_NOOP("idap", "Wood")},
      {"lacquer", QT_TRANSLATE_NOOP("idap", "Lacquer")},
      {"paint", QT_TRANSLATE_NOOP("idap", "Paint")},
      {"metal", QT_TRANSLATE_NOOP("idap", "Metal")},
      {"glass", QT_TRANSLATE_NOOP("idap", "Glass")},
      {"fabric", QT_TRANSLATE_NOOP("idap", "Fabric")},
      {"floor", QT_TRANSLATE_NOOP("idap", "Floor")},
      {"stone", QT_TRANSLATE_NOOP("idap", "Stone")},
      {"ceramic", QT_TRANSLATE_NOOP("idap", "Tiles and ceramic")},
      {"plastic", QT_TRANSLATE_NOOP("idap", "Plastic")},
      {"plant", QT_TRANSLATE_NOOP("idap", "Plants")},
      {"light", QT_TRANSLATE_NOOP("idap", "Light")},
      {"art", QT_TRANSLATE_NOOP("idap", "Pictures")}};
  const auto at = kNames.find(group);
  return at == kNames.end() ? toQt(group) : translated(at->second);
}

MaterialList::MaterialList(QWidget* parent) : QListView(parent) {
  setFlow(QListView::LeftToRight);
  setWrapping(true);
  setResizeMode(QListView::Adjust);
  setMouseTracking(true);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setItemDelegate(new Delegate(this));
  setModel(new QStandardItemModel(this));
  verticalScrollBar()->setSingleStep(fontMetrics().height());
  connect(&MaterialSwatches::shared(), &MaterialSwatches::ready, viewport(),
          [view = viewport()] { view->update(); });
  connect(this, &QListView::clicked, this, [this](const QModelIndex& index) {
    if (const QString id = index.data(IdRole).toString(); !id.isEmpty()) emit chosen(id);
  });
  connect(this, &QListView::doubleClicked, this, [this](const QModelIndex& index) {
    if (const QString id = index.data(IdRole).toString(); !id.isEmpty()) emit confirmed(id);
  });
}

void MaterialList::setLanguage(const std::string& language) { language_ = language; }

std::string MaterialList::current() const { return fromQt(currentIndex().data(IdRole).toString()); }

int MaterialList::count() const {
  int materials = 0;
  for (int i = 0; i < model()->rowCount(); ++i) materials += !model()->index(i, 0).data(HeaderRole).toBool();
  return materials;
}

void MaterialList::fill(const QString& query, const std::string& wanted) {
  auto* shown = static_cast<QStandardItemModel*>(model());
  shown->clear();
  std::vector<std::string> groups;
  std::map<std::string, std::vector<std::string>> members;
  for (const std::string& id : materialIds()) {
    const std::string group = materialGroup(id);
    const QString words = toQt(materialName(id, language_)) + QLatin1Char(' ') + toQt(id) + QLatin1Char(' ') +
                          groupName(group) + QLatin1Char(' ') + toQt(materialName(id, "en"));
    if (!holdsWords(words, query)) continue;
    if (!members.contains(group)) groups.push_back(group);
    members[group].push_back(id);
  }
  QModelIndex current;
  for (const std::string& group : groups) {
    auto* head = new QStandardItem(groupName(group));
    head->setData(true, HeaderRole);
    head->setFlags(Qt::NoItemFlags);
    shown->appendRow(head);
    for (const std::string& id : members[group]) {
      const QString name = toQt(materialName(id, language_));
      auto* item = new QStandardItem(name);
      item->setData(toQt(id), IdRole);
      item->setToolTip(name);
      item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled);
      shown->appendRow(item);
      if (id == wanted || (!current.isValid() && !query.isEmpty())) current = item->index();
    }
  }
  if (!current.isValid()) return;
  setCurrentIndex(current);
  scrollTo(current, QAbstractItemView::PositionAtCenter);
}

void MaterialList::keyPressEvent(QKeyEvent* event) {
  if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && !current().empty()) {
    emit confirmed(toQt(current()));
    return;
  }
  QListView::keyPressEvent(event);
}

void MaterialList::startDrag(Qt::DropActions) {
  const std::string id = current();
  if (id.empty()) return;
  auto* mime = new QMimeData;
  mime->setData(QString::fromLatin1(kMaterialMime), QByteArray::fromStdString(id));
  auto* drag = new QDrag(this);
  drag->setMimeData(mime);
  if (QPixmap swatch = MaterialSwatches::shared().material(id); !swatch.isNull()) {
    const qreal scale = devicePixelRatioF();
    swatch = swatch.scaledToWidth(qRound(kDragged * scale), Qt::SmoothTransformation);
    swatch.setDevicePixelRatio(scale);
    drag->setPixmap(swatch);
    drag->setHotSpot({-12, -12});  // beside the pointer, so that what it points at stays seen
  }
  drag->exec(Qt::CopyAction);
}

}  // namespace idap
