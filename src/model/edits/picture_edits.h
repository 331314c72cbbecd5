// The gallery of a home.
#pragma once

#include <string>

#include "model/home.h"

namespace idap {

// Adds a picture with its PNG, which goes among the home's files. id: free in the home (Document::freeId), so
// that the picture is the same in every state of a history.
Home addPicture(const Home& home, PictureId id, Picture picture, SharedBytes png);
// Without the picture and its file; a home that has no such picture comes back as it is.
Home removePicture(const Home& home, PictureId id);
Home renamePicture(const Home& home, PictureId id, const std::string& name);

// Whether the homes look the same in a picture: all of them but the gallery.
bool sameDesign(const Home& a, const Home& b);

}  // namespace idap
