// Brings the JSON of an older home.json up to the present version, one step at a time. To change the format:
// raise kCurrentVersion, write migration_N_to_M.cpp, and add it to the table in migrations.cpp.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace idap::idap_format {

inline constexpr int kCurrentVersion = 2;

// Throws UnsupportedVersion for a newer or an unknown version, ParseError when "version" is missing.
void migrate(nlohmann::json& home, const std::string& fileName);

// Steps leave alone what they do not understand: the reader that follows says what is wrong with it.
void migrate1To2(nlohmann::json& home);

}  // namespace idap::idap_format
