#include "studio/widgets/material_popup.h"

#include <QFormLayout>
#include <QLineEdit>

#include "studio/widgets/color_button.h"
#include "studio/widgets/length_field.h"
#include "studio/widgets/material_list.h"
#include "studio/widgets/slider_field.h"
#include "studio/widgets/texts.h"

namespace idap {

MaterialPopup::MaterialPopup(const Finish& finish, const std::string& language, LengthUnit unit,
                             const QString& plainWords, QWidget* parent)
    : QFrame(parent, Qt::Popup),
      finish_(finish),
      unit_(unit),
      search_(new QLineEdit(this)),
      list_(new MaterialList(this)) {
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
  list_->setLanguage(language);
  const int letter = fontMetrics().averageCharWidth(), line = fontMetrics().height();
  list_->setMinimumSize(letter * 42, line * 19);
  column->addWidget(list_, 1);

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

  const auto take = [this](const QString& id) {
    if (id.isEmpty()) return;
    Finish next;  // colour, picture and shine were those of the material before
    next.material = fromQt(id);
    choose(next);
    close();
  };
  connect(list_, &MaterialList::chosen, this, take);
  connect(list_, &MaterialList::confirmed, this, take);
  connect(search_, &QLineEdit::textChanged, this,
          [this](const QString& query) { list_->fill(query, finish_.material); });
  connect(search_, &QLineEdit::returnPressed, this, [this, take] { take(toQt(list_->current())); });
  list_->fill({}, finish_.material);
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

}  // namespace idap
