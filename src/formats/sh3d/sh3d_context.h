// What the parts of the .sh3d reader share while one home is read.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "base/progress.h"
#include "formats/sh3d/sh3d_contents.h"
#include "formats/sh3d/sh3d_element.h"
#include "model/home.h"
#include "model/import_report.h"

namespace idap {

struct Sh3dContext {
  Sh3dContext(const ZipReader& archive, const Progress& theProgress)
      : contents(archive), progress(theProgress) {}

  Home home;
  ImportReport report;
  Sh3dContents contents;
  const Progress& progress;
  std::map<std::string, LevelId> levels;  // by the file's id
  bool basePlanLocked = false;

  // The level an element names; none, and a line on the report, where the file has no such level.
  LevelId levelOf(const Sh3dElement& element);
};

// Angles turn clockwise in the file. In -pi..pi.
double sh3dAngle(double clockwise);

Finish sh3dFinish(Sh3dContext& context, const Sh3dElement& element, const char* color, const char* texture,
                  const char* shininess);
std::optional<TextureRef> sh3dTexture(Sh3dContext& context, const Sh3dElement& element,
                                      const char* attribute);
TextStyle sh3dTextStyle(const Sh3dElement& element, const char* attribute);

// sh3d_building.cpp
void readLevel(Sh3dContext& context, const Sh3dElement& element);
void readBackground(Sh3dContext& context, const Sh3dElement& element, LevelId level);
void readRoom(Sh3dContext& context, const Sh3dElement& element);
class Sh3dWalls {  // joins are known only when all walls are
 public:
  void read(Sh3dContext& context, const Sh3dElement& element);
  void join(Sh3dContext& context);

 private:
  struct Joins {
    WallId wall;
    std::string atStart, atEnd;
  };
  std::map<std::string, WallId> ids_;
  std::vector<Joins> joins_;
};

// sh3d_site.cpp
void readCompass(Sh3dContext& context, const Sh3dElement& element);
void readEnvironment(Sh3dContext& context, const Sh3dElement& element);
void readCamera(Sh3dContext& context, const Sh3dElement& element);

// sh3d_annotation.cpp
void readDimension(Sh3dContext& context, const Sh3dElement& element);
void readLabel(Sh3dContext& context, const Sh3dElement& element);
void readPolyline(Sh3dContext& context, const Sh3dElement& element);

// sh3d_furniture.cpp: a piece, an opening, a lamp, or a group with all that is in it.
bool isSh3dFurniture(std::string_view kind);
void readFurniture(Sh3dContext& context, const Sh3dElement& element);

}  // namespace idap
