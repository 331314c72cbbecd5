#include "render/material/albedo_table.h"

#include <algorithm>

#include "render/material/fresnel.h"
#include "render/material/ggx.h"
#include "render/sampling/warp.h"

namespace idap::render {

namespace {

template <class F>
AlbedoTermsT<F> mix(const AlbedoTermsT<F>& a, const AlbedoTermsT<F>& b, F t) {
  return {a.base + (b.base - a.base) * t, a.edge + (b.edge - a.edge) * t};
}

template <class F>
AlbedoTermsT<F> read(const AlbedoTerms* table, Int<F> index) {
  static_assert(sizeof(AlbedoTerms) == 2 * sizeof(float));
  const float* base = &table->base;
  return {gather(base, index * 2), gather(base, index * 2 + 1)};
}

// Two terms from 0 to 1 in one word, 16 bits each, so that they are fetched together.
constexpr float kPacked = 65535.0f;
std::uint32_t pack(AlbedoTerms t) {
  const auto bits = [](float v) {
    return static_cast<std::uint32_t>(std::lround(std::clamp(v, 0.0f, 1.0f) * kPacked));
  };
  return bits(t.base) << 16 | bits(t.edge);
}
template <class F>
AlbedoTermsT<F> unpacked(Word<F> w) {
  return {toFloats(Word<F>(w >> 16)) * (1 / kPacked), toFloats(Word<F>(w & 0xffffu)) * (1 / kPacked)};
}
template <class F>
AlbedoTermsT<F> readPacked(const std::uint32_t* table, Int<F> index) {
  return unpacked<F>(std::bit_cast<Word<F>>(gather(reinterpret_cast<const float*>(table), index)));
}

// The mean over visible facets of G2/G1 times each Schlick term.
AlbedoTerms integrate(float cosine, float roughness) {
  const Ggx ggx{roughness * roughness};
  const Vec3f wo{std::sqrt(1 - cosine * cosine), 0, cosine};
  constexpr int kSamples = 1024;
  double base = 0, edge = 0;
  for (int i = 0; i < kSamples; ++i) {
    const Vec3f h = ggx.sampleVisible(wo, hammersley(i, kSamples));
    const float c = dot(wo, h);
    const Vec3f wi = h * (2 * c) - wo;
    if (wi.z <= 0) continue;
    const float g = ggx.g2(wo, wi) / ggx.g1(wo);
    const float s = schlickWeight(c);
    base += static_cast<double>(g * (1 - s));
    edge += static_cast<double>(g * s);
  }
  return {static_cast<float>(base / kSamples), static_cast<float>(edge / kSamples)};
}

}  // namespace

const AlbedoTable& AlbedoTable::get() {
  static const AlbedoTable table;
  return table;
}

AlbedoTable::AlbedoTable() {
  for (int r = 0; r < kSize; ++r) {
    const float roughness = static_cast<float>(r) / (kSize - 1);
    for (int c = 0; c < kSize; ++c) {
      const float cosine = std::max(static_cast<float>(c) / (kSize - 1), 1e-3f);
      const float s = schlickWeight(cosine);
      directional_[r][c] = pack(r == 0 ? AlbedoTerms{1 - s, s} : integrate(cosine, roughness));
    }
    // The mean of what directional() gives between its nodes, so that the two fit together exactly.
    constexpr int kSteps = 8 * (kSize - 1);
    double base = 0, edge = 0;
    for (int i = 0; i < kSteps; ++i) {
      const float cosine = (static_cast<float>(i) + 0.5f) / kSteps;
      const int k = i / 8;
      const AlbedoTerms t = mix(unpacked<float>(directional_[r][k]), unpacked<float>(directional_[r][k + 1]),
                                cosine * (kSize - 1) - static_cast<float>(k));
      base += static_cast<double>(2 * cosine * t.base) / kSteps;
      edge += static_cast<double>(2 * cosine * t.edge) / kSteps;
    }
    average_[r] = {static_cast<float>(base), static_cast<float>(edge)};
  }
}

template <class F>
AlbedoTermsT<F> AlbedoTable::directional(F cosine, F roughness) const {
  using namespace lane_math;
  const F x = clamp(cosine, 0.0f, 1.0f) * float(kSize - 1);
  const F y = clamp(roughness, 0.0f, 1.0f) * float(kSize - 1);
  const F fx = min(floor(x), float(kSize - 2)), fy = min(floor(y), float(kSize - 2));
  const F s = x - fx, t = y - fy;
  const Int<F> at = toInt(fy * float(kSize) + fx);
  const std::uint32_t* table = directional_[0];
  return mix(mix(readPacked<F>(table, at), readPacked<F>(table, at + 1), s),
             mix(readPacked<F>(table, at + kSize), readPacked<F>(table, at + (kSize + 1)), s), t);
}

template <class F>
AlbedoTermsT<F> AlbedoTable::average(F roughness) const {
  using namespace lane_math;
  const F y = clamp(roughness, 0.0f, 1.0f) * float(kSize - 1);
  const F fy = min(floor(y), float(kSize - 2));
  const Int<F> at = toInt(fy);
  return mix(read<F>(average_, at), read<F>(average_, at + 1), F(y - fy));
}

template AlbedoTerms AlbedoTable::directional(float, float) const;
template AlbedoTermsT<Floats> AlbedoTable::directional(Floats, Floats) const;
template AlbedoTerms AlbedoTable::average(float) const;
template AlbedoTermsT<Floats> AlbedoTable::average(Floats) const;

}  // namespace idap::render
