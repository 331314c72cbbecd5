#include "studio/catalog/own_furniture_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QLocale>

#include "base/error.h"
#include "catalog/library/own_library.h"
#include "render/film/picture_file.h"
#include "scene/bake_furniture.h"
#include "scene/thumbnail.h"
#include "studio/widgets/background_job.h"
#include "studio/widgets/images.h"
#include "studio/widgets/length_field.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr int kSide = 192;  // pixels of the picture
const std::string kFolder = "models/own/";

struct Made {
  BakedFurniture baked;
  Image8 picture;
};

// The piece as it will be, for its picture.
Image8 pictureOf(const Catalog& catalog, const BakedFurniture& baked, const Progress& progress) {
  Furniture piece;
  piece.model.asset = kFolder + baked.main;
  piece.size = baked.size;
  piece.lamp = baked.lamp;
  auto assets = std::make_shared<Assets>();
  for (const auto& [name, bytes] : baked.files) (*assets)[kFolder + name] = bytes;
  return renderThumbnail(catalog, piece, assets, kSide, progress);
}

}  // namespace

struct OwnFurnitureDialog::Impl {
  OwnFurnitureDialog& dialog;
  Editor& editor;
  std::string id;  // of the piece that is changed; empty: a new one
  OwnPiece piece;
  std::optional<Made> made;
  QPointer<BackgroundJob> baking;

  QLineEdit *name = nullptr, *nameThai = nullptr, *categoryThai = nullptr, *creator = nullptr,
            *tags = nullptr, *price = nullptr;
  QComboBox* category = nullptr;
  LengthField *low[3] = {}, *high[3] = {};
  QCheckBox *resizable = nullptr, *proportions = nullptr;
  QLabel *picture = nullptr, *facts = nullptr, *problem = nullptr;
  QDialogButtonBox* buttons = nullptr;

  Impl(OwnFurnitureDialog& d, Editor& e) : dialog(d), editor(e) {}
  void build();
  void show();
  void bake();
  void enable();
  bool take();
};

void OwnFurnitureDialog::Impl::build() {
  const auto line = [](const char* objectName) {
    auto* field = new QLineEdit;
    field->setObjectName(QLatin1String(objectName));
    return field;
  };
  name = line("ownName");
  nameThai = line("ownNameThai");
  categoryThai = line("ownCategoryThai");
  creator = line("ownCreator");
  tags = line("ownTags");
  price = line("ownPrice");
  category = new QComboBox;
  category->setObjectName(QStringLiteral("ownCategory"));
  category->setEditable(true);
  for (const Catalog::Category& c : editor.catalog().categories())
    if (!c.name.empty()) category->addItem(toQt(c.name));
  category->setCurrentText(tr("My furniture"));
  resizable = new QCheckBox(tr("Can be resized"));
  resizable->setObjectName(QStringLiteral("ownResizable"));
  proportions = new QCheckBox(tr("Keeps its proportions"));
  proportions->setObjectName(QStringLiteral("ownProportions"));
  picture = new QLabel;
  picture->setObjectName(QStringLiteral("ownPicture"));
  picture->setFixedSize(kSide, kSide);
  picture->setAlignment(Qt::AlignCenter);
  picture->setFrameShape(QFrame::StyledPanel);
  picture->setText(tr("Being made…"));
  facts = new QLabel;
  facts->setObjectName(QStringLiteral("ownFacts"));
  facts->setWordWrap(true);
  facts->setFixedWidth(kSide);
  problem = new QLabel;
  problem->setObjectName(QStringLiteral("ownProblem"));
  problem->setWordWrap(true);
  problem->hide();

  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("&Name (English)"), name);
  form->addRow(tr("Name (&Thai)"), nameThai);
  form->addRow(tr("&Category"), category);
  form->addRow(tr("Category (Thai)"), categoryThai);
  form->addRow(tr("C&reator"), creator);
  form->addRow(tr("Ta&gs"), tags);
  tags->setPlaceholderText(tr("Words to find it by, with commas"));
  form->addRow(tr("&Price (%1)").arg(toQt(editor.home().currency)), price);
  const QString axes[] = {tr("Width"), tr("Depth"), tr("Height")};
  for (int k = 0; k < 3; ++k) {
    auto* row = new QHBoxLayout;
    for (auto** fields : {low, high}) {
      fields[k] = new LengthField(nullptr, editor.settings().unit);
      fields[k]->setOptional(true);
      fields[k]->setRange(0.001, 100);
      fields[k]->setNone();
      row->addWidget(fields[k], 1);
      if (fields == low) row->addWidget(new QLabel(tr("to")));
    }
    low[k]->setObjectName(QStringLiteral("ownLow%1").arg(k));
    high[k]->setObjectName(QStringLiteral("ownHigh%1").arg(k));
    low[k]->setToolTip(tr("Not smaller than this; empty: any size"));
    high[k]->setToolTip(tr("Not larger than this; empty: any size"));
    form->addRow(tr("%1 from").arg(axes[k]), row);
  }
  form->addRow(resizable);
  form->addRow(proportions);
  auto* right = new QVBoxLayout;
  right->addWidget(picture);
  right->addWidget(facts);
  right->addStretch();
  auto* across = new QHBoxLayout;
  across->addLayout(form, 1);
  across->addLayout(right);
  buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
  auto* all = new QVBoxLayout(&dialog);
  all->addLayout(across);
  all->addWidget(problem);
  all->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, &dialog, &OwnFurnitureDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  for (QLineEdit* field : {name, nameThai})
    connect(field, &QLineEdit::textChanged, &dialog, [this] { enable(); });
  connect(resizable, &QCheckBox::toggled, &dialog, [this] { enable(); });
}

void OwnFurnitureDialog::Impl::show() {
  name->setText(toQt(piece.name));
  nameThai->setText(toQt(piece.nameThai));
  if (!piece.category.empty()) category->setCurrentText(toQt(piece.category));
  categoryThai->setText(toQt(piece.categoryThai));
  creator->setText(toQt(piece.creator));
  QStringList words;
  for (const std::string& tag : piece.tags) words << toQt(tag);
  tags->setText(words.join(QStringLiteral(", ")));
  if (piece.price) price->setText(QLocale().toString(*piece.price, 'f', 2));
  for (int k = 0; k < 3; ++k) {
    if (piece.minSize[k] > 0) low[k]->setValue(piece.minSize[k]);
    if (piece.maxSize[k] > 0) high[k]->setValue(piece.maxSize[k]);
  }
  resizable->setChecked(piece.resizable);
  proportions->setChecked(piece.keepProportions);
  enable();
}

void OwnFurnitureDialog::Impl::enable() {
  const bool named = !name->text().trimmed().isEmpty() || !nameThai->text().trimmed().isEmpty();
  buttons->button(QDialogButtonBox::Save)->setEnabled(named && (made || !id.empty()));
  for (int k = 0; k < 3; ++k)
    for (LengthField* field : {low[k], high[k]}) field->setEnabled(resizable->isChecked());
  proportions->setEnabled(resizable->isChecked());
}

void OwnFurnitureDialog::Impl::bake() {
  const Home home = editor.document().snapshot().home;
  const auto catalog = editor.sharedCatalog();
  const Elements chosen = editor.selection();
  baking = runInBackground<Made>(
      &dialog, tr("Making furniture of the selection"),
      [home, catalog, chosen](const Progress& progress) {
        Made result;
        result.baked = bakeFurniture(home, *catalog, chosen, progress);
        result.picture = pictureOf(*catalog, result.baked, progress);
        return result;
      },
      [this](Made result) {
        baking = nullptr;
        const LengthUnit unit = editor.settings().unit;
        const Vec3 s = result.baked.size;
        QStringList lines{QStringLiteral("%1 × %2 × %3")
                              .arg(lengthText(s.x, unit), lengthText(s.y, unit), lengthText(s.z, unit))};
        QStringList slots_;
        for (const std::string& slot : result.baked.slots) slots_ << toQt(slot);
        lines << tr("Materials: %1").arg(slots_.join(QStringLiteral(", ")));
        facts->setText(lines.join(QLatin1Char('\n')));
        picture->setPixmap(QPixmap::fromImage(toQImage(result.picture)));
        made = std::move(result);
        enable();
      },
      [this](std::exception_ptr error) {
        baking = nullptr;
        picture->clear();
        problem->setText(errorText(error));
        problem->show();
      });
}

// From the fields into the piece; false with a word where something cannot be.
bool OwnFurnitureDialog::Impl::take() {
  piece.name = fromQt(name->text().trimmed());
  piece.nameThai = fromQt(nameThai->text().trimmed());
  if (piece.name.empty()) piece.name = piece.nameThai;
  piece.category = fromQt(category->currentText().trimmed());
  piece.categoryThai = fromQt(categoryThai->text().trimmed());
  piece.creator = fromQt(creator->text().trimmed());
  piece.tags.clear();
  for (const QString& tag : tags->text().split(QLatin1Char(','), Qt::SkipEmptyParts))
    if (!tag.trimmed().isEmpty()) piece.tags.push_back(fromQt(tag.trimmed()));
  piece.price.reset();
  piece.currency = editor.home().currency;
  if (const QString words = price->text().trimmed(); !words.isEmpty()) {
    bool fine = false;
    double value = QLocale().toDouble(words, &fine);
    if (!fine) value = QLocale::c().toDouble(QString(words).replace(u',', u'.'), &fine);
    if (!fine || !(value >= 0) || value > 1e12) {
      problem->setText(tr("The price is not a number."));
      problem->show();
      price->setFocus();
      return false;
    }
    piece.price = value;
  }
  for (int k = 0; k < 3; ++k) {
    piece.minSize[k] = low[k]->none() ? 0 : low[k]->value();
    piece.maxSize[k] = high[k]->none() ? 0 : high[k]->value();
    if (piece.maxSize[k] > 0 && piece.minSize[k] > piece.maxSize[k]) {
      problem->setText(tr("The smallest size is larger than the largest."));
      problem->show();
      low[k]->setFocus();
      return false;
    }
  }
  piece.resizable = resizable->isChecked();
  piece.keepProportions = proportions->isChecked();
  return true;
}

OwnFurnitureDialog::OwnFurnitureDialog(Editor& editor, QWidget* parent)
    : QDialog(parent), impl_(std::make_unique<Impl>(*this, editor)) {
  setObjectName(QStringLiteral("ownFurnitureDialog"));
  setWindowTitle(tr("Save as furniture"));
  impl_->build();
  const Elements& chosen = editor.selection();
  if (const auto one = single(chosen))
    if (const Piece* piece = pieceOf(editor.home(), *one)) {
      impl_->piece.name = piece->name;
      impl_->piece.price = piece->price;
    }
  if (chosen.groups.size() == 1)
    if (const Group* group = editor.home().groups.find(chosen.groups.front()))
      impl_->piece.name = group->name;
  impl_->show();
  impl_->bake();
}

OwnFurnitureDialog::OwnFurnitureDialog(Editor& editor, const std::string& id, QWidget* parent)
    : QDialog(parent), impl_(std::make_unique<Impl>(*this, editor)) {
  setObjectName(QStringLiteral("ownFurnitureDialog"));
  setWindowTitle(tr("Change furniture"));
  impl_->id = id;
  impl_->build();
  impl_->picture->hide();  // it stays as it is
  impl_->facts->hide();
  try {
    const OwnLibrary library;
    if (const OwnPiece* piece = library.find(id)) impl_->piece = *piece;
  } catch (const Error& error) {
    impl_->problem->setText(toQt(error.what()));
    impl_->problem->show();
  }
  impl_->show();
}

OwnFurnitureDialog::~OwnFurnitureDialog() { delete impl_->baking; }

bool OwnFurnitureDialog::isOwn(const std::string& id) { return id.starts_with("own/"); }

void OwnFurnitureDialog::accept() {
  Impl& d = *impl_;
  d.problem->hide();
  if (!d.take()) return;
  try {
    OwnLibrary library;
    if (d.id.empty()) {
      d.piece.id = library.freeId(d.piece.name);
      d.piece.size = d.made->baked.size;
      d.piece.elevation = d.made->baked.elevation;
      d.piece.lamp = d.made->baked.lamp;
      const auto icon = std::make_shared<const Bytes>(render::encodePicture(d.made->picture, "png"));
      library.add(d.piece, d.made->baked.files, d.made->baked.main, icon);
    } else {
      library.change(d.piece);
    }
    library.save();
  } catch (const Error& error) {
    d.problem->setText(toQt(error.what()));
    d.problem->show();
    return;
  }
  d.editor.say(Text(QT_TRANSLATE_NOOP("idap", "%1 is in the catalog"), {d.piece.name}));
  emit saved();
  QDialog::accept();
}

}  // namespace idap
