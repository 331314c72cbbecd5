// A button that shows how a face looks and opens what can be chosen for it: the catalog's materials by group
// with a search, a colour of its own, a picture laid over it, how shiny it is.
#pragma once

#include <QPointer>
#include <QToolButton>
#include <memory>
#include <optional>
#include <string>

#include "base/bytes.h"
#include "base/units.h"
#include "model/home.h"

namespace idap {

class MaterialPopup;

struct FinishChoice {
  Finish finish;
  // A picture file that the finish uses and that the home does not hold yet; null for none. Goes into
  // Home::assets under the name in the finish, in the same edit: withAsset().
  std::string assetName;
  SharedBytes asset;
};

// The home with the choice's picture among its files.
Home withAsset(const Home& home, const FinishChoice& choice);

class MaterialPicker : public QToolButton {
  Q_OBJECT
 public:
  explicit MaterialPicker(QWidget* parent = nullptr);
  ~MaterialPicker() override;

  const Finish& finish() const { return finish_; }
  void setFinish(const Finish& finish, std::shared_ptr<const Assets> assets = {});
  void setMixed();
  bool mixed() const { return mixed_; }
  // How the face looks with an empty finish: words ("As it comes"), and perhaps a colour or a material.
  void setPlain(const QString& words, std::optional<Color> color = {}, const std::string& material = {});
  void setLanguage(const std::string& language);
  void setUnit(LengthUnit unit);
  QString words() const;  // "Oak", "Oak, tinted", "#a0b0c0", "brick.jpg"

  void openPopup();
  // Takes a picture file; false with problem() where it cannot be read.
  bool takePicture(const QString& file);
  QString problem() const { return problem_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void finishChosen(const idap::FinishChoice& choice);  // by the user

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void choose(const Finish& finish);
  void askPicture();
  void askColor();

  Finish finish_;
  bool mixed_ = false;
  std::shared_ptr<const Assets> assets_;
  QString plainWords_;
  std::optional<Color> plainColor_;
  std::string plainMaterial_;
  std::string language_ = "en";
  LengthUnit unit_ = LengthUnit::Centimetre;
  QString problem_;
  QPointer<MaterialPopup> popup_;
};

}  // namespace idap
