#include "render/emitter/light_tree.h"

#include <algorithm>
#include <numeric>

namespace idap::render {

namespace {

float safeSqrt(float v) { return std::sqrt(std::max(v, 0.0f)); }

// cos(max(0, a - b)) of two angles within 0..pi given by sine and cosine.
float cosOfDifference(float sinA, float cosA, float sinB, float cosB) {
  return cosA > cosB ? 1.0f : cosA * cosB + sinA * sinB;
}

float halfArea(const Box3f& b) {
  const Vec3f s = b.size();
  return s.x * s.y + s.y * s.z + s.z * s.x;
}

// The measure of directions a node shines into (Conty Estevez and Kulla, equation 2, with a quarter turn of
// fall-off).
float orientationCost(const LightBounds& b) {
  const float pi = static_cast<float>(kPi);
  const float spread = std::acos(std::clamp(b.cosSpread, -1.0f, 1.0f));
  const float end = std::min(spread + pi / 2, pi);
  const float s = std::sin(spread);
  return 2 * pi * (1 - b.cosSpread) +
         pi / 2 * (2 * end * s - std::cos(spread - 2 * end) - 2 * spread * s + b.cosSpread);
}

}  // namespace

float LightBounds::importance(const Receiver& at) const {
  const Vec3f toCentre = box.centre() - at.position;
  const Vec3f size = box.size();
  const float radius2 = 0.25f * dot(size, size);
  const float distance2 = dot(toCentre, toCentre);
  const Vec3f wi = toCentre * (1 / std::sqrt(std::max(distance2, 1e-12f)));

  // Half the angle under which the box is seen.
  const bool within = distance2 <= radius2;
  const float sin2 = within ? 1.0f : radius2 / distance2;
  const float sinBox = within ? 0.0f : std::sqrt(sin2);
  const float cosBox = within ? -1.0f : safeSqrt(1 - sin2);

  // The least angles that any of it may make with the light's axis and with the receiver's normal.
  float cosAxis = -dot(axis, wi);
  if (bothSides) cosAxis = std::fabs(cosAxis);
  const float sinAxis = safeSqrt(1 - cosAxis * cosAxis);
  const float sinSpread = safeSqrt(1 - cosSpread * cosSpread);
  float cosLight = 1.0f;
  if (cosSpread > -1.0f) {
    const float cosA = cosOfDifference(sinAxis, cosAxis, sinSpread, cosSpread);
    const float sinA = safeSqrt(1 - cosA * cosA);
    cosLight = within ? 1.0f : cosOfDifference(sinA, cosA, sinBox, cosBox);
    if (cosLight <= 0) return 0;
  }
  float cosReceiver = dot(at.normal, wi);
  if (at.bothSides) cosReceiver = std::fabs(cosReceiver);
  const float sinReceiver = safeSqrt(1 - cosReceiver * cosReceiver);
  cosReceiver = within ? 1.0f : cosOfDifference(sinReceiver, cosReceiver, sinBox, cosBox);
  if (cosReceiver <= 0) return 0;
  return intensity * cosLight * cosReceiver / std::max(distance2, std::max(radius2, 1e-6f));
}

LightBounds join(const LightBounds& a, const LightBounds& b) {
  if (a.intensity <= 0 && a.box.empty()) return b;
  LightBounds r = a;
  r.box.add(b.box);
  r.intensity += b.intensity;
  r.bothSides = a.bothSides || b.bothSides;
  // The cone around both cones.
  Vec3f axisB = b.axis;
  if (r.bothSides && dot(a.axis, axisB) < 0) axisB = -axisB;
  const float pi = static_cast<float>(kPi);
  const float spreadA = std::acos(std::clamp(a.cosSpread, -1.0f, 1.0f));
  const float spreadB = std::acos(std::clamp(b.cosSpread, -1.0f, 1.0f));
  const float between = std::acos(std::clamp(dot(a.axis, axisB), -1.0f, 1.0f));
  if (std::min(between + spreadB, pi) <= spreadA) return r;
  if (std::min(between + spreadA, pi) <= spreadB) {
    r.axis = axisB;
    r.cosSpread = b.cosSpread;
    return r;
  }
  const float spread = 0.5f * (spreadA + between + spreadB);
  const Vec3f turnAxis = cross(a.axis, axisB);
  const float l2 = dot(turnAxis, turnAxis);
  if (spread >= pi || l2 < 1e-12f) {
    r.cosSpread = -1.0f;
    return r;
  }
  // Turn a's axis towards b's; both lie square to turnAxis.
  const float turn = spread - spreadA;
  const Vec3f side = cross(turnAxis * (1 / std::sqrt(l2)), a.axis);
  r.axis = normalized(a.axis * std::cos(turn) + side * std::sin(turn));
  r.cosSpread = std::cos(spread);
  return r;
}

LightTree::LightTree(std::span<const LightBounds> lights) : paths_(lights.size(), 0) {
  if (lights.empty()) return;
  std::vector<std::uint32_t> order(lights.size());
  std::iota(order.begin(), order.end(), 0u);
  nodes_.reserve(2 * lights.size());
  build(lights, order, 0, 0);
}

std::uint32_t LightTree::build(std::span<const LightBounds> lights, std::span<std::uint32_t> order,
                               std::uint64_t path, int depth) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  if (order.size() == 1) {
    nodes_[index].bounds = lights[order[0]];
    nodes_[index].light = order[0];
    paths_[order[0]] = path;
    return index;
  }

  Box3f centres, whole;
  for (const std::uint32_t i : order) {
    centres.add(lights[i].box.centre());
    whole.add(lights[i].box);
  }
  constexpr int kBuckets = 12;
  const Vec3f extent = centres.size();
  const float longest = std::max({whole.size().x, whole.size().y, whole.size().z});
  float best = std::numeric_limits<float>::infinity();
  int bestAxis = -1, bestBucket = 0;
  const auto bucketOf = [&](std::uint32_t i, int axis) {
    const float x = (lights[i].box.centre()[axis] - centres.min[axis]) / extent[axis];
    return std::clamp(static_cast<int>(x * kBuckets), 0, kBuckets - 1);
  };
  // Below this depth cut in the middle, so that a path fits its 64 bits.
  for (int axis = 0; axis < 3 && depth < 32; ++axis) {
    if (!(extent[axis] > 0)) continue;
    LightBounds buckets[kBuckets];
    for (const std::uint32_t i : order) {
      LightBounds& b = buckets[bucketOf(i, axis)];
      b = join(b, lights[i]);
    }
    const float regularity = longest / std::max(whole.size()[axis], 1e-6f * longest);
    const auto cost = [&](int from, int to) {
      LightBounds sum;
      for (int k = from; k < to; ++k)
        if (!buckets[k].box.empty()) sum = join(sum, buckets[k]);
      return sum.box.empty()
                 ? -1.0f
                 : sum.intensity * orientationCost(sum) * (halfArea(sum.box) + 1e-6f) * regularity;
    };
    for (int cut = 1; cut < kBuckets; ++cut) {
      const float below = cost(0, cut), above = cost(cut, kBuckets);
      if (below < 0 || above < 0 || below + above >= best) continue;
      best = below + above;
      bestAxis = axis;
      bestBucket = cut;
    }
  }
  auto middle = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
  if (bestAxis >= 0)
    middle = std::partition(order.begin(), order.end(),
                            [&](std::uint32_t i) { return bucketOf(i, bestAxis) < bestBucket; });
  const auto count = static_cast<std::size_t>(middle - order.begin());
  build(lights, order.first(count), path, depth + 1);
  const std::uint32_t right =
      build(lights, order.subspan(count), path | (std::uint64_t{1} << depth), depth + 1);
  nodes_[index].right = right;
  nodes_[index].bounds = join(nodes_[index + 1].bounds, nodes_[right].bounds);
  return index;
}

LightTree::Choice LightTree::choose(const Receiver& at, float u) const {
  Choice choice{0, 1.0f, u};
  std::uint32_t node = 0;
  while (nodes_[node].right != 0) {
    const std::uint32_t right = nodes_[node].right;
    const float l = nodes_[node + 1].bounds.importance(at), r = nodes_[right].bounds.importance(at);
    if (!(l + r > 0)) return {};
    const float p = l / (l + r);
    if (choice.u < p) {
      choice.u = std::min(choice.u / p, 0.99999994f);
      choice.probability *= p;
      node = node + 1;
    } else {
      choice.u = std::min((choice.u - p) / (1 - p), 0.99999994f);
      choice.probability *= 1 - p;
      node = right;
    }
  }
  choice.light = nodes_[node].light;
  return choice;
}

float LightTree::probability(const Receiver& at, std::uint32_t light) const {
  std::uint32_t node = 0;
  float probability = 1;
  for (std::uint64_t path = paths_[light]; nodes_[node].right != 0; path >>= 1) {
    const std::uint32_t right = nodes_[node].right;
    const float l = nodes_[node + 1].bounds.importance(at), r = nodes_[right].bounds.importance(at);
    if (!(l + r > 0)) return 0;
    const float p = l / (l + r);
    probability *= path & 1 ? 1 - p : p;
    node = path & 1 ? right : node + 1;
  }
  return probability;
}

}  // namespace idap::render
