// How the sections of the property panel reach the home: one undo step a change, live changes in between,
// and what the catalog knows of pieces, fetched in the background.
#pragma once

#include <QObject>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/editor.h"

namespace idap {

// What is known of a piece's model beyond the home.
struct PieceFacts {
  CatalogPiecePtr piece;  // null: not of the catalog
  struct Slot {
    std::string name;
    std::string material;        // id of the catalog's; empty: one of the model's own
    std::optional<Color> color;  // of a model's own material, or where it differs from the catalog's
  };
  std::vector<Slot> parts;
  std::string problem;  // the model cannot be read
};

class PanelLink : public QObject {
  Q_OBJECT
 public:
  using Change = std::function<Home(const Home&)>;

  PanelLink(Editor& editor, QObject* parent);
  ~PanelLink() override;

  Editor& editor() const { return editor_; }

  // One undo step; what preview() had begun becomes part of it. moves: dimensions, and rooms of walls that
  // changed, follow.
  bool apply(const char* name, const Change& change, bool moves = false);
  // While a slider is dragged: seen everywhere, no undo step yet.
  void preview(const char* name, const Change& change);
  void abandon();  // takes previews back
  bool live() const { return live_; }

  // Null until they are there: factsReady() follows.
  const PieceFacts* facts(const Piece& piece, const Home& home);

 signals:
  void factsReady();

 private:
  Editor& editor_;
  bool live_ = false;
  std::map<std::string, PieceFacts> facts_;
  std::set<std::string> asked_;
  std::map<std::string, std::string> latest_;  // model -> the key of its facts that were shown last
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace idap
