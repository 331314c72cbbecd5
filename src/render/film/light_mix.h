// Lamps dimmed, recoloured and switched in a picture that is made already: its light groups added up anew.
// Light is additive, so that the mix is the picture that tracing it again would give.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/film/film.h"
#include "render/light_group.h"

namespace idap::render {

struct LightChange {
  float strength = 1;        // of what it was; 0: switched off
  std::optional<Rgb> color;  // linear, luminance 1
};

// "0.3", "off", "on", "2700K", "#ffb060", or several of these with commas: "0.3,2700K". Throws RenderError.
LightChange parseLightChange(std::string_view text);

// The groups of that name; with a * at its end, of all that begin so. Case does not matter.
std::vector<std::size_t> lightsNamed(const std::vector<LightGroup>& groups, std::string_view name);

// What a group's light is multiplied with. Throws RenderError where a new colour is asked of a light whose
// own is not known.
Rgb mixFactor(const LightGroup& group, const LightChange& change);

// The film with color as the sum of its groups, changed (by index; those beyond stay as they are). Recoloured
// is what a group's own colour is known of; throws RenderError for others, and for a film without groups.
Film mixed(const Film& film, const std::vector<LightGroup>& groups, const std::vector<LightChange>& changes);

}  // namespace idap::render
