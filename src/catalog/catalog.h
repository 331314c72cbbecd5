// Everything that can be put into a home: the built-in parametric pieces, and SH3F libraries of the system
// and the user. Thread-safe; libraries are indexed when first asked for.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/surface_model.h"
#include "model/furniture.h"
#include "model/opening.h"

namespace idap {

enum class PieceKind { Furniture, Lamp, Door, Window, Staircase };

struct PieceParameter {  // of a parametric piece: "doors", "shelves", "topThickness"
  enum class Kind {
    Count,
    Length,  // m
    Angle,   // degrees
    Share,   // 0..1
    Switch,  // 0 or 1
    Choice   // the index of one of choices
  };
  struct Option {
    std::string name;   // what the generator calls it: "tapered"
    std::string label;  // English, marked for translation
  };
  std::string name;
  std::string label;  // English, marked for translation
  Kind kind = Kind::Length;
  double value = 0, min = 0, max = 0;
  bool whole = false;
  std::vector<Option> choices;
};

struct CatalogPiece {
  std::string id;        // "idap/chair-windsor", "Scopia#bed1"
  std::string name;      // in the default language (English)
  std::string category;  // id of a category: "chair", "table", …; for libraries: their own name for it
  std::vector<std::string> tags;
  PieceKind kind = PieceKind::Furniture;
  Vec3 size;              // m, default
  Vec3 minSize, maxSize;  // m; 0: any
  double elevation =
      0;  // m, where it is put above the floor (sill, picture, ceiling lamp: see ceilingMounted)
  bool ceilingMounted = false;  // hangs: its top goes to the ceiling
  std::optional<double> price;
  std::string creator, license, library;  // library: file name; empty for built-in
  std::map<std::string, std::map<std::string, std::string>>
      translations;                        // language -> {"name", "category", …} -> text
  std::vector<std::string> slots;          // material slots of built-in pieces
  std::vector<PieceParameter> parameters;  // of parametric pieces
  std::optional<Lamp> lamp;
  std::string staircaseCutOut;
  std::optional<double> dropOnTopHeight;
  // Openings
  std::string cutOut = "M0,0 v1 h1 v-1 z";
  double wallThickness = 1, wallDistance = 0;
  bool cutsBothSides = false;
  std::vector<Sash> sashes;
  std::array<Vec3, 3> modelRotation{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

  std::string nameIn(std::string_view language) const;  // falls back to English
};
using CatalogPiecePtr = std::shared_ptr<const CatalogPiece>;

class Catalog {
 public:
  // Built-in pieces, and the libraries of these folders (each *.sh3f; later ones win). Nothing is read yet.
  explicit Catalog(std::vector<std::filesystem::path> libraryFolders = defaultLibraryFolders());
  ~Catalog();

  // System and user: /usr/share/sweethome3d/furniture, $XDG_DATA_HOME/idap/furniture, $IDAP_FURNITURE
  // (':'-separated).
  static std::vector<std::filesystem::path> defaultLibraryFolders();

  struct Category {
    std::string id, name;
    std::size_t pieces = 0;
  };
  std::vector<Category> categories() const;

  std::vector<CatalogPiecePtr> pieces() const;         // all, built-in first
  std::vector<CatalogPiecePtr> builtinPieces() const;  // opens no library
  bool librariesRead() const;  // true: nothing here waits for the disk any more, models aside
  // Looks into the folders again: libraries that came or went. Pieces and models handed out stay as they are.
  void reread() const;
  CatalogPiecePtr find(const std::string& id) const;  // null when unknown; built-in ones open no library
  // Pieces whose name, translations, tags, category, creator or id hold every word of the query, best first.
  std::vector<CatalogPiecePtr> search(std::string_view query) const;
  std::vector<std::string> problems() const;  // libraries that could not be read, in words

  // The model of a catalog piece at a size (metres). Parametric models are built for that size; equal
  // requests share one model. Null when unknown; ParseError when a library's model is damaged.
  SurfaceModelPtr model(const std::string& id, Vec3 size,
                        const std::map<std::string, double>& parameters = {}) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// A piece ready to be put at a position: named, sized, with its lamp or its cut-out, as the catalog says.
Furniture makeFurniture(const CatalogPiece& piece, Vec3 position, double angle = 0);
Opening makeOpening(const CatalogPiece& piece, Vec3 position, double angle = 0);

}  // namespace idap
