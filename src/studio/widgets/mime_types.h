// What the studio puts on the clipboard and into drags.
#pragma once

namespace idap {

inline constexpr const char* kPieceMime = "application/x-idap-piece";  // the id of a catalog piece, UTF-8
inline constexpr const char* kMaterialMime =
    "application/x-idap-material";  // the id of a catalog material, UTF-8
inline constexpr const char* kHomeMime =
    "application/x-idap-home";  // elements, as an .idap file of only these

}  // namespace idap
