// The parts and the numbers of built-in pieces in words.
#pragma once

#include <QString>
#include <string>

#include "catalog/catalog.h"

namespace idap {

// "book-a" -> "Books 1"; a name that is not known (of a model file) is shown as it is, tidied.
QString partName(const std::string& slot);
QString parameterName(const PieceParameter& parameter);

}  // namespace idap
