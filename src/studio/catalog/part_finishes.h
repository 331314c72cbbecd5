// The parts of a model that is imported: each as the file has it, or in a material, colour or picture of the
// user's choice.
#pragma once

#include <QScrollArea>
#include <map>

#include "catalog/model_import.h"
#include "editor/settings.h"
#include "model/home.h"

class QFormLayout;

namespace idap {

class PartFinishes : public QScrollArea {
  Q_OBJECT
 public:
  explicit PartFinishes(QWidget* parent = nullptr);

  void show(const ModelImport& model, const EditorSettings& settings);
  // What was chosen; parts left as they are have none.
  SlotFinishes finishes() const;
  // Picture files that these use, by their names among the home's assets.
  const std::map<std::string, SharedBytes>& pictures() const { return pictures_; }
  // Pictures of the file give way to the plain colour of their part.
  void setKeepsPictures(bool keep);
  bool pictured() const;  // some part has a picture

 signals:
  void changed();

 private:
  std::vector<ModelImport::Part> parts_;
  SlotFinishes chosen_;
  std::map<std::string, SharedBytes> pictures_;
  bool keep_ = true;
};

}  // namespace idap
