#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>

#include "scene/thumbnail.h"
#include "studio/catalog/catalog_model.h"
#include "studio/catalog/import_pages.h"
#include "studio/widgets/background_job.h"
#include "studio/widgets/length_field.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr int kPictureSide = 256;
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
  Labels
};

}  // namespace

ModelPage::ModelPage(Editor& editor, QWidget* parent) : QWidget(parent), editor_(editor) {
  setObjectName(QStringLiteral("importModel"));
  picture_ = new QLabel;
  picture_->setObjectName(QStringLiteral("importPicture"));
  picture_->setFixedSize(kPictureSide, kPictureSide);
  picture_->setAlignment(Qt::AlignCenter);
  picture_->setFrameShape(QFrame::StyledPanel);
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
  turn_ = new QPushButton;
  turn_->setObjectName(QStringLiteral("importTurn"));
  turn_->setAutoDefault(false);
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
  form->addRow(labels_[UpLabel], axes);
  for (int i = 0; i < 3; ++i) form->addRow(labels_[WidthLabel + i], sizes_[i]);
  form->addRow(QString(), proportions_);
  form->addRow(labels_[ElevationLabel], elevation_);
  auto* left = new QVBoxLayout;
  left->addWidget(picture_);
  left->addWidget(facts_);
  left->addStretch(1);
  auto* layout = new QHBoxLayout(this);
  layout->addLayout(left);
  layout->addSpacing(12);
  layout->addLayout(form, 1);
  retranslate();
  connect(unit_, &QComboBox::activated, this, [this] { onUnit(); });
  connect(up_, &QComboBox::activated, this, [this] { onAxis(); });
  connect(turn_, &QPushButton::clicked, this, [this] {
    turns_ = (turns_ + 1) % 4;
    std::swap(size_.x, size_.y);
    setSize(size_);
    preview();
  });
}

ModelPage::~ModelPage() { delete tracing_; }

void ModelPage::retranslate() {
  const auto fill = [](QComboBox* box, const QStringList& texts) {
    const int chosen = box->currentIndex();
    box->clear();
    box->addItems(texts);
    box->setCurrentIndex(std::max(chosen, 0));
  };
  fill(kind_, {tr("Furniture"), tr("Lamp"), tr("Door"), tr("Window")});
  fill(unit_, {tr("metres"), tr("centimetres"), tr("millimetres"), tr("inches")});
  fill(up_, {tr("Y (most models)"), tr("Z"), tr("X"), tr("−Y"), tr("−Z"), tr("−X")});
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
  const QString titles[] = {tr("Name"),  tr("Category"), tr("It is"),  tr("Made in"),  tr("Up is"),
                            tr("Width"), tr("Depth"),    tr("Height"), tr("Elevation")};
  QWidget* buddies[] = {name_, category_, kind_, unit_, up_, sizes_[0], sizes_[1], sizes_[2], elevation_};
  for (int i = 0; i < Labels; ++i) {
    labels_[i]->setText(titles[i]);
    labels_[i]->setBuddy(buddies[i]);
  }
  turn_->setText(tr("Turn 90°"));
  turn_->setToolTip(tr("Turn it until its front looks at you"));
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
  facts_->setText(
      QStringLiteral("%1 · %2").arg(toQt(model_->main), tr("%1 triangles").arg(model_->triangles)));
  onUnit();
}

void ModelPage::onUnit() {
  if (!model_) return;
  const auto rotation = importRotation(static_cast<UpAxis>(up_->currentIndex()), turns_);
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
  piece.model.rotation = importRotation(static_cast<UpAxis>(up_->currentIndex()), turns_);
  piece.size = size_;
  piece.position.z = elevation_->value();
  if (kind() == PieceKind::Lamp) piece.lamp = Lamp{};
  piece.properties["category"] = fromQt(category_->currentData().toString());
  return piece;
}

// In the background; while one picture is made, only the last wish is kept.
void ModelPage::preview() {
  if (!model_) return;
  if (tracing_) {
    again_ = true;
    return;
  }
  picture_->setToolTip(tr("How the piece will look"));
  const std::string folder = "models/";
  auto assets = std::make_shared<Assets>();
  for (const auto& [name, bytes] : model_->files) assets->emplace(folder + name, bytes);
  const Furniture piece = furniture(folder);
  const auto catalog = editor_.sharedCatalog();
  const int side = qRound(kPictureSide * devicePixelRatioF());
  const auto done = [this] {
    tracing_ = nullptr;
    if (std::exchange(again_, false)) preview();
  };
  tracing_ = runInBackground<Image8>(
      nullptr, tr("Preview"),
      [=](const Progress& progress) { return renderThumbnail(*catalog, piece, assets, side, progress); },
      [this, done](const Image8& image) {
        QPixmap pixmap = QPixmap::fromImage(
            QImage(image.rgb.data(), image.width, image.height, image.width * 3, QImage::Format_RGB888)
                .copy());
        pixmap.setDevicePixelRatio(devicePixelRatioF());
        picture_->setPixmap(pixmap);
        done();
      },
      [this, done](std::exception_ptr error) {
        picture_->setText(errorText(error));
        done();
      });
}

}  // namespace idap
