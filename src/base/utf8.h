// Keeps texts valid UTF-8, whatever a file or a name of the system brought.
#pragma once

#include <string>
#include <string_view>

namespace idap {

// Well-formed by RFC 3629: no overlong forms, no surrogates, nothing above U+10FFFF.
bool isUtf8(std::string_view text);

// The text with every byte that does not belong to a well-formed character replaced by U+FFFD.
std::string toValidUtf8(std::string_view text);

// The longest beginning of a valid text that has at most maxBytes and cuts no character in two.
std::string_view utf8Prefix(std::string_view text, std::size_t maxBytes);

}  // namespace idap
