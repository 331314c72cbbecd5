// Turns JSON into a home by the lists of fields.h. Unknown members are ignored and reported.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "base/progress.h"
#include "model/home.h"
#include "model/import_report.h"

namespace idap::idap_format {

// Parses text, refusing nesting and counts that no home has. Throws ParseError(fileName, "home.json …").
nlohmann::json parseJson(std::string_view text, const std::string& fileName);

// Throws ParseError with the JSON pointer of what does not fit. The home has no assets yet and is not
// validated.
Home fromJson(const nlohmann::json& json, const std::string& fileName, const Progress& progress,
              ImportReport& report);

}  // namespace idap::idap_format
