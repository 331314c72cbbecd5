#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>

#include "studio/catalog/catalog_model.h"
#include "studio/catalog/import_pages.h"
#include "studio/catalog/model_preview.h"
#include "studio/catalog/part_finishes.h"
#include "studio/widgets/length_field.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr int kPictureSide = 320;
constexpr double kUnits[] = {1, 0.01, 0.001, 0.0254};  // m
constexpr double kSmallest = 0.001, kLargest = 100;    // m

enum LabelIndex {
  NameLabel,
  CategoryLabel,
  KindLabel,
  UnitLabel,
  UpLabel,
  WidthLabel,
  DepthLabel,
  HeightLabel,
  ElevationLabel,
  PartsLabel,
  Labels
};

}  // namespace

ModelPage::ModelPage(Editor& editor, QWidget* parent) : QWidget(parent), editor_(editor) {
  setObjectName(QStringLiteral("importModel"));
  picture_ = new ModelPreview(editor);
  picture_->setObjectName(QStringLiteral("importPicture"));
  picture_->setFixedSize(kPictureSide, kPictureSide);
  pictureHint_ = new QLabel;
  pictureHint_->setForegroundRole(QPalette::PlaceholderText);
  pictureHint_->setAlignment(Qt::AlignCenter);
  facts_ = new QLabel;
  facts_->setWordWrap(true);
  facts_->setForegroundRole(QPalette::PlaceholderText);
  name_ = new QLineEdit;
  name_->setObjectName(QStringLiteral("importName"));
  const auto combo = [](const char* name) {
    auto* box = new QComboBox;
    box->setObjectName(QString::fromLatin1(name));
    return box;
  };
  category_ = combo("importCategory");
  kind_ = combo("importKind");
  unit_ = combo("importUnit");
  up_ = combo("importUp");
  turn_ = new QPushButton(QStringLiteral("↺"));
  turn_->setObjectName(QStringLiteral("importTurn"));
  turnBack_ = new QPushButton(QStringLiteral("↻"));
  turnBack_->setObjectName(QStringLiteral("importTurnBack"));
  for (QPushButton* button : {turn_, turnBack_}) {
    button->setAutoDefault(false);
    button->setFixedWidth(3 * fontMetrics().height());
  }
  parts_ = new PartFinishes;
  pictures_ = new QCheckBox;
  pictures_->setObjectName(QStringLiteral("importPictures"));
  proportions_ = new QCheckBox;
  proportions_->setObjectName(QStringLiteral("importProportions"));
  proportions_->setChecked(true);
  const LengthUnit unit = editor.settings().unit;
  static constexpr const char* kNames[] = {"importWidth", "importDepth", "importHeight"};
  for (int i = 0; i < 3; ++i) {
    sizes_[i] = new LengthField(nullptr, unit);
    sizes_[i]->setObjectName(QString::fromLatin1(kNames[i]));
    sizes_[i]->setRange(kSmallest, kLargest);
    connect(sizes_[i], &ValueField::valueChanged, this, [this, i] { onSize(i); });
  }
  elevation_ = new LengthField(nullptr, unit);
  elevation_->setObjectName(QStringLiteral("importElevation"));
  elevation_->setRange(-10, 100);
  for (QLabel*& label : labels_) label = new QLabel;
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(labels_[NameLabel], name_);
  form->addRow(labels_[CategoryLabel], category_);
  form->addRow(labels_[KindLabel], kind_);
  form->addRow(labels_[UnitLabel], unit_);
  auto* axes = new QHBoxLayout;
  axes->addWidget(up_, 1);
  axes->addWidget(turn_);
  axes->addWidget(turnBack_);
  form->addRow(labels_[UpLabel], axes);
  for (int i = 0; i < 3; ++i) form->addRow(labels_[WidthLabel + i], sizes_[i]);
  form->addRow(QString(), proportions_);
  form->addRow(labels_[ElevationLabel], elevation_);
  form->addRow(labels_[PartsLabel], parts_);
  form->addRow(QString(), pictures_);
  auto* left = new QVBoxLayout;
  left->addWidget(picture_);
  left->addWidget(pictureHint_);
  left->addWidget(facts_);
  left->addStretch(1);
  auto* layout = new QHBoxLayout(this);
  layout->addLayout(left);
  layout->addSpacing(12);
  layout->addLayout(form, 1);
  retranslate();
  connect(unit_, &QComboBox::activated, this, [this] { onUnit(); });
  connect(up_, &QComboBox::activated, this, [this] { onAxis(); });
  const auto turnBy = [this](int quarters) {
    turns_ = (turns_ + quarters) % 4;
    std::swap(size_.x, size_.y);
    setSize(size_);
    preview();
  };
  connect(turn_, &QPushButton::clicked, this, [turnBy] { turnBy(1); });
  connect(turnBack_, &QPushButton::clicked, this, [turnBy] { turnBy(3); });
  connect(parts_, &PartFinishes::changed, this, [this] { preview(); });
  connect(pictures_, &QCheckBox::toggled, parts_, &PartFinishes::setKeepsPictures);
  connect(kind_, &QComboBox::activated, this, [this] { preview(); });
}

void ModelPage::retranslate() {
  const auto fill = [](QComboBox* box, const QStringList& texts) {
    const int chosen = box->currentIndex();
    box->clear();
    box->addItems(texts);
    box->setCurrentIndex(std::max(chosen, 0));
  };
  fill(kind_, {tr("Furniture"), tr("Lamp"), tr("Door"), tr("Window")});
  fill(unit_, {tr("metres"), tr("centimetres"), tr("millimetres"), tr("inches")});
  fill(up_, {tr("Y"), tr("Z"), tr("X"), tr("−Y"), tr("−Z"), tr("−X")});
  const QString chosen = category_->currentData().toString();
  category_->clear();
  // The built-in ones, named in the user's language.
  CatalogModel names;
  names.setLanguage(editor_.settings().language);
  names.setContents(CatalogModel::contentsOf(editor_.catalog(), false));
  for (const CatalogModel::CategoryCount& category : names.categories())
    category_->addItem(category.name, toQt(category.id));
  const int row = category_->findData(chosen.isEmpty() ? QStringLiteral("decor") : chosen);
  category_->setCurrentIndex(std::max(row, 0));
  const QString titles[] = {tr("Name"),  tr("Category"), tr("It is"),  tr("Made in"),   tr("Up is"),
                            tr("Width"), tr("Depth"),    tr("Height"), tr("Elevation"), tr("Parts")};
  QWidget* buddies[] = {name_,     category_, kind_,     unit_,      up_,
                        sizes_[0], sizes_[1], sizes_[2], elevation_, parts_};
  for (int i = 0; i < Labels; ++i) {
    labels_[i]->setText(titles[i]);
    labels_[i]->setBuddy(buddies[i]);
  }
  turn_->setToolTip(tr("Turn it by 90° to the left, until its front looks at you"));
  turnBack_->setToolTip(tr("Turn it by 90° to the right, until its front looks at you"));
  turn_->setAccessibleName(tr("Turn to the left"));
  turnBack_->setAccessibleName(tr("Turn to the right"));
  pictures_->setText(tr("Keep the pictures of the file"));
  pictures_->setToolTip(tr("Without, parts have a plain colour, and the home is smaller"));
  pictureHint_->setText(tr("Drag to look at it from all sides"));
  picture_->setToolTip(tr("Drag turns it, the wheel comes nearer"));
  unit_->setToolTip(tr("What one unit of the file stands for: sets the size"));
  up_->setToolTip(tr("If the piece lies on its back, choose another axis"));
  kind_->setToolTip(tr("Lamps give light; doors and windows go into walls"));
  proportions_->setText(tr("Keep proportions"));
  proportions_->setToolTip(tr("Width, depth and height change together"));
  elevation_->setToolTip(tr("Of its base above the floor"));
}

void ModelPage::show(std::shared_ptr<const ModelImport> model) {
  model_ = std::move(model);
  turns_ = 0;
  name_->setText(toQt(model_->name));
  up_->setCurrentIndex(static_cast<int>(likelyUp(*model_)));
  const double unit = likelyUnit(*model_);
  for (int i = 0; i < 4; ++i)
    if (std::abs(kUnits[i] - unit) < 1e-9) unit_->setCurrentIndex(i);
  elevation_->setValue(0);
  pictures_->setChecked(true);
  parts_->show(*model_, editor_.settings());
  pictures_->setVisible(parts_->pictured());
  facts_->setText(
      QStringLiteral("%1 · %2").arg(toQt(model_->main), tr("%1 triangles").arg(model_->triangles)));
  onUnit();
}

void ModelPage::onUnit() {
  if (!model_) return;
  const auto rotation = importRotation(static_cast<UpAxis>(up_->currentIndex()), turns_, model_->zUp);
  setSize(rotatedSize(model_->fileSize, rotation) * kUnits[unit_->currentIndex()]);
  preview();
}

void ModelPage::onAxis() { onUnit(); }

void ModelPage::onSize(int axis) {
  Vec3 size = size_;
  const double factor = sizes_[axis]->value() / size[axis];
  size[axis] = sizes_[axis]->value();
  if (proportions_->isChecked())
    for (int i = 0; i < 3; ++i)
      if (i != axis) size[i] *= factor;
  setSize(size);
  if (!proportions_->isChecked()) preview();
}

void ModelPage::setSize(Vec3 size) {
  for (int i = 0; i < 3; ++i) {
    size_[i] = std::clamp(size[i], kSmallest, kLargest);
    sizes_[i]->setValue(size_[i]);
  }
}

PieceKind ModelPage::kind() const {
  constexpr PieceKind kKinds[] = {PieceKind::Furniture, PieceKind::Lamp, PieceKind::Door, PieceKind::Window};
  return kKinds[std::clamp(kind_->currentIndex(), 0, 3)];
}

Furniture ModelPage::furniture(const std::string& folder) const {
  Furniture piece;
  piece.name = fromQt(name_->text().trimmed());
  if (piece.name.empty()) piece.name = model_->name;
  piece.model.asset = folder + model_->main;
  piece.model.rotation = importRotation(static_cast<UpAxis>(up_->currentIndex()), turns_, model_->zUp);
  piece.size = size_;
  piece.position.z = elevation_->value();
  if (kind() == PieceKind::Lamp) piece.lamp = Lamp{};
  piece.slotFinishes = parts_->finishes();
  piece.properties["category"] = fromQt(category_->currentData().toString());
  return piece;
}

Assets ModelPage::files(const std::string& folder) const {
  Assets files = parts_->pictures();
  for (const auto& [name, bytes] : model_->files) files.emplace(folder + name, bytes);
  return files;
}

void ModelPage::preview() {
  if (!model_) return;
  const std::string folder = "models/";
  picture_->show(furniture(folder), std::make_shared<const Assets>(files(folder)));
}

}  // namespace idap
