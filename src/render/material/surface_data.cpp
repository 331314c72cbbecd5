#include "render/material/surface_data.h"

#include <algorithm>
#include <cmath>

#include "render/material/albedo_table.h"
#include "render/material/fresnel.h"

namespace idap::render {

namespace {

float unit(float v) { return std::isfinite(v) ? std::clamp(v, 0.0f, 1.0f) : 0.0f; }
Rgb unit(Rgb c) { return {unit(c.x), unit(c.y), unit(c.z)}; }
float positive(float v) { return std::isfinite(v) ? std::max(v, 0.0f) : 0.0f; }

// 8-bit code -> linear value, for sRGB-encoded and for plain channels.
struct Decoding {
  float srgb[256], plain[256];
  Decoding() {
    for (int i = 0; i < 256; ++i) {
      plain[i] = static_cast<float>(i) / 255.0f;
      srgb[i] = srgbToLinear(plain[i]);
    }
  }
};
const Decoding kDecoding;

const Texture* usable(const TexturePtr& t) {
  return t && t->width > 0 && t->height > 0 &&
                 t->rgba.size() >=
                     4 * static_cast<std::size_t>(t->width) * static_cast<std::size_t>(t->height)
             ? t.get()
             : nullptr;
}

}  // namespace

SurfaceData compileSurface(const Surface& surface) {
  SurfaceData d;
  d.baseColor = unit(surface.baseColor);
  d.metalness = unit(surface.metalness);
  d.roughness = unit(surface.roughness);
  d.ior = std::isfinite(surface.ior) ? std::clamp(surface.ior, 1.0f, 4.0f) : 1.5f;
  const float r = (d.ior - 1) / (d.ior + 1);
  d.f0 = r * r;
  // Schlick's curve climbs to 1 at grazing angles whatever F0; with an index near 1 nothing is there to
  // reflect.
  d.f90 = std::min(1.0f, d.f0 * 50.0f);
  d.transmission = unit(surface.transmission);
  d.translucency = unit(surface.translucency);
  d.opacity = unit(surface.opacity);
  d.thin = surface.thin;
  d.emission = {positive(surface.emission.x), positive(surface.emission.y), positive(surface.emission.z)};
  d.emits = maxComponent(d.emission) > 0;
  d.baseColorMap = usable(surface.baseColorMap);
  d.normalMap = usable(surface.normalMap);
  d.roughnessMap = usable(surface.roughnessMap);
  d.hasMaps = d.baseColorMap || d.normalMap || d.roughnessMap;
  d.mayPass = d.opacity < 1 || (d.baseColorMap && surface.baseColorMap->hasAlpha);
  d.opaqueToShadows = !d.mayPass && (d.transmission * (1 - d.metalness) <= 0 || !d.thin);
  d.clearSheet = d.thin && d.transmission >= 1 && d.metalness <= 0 && !d.mayPass && !d.emits &&
                 d.roughness * d.roughness < kSmoothAlpha && !d.roughnessMap;
  const float c = std::cos(surface.uvRotation), s = std::sin(surface.uvRotation);
  d.uvX = {c * surface.uvScale.x, s * surface.uvScale.x};
  d.uvY = {-s * surface.uvScale.y, c * surface.uvScale.y};
  d.uvOffset = surface.uvOffset;
  return d;
}

SurfaceValues valuesAt(const SurfaceData& surface, Vec2f uv) {
  SurfaceValues v{surface.baseColor, surface.roughness, surface.opacity};
  if (!surface.hasMaps) return v;
  const Vec2f p = surface.mapUv(uv);
  if (surface.baseColorMap) {
    const Texel t = lookUp(*surface.baseColorMap, p);
    v.baseColor *= t.color;
    v.opacity *= t.alpha;
  }
  if (surface.roughnessMap) v.roughness *= lookUp(*surface.roughnessMap, p).color.x;
  return v;
}

Texel lookUp(const Texture& texture, Vec2f uv) {
  if (!(std::fabs(uv.x) < 1e6f && std::fabs(uv.y) < 1e6f)) uv = {};
  const int w = texture.width, h = texture.height;
  const float x = (uv.x - std::floor(uv.x)) * static_cast<float>(w) - 0.5f;
  const float y = (1 - (uv.y - std::floor(uv.y))) * static_cast<float>(h) - 0.5f;
  const float fx = std::floor(x), fy = std::floor(y);
  const float s = x - fx, t = y - fy;
  const auto wrap = [](int i, int n) { return i < 0 ? i + n : i >= n ? i - n : i; };
  const int x0 = wrap(static_cast<int>(fx), w), x1 = wrap(static_cast<int>(fx) + 1, w);
  const int y0 = wrap(static_cast<int>(fy), h), y1 = wrap(static_cast<int>(fy) + 1, h);
  const float* decode = texture.srgb ? kDecoding.srgb : kDecoding.plain;
  Texel sum{{}, 0};
  const auto add = [&](int px, int py, float weight) {
    const std::uint8_t* p =
        texture.rgba.data() +
        4 * (static_cast<std::size_t>(py) * static_cast<std::size_t>(w) + static_cast<std::size_t>(px));
    sum.color += Rgb{decode[p[0]], decode[p[1]], decode[p[2]]} * weight;
    sum.alpha += kDecoding.plain[p[3]] * weight;
  };
  add(x0, y0, (1 - s) * (1 - t));
  add(x1, y0, s * (1 - t));
  add(x0, y1, (1 - s) * t);
  add(x1, y1, s * t);
  if (!texture.hasAlpha) sum.alpha = 1;
  return sum;
}

Rgb straightTransmittance(const SurfaceData& surface, const SurfaceValues& values, float cosine) {
  Rgb through{};
  const float clear = surface.thin ? surface.transmission * (1 - surface.metalness) : 0.0f;
  if (clear > 0) {
    float reflected;
    if (values.roughness * values.roughness < kSmoothAlpha) {
      reflected = fresnelSheet(cosine, surface.ior);
    } else {
      const AlbedoTerms a = AlbedoTable::get().directional(cosine, values.roughness);
      reflected = sheetF0(surface.f0) * a.base + surface.f90 * a.edge;
    }
    through = values.baseColor * (clear * (1 - reflected));
  }
  const float gap = 1 - values.opacity;
  return Rgb{gap, gap, gap} + through * values.opacity;
}

}  // namespace idap::render
