// Reads the homes of Sweet Home 3D (.sh3d): a ZIP with Home.xml and the models and pictures that it names.
#pragma once

#include <string>

#include "formats/registry.h"

namespace idap {

bool sniffSh3d(const SharedBytes& bytes, const std::string& fileName);

// The home as the file has it, in our units and axes; the caller validates it. Models and textures that the
// home uses come along as assets (models/…, textures/…). Throws ParseError, UnsupportedVersion (files from
// before 5.3, which hold a serialized home only) and Cancelled.
ReadResult readSh3d(const SharedBytes& bytes, const std::string& fileName, const Progress& progress);

}  // namespace idap
