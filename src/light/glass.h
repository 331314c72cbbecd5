// Light through a clear pane: both polarisations on their own, with all reflections between its two faces.
#pragma once

#include <algorithm>
#include <cmath>

namespace idap {

struct PaneOptics {
  float transmittance = 1;
  float reflectance = 0;  // together 1, less what the glass absorbs
};

// cosine: of the angle to the pane's normal; n: index of refraction, at least 1; clearness: the share left of
// light after one way straight across the pane (1: none absorbed; common 4 mm float glass about 0.98).
// Fresnel's equations; the faces' reflections add up to a geometric series. @cite born1999optics
inline PaneOptics paneOptics(float cosine, float n = 1.52f, float clearness = 1.0f) {
  const float c = std::clamp(std::fabs(cosine), 0.0f, 1.0f);
  const float inside = std::sqrt(std::max(1 - (1 - c * c) / (n * n), 0.0f));  // cosine in the glass
  if (inside <= 0) return {0, 1};
  const float rs = (c - n * inside) / (c + n * inside);
  const float rp = (n * c - inside) / (n * c + inside);
  const float through = std::pow(std::max(clearness, 0.0f), 1 / inside);
  PaneOptics pane{0, 0};
  for (float r : {rs * rs, rp * rp}) {
    const float back = r * through;
    const float series = 1 / std::max(1 - back * back, 1e-9f);
    const float t = (1 - r) * (1 - r) * through * series;
    pane.transmittance += 0.5f * t;
    pane.reflectance += 0.5f * (r + r * through * t);
  }
  return pane;
}

// Of light that comes evenly from all sides of a hemisphere.
inline PaneOptics diffusePaneOptics(float n = 1.52f, float clearness = 1.0f) {
  constexpr int kSteps = 256;
  PaneOptics sum{0, 0};
  for (int i = 0; i < kSteps; ++i) {
    const PaneOptics pane =
        paneOptics(std::sqrt((static_cast<float>(i) + 0.5f) / static_cast<float>(kSteps)), n, clearness);
    sum.transmittance += pane.transmittance / static_cast<float>(kSteps);
    sum.reflectance += pane.reflectance / static_cast<float>(kSteps);
  }
  return sum;
}

}  // namespace idap
