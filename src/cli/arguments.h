// What several commands read from their arguments. Throw UsageError with an example of how it should be.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <utility>

#include "light/civil_time.h"
#include "model/home.h"
#include "scene/scene_builder.h"

namespace idap::cli {

// "960x640"
std::pair<int, int> parseSize(const std::string& text);

// "2026-06-21T16:30", "2026-06-21 16:30:15" or "2026-06-21" (noon).
std::optional<CivilTime> parseDateTime(const std::string& text);
// The same; none for an empty text. option: its name, for the error.
std::optional<CivilTime> dateTimeArgument(const char* option, const std::string& text);
// By the home's clocks, in milliseconds since 1970.
std::int64_t utcAtHome(const Home& home, const CivilTime& local);

// The stored camera of that name or number (from 1), "top", or without a wish the first there is.
Camera chooseCamera(const Home& home, const std::string& wish, double aspect, bool& fromAbove);

LampPolicy lampPolicy(const std::string& text);  // auto, on, off

// As CLI::Range, which lets "nan" pass.
CLI::Validator within(double low, double high);

}  // namespace idap::cli
