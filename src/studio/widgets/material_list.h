// The catalog's materials by group, as swatches with their names: chosen by a click, dragged onto what they
// are for.
#pragma once

#include <QListView>
#include <string>

namespace idap {

class MaterialList : public QListView {
  Q_OBJECT
 public:
  explicit MaterialList(QWidget* parent = nullptr);

  void setLanguage(const std::string& language);
  // Only those whose name or group has all words of the query; the first of them becomes the current one, or
  // without a query the one of that id.
  void fill(const QString& query, const std::string& current = {});
  std::string current() const;  // its id; empty for none
  int count() const;            // of the materials shown

  static QString groupName(const std::string& group);

 signals:
  void chosen(const QString& id);     // by a click
  void confirmed(const QString& id);  // by a double click or Enter

 protected:
  void startDrag(Qt::DropActions actions) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  std::string language_ = "en";
};

}  // namespace idap
