// The user's own furniture: an SH3F library that pieces are added to, changed in and taken out of. Sweet Home
// 3D reads such files too. Keys of the tables: those of Sweet Home 3D's DefaultFurnitureCatalog.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "geometry/vec.h"
#include "model/lamp.h"

namespace idap {

// All that is said of a piece beside its model. Metres.
struct OwnPiece {
  std::string id;                      // "own/…", once in the library
  std::string name, category;          // English
  std::string nameThai, categoryThai;  // empty: as in English
  std::string creator;
  std::vector<std::string> tags;
  std::optional<double> price;
  std::string currency = "EUR";  // of the price
  Vec3 size;
  Vec3 minSize, maxSize;  // 0: any
  bool resizable = true, keepProportions = false, movable = true;
  double elevation = 0;
  std::optional<Lamp> lamp;
  friend bool operator==(const OwnPiece&, const OwnPiece&) = default;
};

class OwnLibrary {
 public:
  static std::filesystem::path userFile();  // in the user's folder of libraries
  // What the file holds; an empty library where it is not there yet. Throws IoError, ParseError.
  explicit OwnLibrary(std::filesystem::path file = userFile());

  const std::vector<OwnPiece>& pieces() const { return pieces_; }
  const OwnPiece* find(const std::string& id) const;
  std::string freeId(const std::string& name) const;

  // Adds a piece with its model (files by name; main: which of them) and its icon (PNG).
  void add(OwnPiece piece, const std::map<std::string, SharedBytes>& files, const std::string& main,
           SharedBytes icon);
  struct Model {
    std::string main;                          // which of the files; empty: there is no such piece
    std::map<std::string, SharedBytes> files;  // by name
  };
  Model modelOf(const std::string& id) const;
  void change(const OwnPiece& piece);  // of the same id; its model stays
  void remove(const std::string& id);

  Bytes pack() const;  // as an SH3F file
  void save() const;   // throws IoError; the file appears whole or stays as it was

 private:
  struct Files {
    std::string model, icon;  // paths in the archive
  };
  std::filesystem::path file_;
  std::vector<OwnPiece> pieces_;
  std::map<std::string, Files> filesOf_;  // by id
  std::map<std::string, SharedBytes> entries_;
};

}  // namespace idap
