// PCX version 5 pictures of 256 colours, as the program of 1993 stored them, and its raw true-colour dump.
#pragma once

#include <string>

#include "base/bytes.h"
#include "base/image8.h"
#include "formats/pcx/quantizer.h"

namespace idap {

// 8 bits a pixel, run-length coded line by line, the palette at the end after tag 12. Throws Error where a
// side exceeds 65 534 pixels.
Bytes writePcx(const IndexedImage& image);

// Median cut to 256 colours, then as above.
Bytes writePcx(const Image8& image, const QuantizerOptions& options = {},
               QuantizerStatistics* statistics = nullptr);

// Reads PCX of 256 colours, and of 24 bits (three planes). Throws ParseError with the file's name.
Image8 readPcx(const Bytes& bytes, const std::string& fileName);

// True when the bytes start like a PCX file.
bool looksLikePcx(const Bytes& bytes);

// u16 width, u16 height; then by row: u16 row number, the row's red bytes, its green, its blue. Little
// endian.
Bytes writeRawDump(const Image8& image);
Image8 readRawDump(const Bytes& bytes, const std::string& fileName);

}  // namespace idap
