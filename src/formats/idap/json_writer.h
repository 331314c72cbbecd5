// Turns a home into JSON by the lists of fields.h. Members at their default are left out.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "model/home.h"

namespace idap::idap_format {

nlohmann::json toJson(const Home& home);

// Indented, keys sorted, arrays of plain values on one line: small changes of a home are small changes of
// lines. Numbers are the shortest that read back exactly, in any locale.
std::string printJson(const nlohmann::json& json);

}  // namespace idap::idap_format
