#include "studio/widgets/material_popup.h"

#include <QFormLayout>
#include <QHash>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListView>
#include <QScrollBar>
#include <QStandardItemModel>
#include <QStyledItemDelegate>

#include "catalog/material.h"
#include "studio/widgets/color_button.h"
#include "studio/widgets/length_field.h"
#include "studio/widgets/material_swatches.h"
#include "studio/widgets/slider_field.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

enum Role { IdRole = Qt::UserRole, HeaderRole };

constexpr int kColumns = 3;

// A swatch with its name under it, or the title of a group over the whole width.
class Delegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const auto* view = static_cast<const QListView*>(option.widget);
    const int width = view->viewport()->width() - 1;
    const int line = option.fontMetrics.height();
    if (index.data(HeaderRole).toBool()) return {width, line * 3 / 2};
    const int side = width / kColumns;
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

QString MaterialPopup::groupName(const std::string& group) {
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

MaterialPopup::MaterialPopup(const Finish& finish, const std::string& language, LengthUnit unit,
                             const QString& plainWords, QWidget* parent)
    : QFrame(parent, Qt::Popup),
      finish_(finish),
      language_(language),
      unit_(unit),
      search_(new QLineEdit(this)),
      list_(new QListView(this)) {
  setObjectName(QStringLiteral("materialPopup"));
  setAttribute(Qt::WA_DeleteOnClose);
  setFrameShape(QFrame::StyledPanel);
  auto* column = new QVBoxLayout(this);
  column->setSpacing(6);

  search_->setObjectName(QStringLiteral("materialSearch"));
  search_->setPlaceholderText(tr("Search materials"));
  search_->setClearButtonEnabled(true);
  column->addWidget(search_);

  list_->setObjectName(QStringLiteral("materialList"));
  list_->setFlow(QListView::LeftToRight);
  list_->setWrapping(true);
  list_->setResizeMode(QListView::Adjust);
  list_->setMouseTracking(true);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  list_->setItemDelegate(new Delegate(list_));
  list_->setModel(new QStandardItemModel(list_));
  const int letter = fontMetrics().averageCharWidth(), line = fontMetrics().height();
  list_->setMinimumSize(letter * 42, line * 19);
  list_->verticalScrollBar()->setSingleStep(line);
  column->addWidget(list_, 1);
  connect(&MaterialSwatches::shared(), &MaterialSwatches::ready, list_->viewport(),
          [view = list_->viewport()] { view->update(); });

  auto* plain = new QPushButton(plainWords, this);
  plain->setObjectName(QStringLiteral("plainFinish"));
  plain->setToolTip(tr("Takes material, colour and picture away again."));
  plain->setAutoDefault(false);
  connect(plain, &QPushButton::clicked, this, [this] {
    emit chosen(Finish{});
    close();
  });
  column->addWidget(plain);
  column->addWidget(makeOptions());

  const auto take = [this](const QModelIndex& index) {
    const QString id = index.data(IdRole).toString();
    if (id.isEmpty()) return;
    Finish next;  // colour, picture and shine were those of the material before
    next.material = fromQt(id);
    choose(next);
    close();
  };
  connect(list_, &QListView::clicked, this, take);
  connect(list_, &QListView::activated, this, take);
  connect(search_, &QLineEdit::textChanged, this, [this](const QString& query) { fill(query); });
  connect(search_, &QLineEdit::returnPressed, this, [this, take] { take(list_->currentIndex()); });
  fill({});
  search_->setFocus();
}

QWidget* MaterialPopup::makeOptions() {
  auto* options = new QWidget(this);
  auto* form = new QFormLayout(options);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);

  auto* color = new ColorButton(options);
  color->setObjectName(QStringLiteral("finishColor"));
  color->setOptional(true, finish_.material.empty() ? tr("None") : tr("The material's"));
  color->setColor(finish_.color);
  color->setToolTip(tr("A colour of its own; with a material, it is tinted."));
  color->setDialogElsewhere(true);
  connect(color, &ColorButton::dialogRequested, this, &MaterialPopup::colorRequested);
  connect(color, &ColorButton::colorChanged, this, [this](const std::optional<Color>& chosenColor) {
    Finish next = finish_;
    next.color = chosenColor;
    choose(next);
  });
  form->addRow(tr("Colour"), color);

  auto* picture = new QPushButton(finish_.texture ? tr("Another file…") : tr("From a file…"), options);
  picture->setObjectName(QStringLiteral("finishPicture"));
  picture->setToolTip(tr("Lays a picture over the face, a photograph of tiles for example."));
  picture->setAutoDefault(false);
  connect(picture, &QPushButton::clicked, this, &MaterialPopup::pictureRequested);
  form->addRow(tr("Picture"), picture);

  if (finish_.texture) {
    const auto addSize = [&](const QString& label, const char* name, double Vec2::*axis, const QString& tip) {
      auto* field = new LengthField(options, unit_);
      field->setObjectName(QString::fromLatin1(name));
      field->setRange(0.001, 1000);
      field->setValue(finish_.texture->size.*axis);
      field->setToolTip(tip);
      connect(field, &ValueField::valueChanged, this, [this, axis](double metres) {
        Finish next = finish_;
        next.texture->size.*axis = metres;
        choose(next);
      });
      form->addRow(label, field);
    };
    addSize(tr("Picture width"), "pictureWidth", &Vec2::x, tr("What one copy of the picture covers."));
    addSize(tr("Picture height"), "pictureHeight", &Vec2::y, tr("What one copy of the picture covers."));
    auto* angle = new AngleField(options);
    angle->setObjectName(QStringLiteral("pictureAngle"));
    angle->setValue(finish_.texture->angle * 180 / kPi);
    connect(angle, &ValueField::valueChanged, this, [this](double degrees) {
      Finish next = finish_;
      next.texture->angle = degrees * kPi / 180;
      choose(next);
    });
    form->addRow(tr("Picture angle"), angle);
  }

  auto* shine = new SliderField(0, 100, 1, QStringLiteral(" %"), 0, options);
  shine->setObjectName(QStringLiteral("finishShine"));
  shine->setToolTip(tr("From matt to a mirror."));
  if (finish_.roughness)
    shine->setValue(100 * (1 - *finish_.roughness));
  else
    shine->setNone(tr("Usual"));
  connect(shine, &SliderField::valueChanged, this, [this](double percent) {
    Finish next = finish_;
    next.roughness = 1 - percent / 100;
    choose(next);
  });
  form->addRow(tr("Shininess"), shine);
  return options;
}

void MaterialPopup::choose(const Finish& finish) {
  if (finish == finish_) return;
  finish_ = finish;
  emit chosen(finish);
}

void MaterialPopup::fill(const QString& query) {
  auto* model = static_cast<QStandardItemModel*>(list_->model());
  model->clear();
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
    model->appendRow(head);
    for (const std::string& id : members[group]) {
      const QString name = toQt(materialName(id, language_));
      auto* item = new QStandardItem(name);
      item->setData(toQt(id), IdRole);
      item->setToolTip(name);
      model->appendRow(item);
      if (id == finish_.material || (!current.isValid() && !query.isEmpty())) current = item->index();
    }
  }
  if (!current.isValid()) return;
  list_->setCurrentIndex(current);
  list_->scrollTo(current, QAbstractItemView::PositionAtCenter);
}

}  // namespace idap
