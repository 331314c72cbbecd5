// Java properties files: keys and values, ISO-8859-1 with \u escapes, as the tables of furniture libraries
// are written.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace idap {

// Calls entry with each key and value (UTF-8) in the order of the file. Never fails: a properties file has no
// wrong form.
void readProperties(std::string_view text,
                    const std::function<void(std::string_view key, std::string_view value)>& entry);

}  // namespace idap
