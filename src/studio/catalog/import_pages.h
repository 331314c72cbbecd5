// The three steps of the import dialog: choosing a file, a library before it is taken over, a model before it
// becomes a piece.
#pragma once

#include <QWidget>
#include <memory>

#include "catalog/library/install_library.h"
#include "catalog/model_import.h"
#include "editor/editor.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace idap {

class LengthField;
class ModelPreview;
class PartFinishes;

// A place to drop a file, and a button to look for one.
class ImportStart : public QWidget {
  Q_OBJECT
 public:
  explicit ImportStart(QWidget* parent = nullptr);

  void setBusy(const QString& what);  // empty: not any more
  void setProgress(double fraction);
  void setProblem(const QString& words);
  void retranslate();

 signals:
  void fileChosen(QString file);
  void cancelled();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void ask();

  QLabel* words_;
  QLabel* problem_;
  QPushButton* choose_;
  QProgressBar* busy_;
  QPushButton* cancel_;
};

class LibraryPage : public QWidget {
  Q_OBJECT
 public:
  explicit LibraryPage(QWidget* parent = nullptr);

  // installed: pieces of the library of that name that would be replaced; 0: there is none.
  void show(const LibraryPreview& preview, const QString& fileName, bool replaces);
  void retranslate();

 private:
  QLabel* title_;
  QLabel* about_;
  QLabel* replaces_;
  LibraryPreview preview_;
  QString fileName_;
  bool replacing_ = false;
};

class ModelPage : public QWidget {
  Q_OBJECT
 public:
  explicit ModelPage(Editor& editor, QWidget* parent = nullptr);
  void show(std::shared_ptr<const ModelImport> model);
  // The piece as chosen, with its files under this folder of the home's assets.
  Furniture furniture(const std::string& folder) const;
  // All these files, and the pictures that were chosen for its parts, by their names among the assets.
  Assets files(const std::string& folder) const;
  PieceKind kind() const;
  void retranslate();
  const ModelImport* model() const { return model_.get(); }

 private:
  void onUnit();
  void onAxis();
  void onSize(int axis);
  void setSize(Vec3 size);
  void preview();

  Editor& editor_;
  std::shared_ptr<const ModelImport> model_;
  Vec3 size_{1, 1, 1};
  int turns_ = 0;
  ModelPreview* picture_;
  QLabel* pictureHint_;
  QLabel* facts_;
  QLineEdit* name_;
  QComboBox* category_;
  QComboBox* kind_;
  QComboBox* unit_;
  QComboBox* up_;
  QPushButton *turn_, *turnBack_;
  LengthField* sizes_[3];
  LengthField* elevation_;
  QCheckBox* proportions_;
  PartFinishes* parts_;
  QCheckBox* pictures_;
  QLabel* labels_[10];
};

}  // namespace idap
