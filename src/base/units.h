// Lengths as people write them, to metres and back. Independent of the system's locale; a comma or a point
// may stand before the decimals when reading.
#pragma once

#include <string>
#include <string_view>

namespace idap {

enum class LengthUnit { Metre, Centimetre, Millimetre, FeetInches };

// Reads `3.25`, `325cm`, `2,5 m`, `1200mm`, `10'8"`, `10' 8 1/2"`, `10ft 8in`, and sums, differences,
// products and quotients of them: `120+15`, `2*60cm`, `(3m - 2*24cm)/2`. A bare number counts in the unit
// given (feet for FeetInches), unless it only multiplies or divides a length. Throws ParseError with the text
// as the file and the position, counted from 1, as the place.
double parseLength(std::string_view text, LengthUnit bare = LengthUnit::Metre);

// `3.25 m`, `325 cm`, `3250 mm`, `10' 8 1/2"` (to the nearest sixteenth of an inch). decimals: at most so
// many, without trailing zeros; below 0: as many as show tenths of a millimetre.
std::string formatLength(double metres, LengthUnit unit, int decimals = -1);

}  // namespace idap
