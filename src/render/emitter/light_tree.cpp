#include "render/emitter/light_tree.h"

#include <algorithm>
#include <numeric>

namespace idap::render {

namespace {

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

// The binary tree that the wide one is folded from.
struct LightTree::Builder {
  struct Pair {
    LightBounds bounds;
    std::uint32_t left = 0, right = 0;  // right 0: a leaf, left is the light
  };
  std::span<const LightBounds> lights;
  std::vector<Pair> pairs;
  std::vector<Node>& nodes;
  std::vector<std::uint32_t>& places;

  std::uint32_t split(std::span<std::uint32_t> order, int depth);
  std::uint32_t fold(std::uint32_t pair, std::uint32_t parent);
};

std::uint32_t LightTree::Builder::split(std::span<std::uint32_t> order, int depth) {
  const auto index = static_cast<std::uint32_t>(pairs.size());
  pairs.emplace_back();
  if (order.size() == 1) {
    pairs[index].bounds = lights[order[0]];
    pairs[index].left = order[0];
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
  // Below this depth cut in the middle, lest odd sets of lights make a list of the tree.
  for (int axis = 0; axis < 3 && depth < 40; ++axis) {
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
  const std::uint32_t left = split(order.first(count), depth + 1);
  const std::uint32_t right = split(order.subspan(count), depth + 1);
  pairs[index].left = left;
  pairs[index].right = right;
  pairs[index].bounds = join(pairs[left].bounds, pairs[right].bounds);
  return index;
}

// Opens the strongest and widest of a node's children until there are eight.
std::uint32_t LightTree::Builder::fold(std::uint32_t pair, std::uint32_t parent) {
  std::vector<std::uint32_t> children{pair};
  while (children.size() < kWidth) {
    const auto weight = [&](std::uint32_t c) {
      const LightBounds& b = pairs[c].bounds;
      return pairs[c].right == 0 ? -1.0f : b.intensity * orientationCost(b) * (halfArea(b.box) + 1e-9f);
    };
    const auto widest = std::ranges::max_element(children, {}, weight);
    if (pairs[*widest].right == 0) break;
    const Pair& opened = pairs[*widest];
    *widest = opened.left;
    children.push_back(opened.right);
  }

  const auto index = static_cast<std::uint32_t>(nodes.size());
  nodes.emplace_back();  // zeroes: no intensity, no child
  nodes[index].parent = parent;
  for (std::uint32_t k = 0; k < children.size(); ++k) {
    const Pair& c = pairs[children[k]];
    Node& node = nodes[index];
    const Vec3f centre = c.bounds.box.centre(), size = c.bounds.box.size();
    node.x[k] = centre.x, node.y[k] = centre.y, node.z[k] = centre.z;
    node.radius2[k] = 0.25f * dot(size, size);
    node.axisX[k] = c.bounds.axis.x, node.axisY[k] = c.bounds.axis.y, node.axisZ[k] = c.bounds.axis.z;
    node.cosSpread[k] = c.bounds.cosSpread;
    node.sinSpread[k] = std::sqrt(std::max(0.0f, 1 - c.bounds.cosSpread * c.bounds.cosSpread));
    node.intensity[k] = c.bounds.intensity;
    node.bothSides[k] = c.bounds.bothSides ? 1.0f : 0.0f;
    const std::uint32_t place = index * kWidth + k;
    if (c.right == 0) {
      node.child[k] = c.left | kLeaf;
      places[c.left] = place;
    } else {
      const std::uint32_t child = fold(children[k], place);
      nodes[index].child[k] = child;
    }
  }
  return index;
}

LightTree::LightTree(std::span<const LightBounds> lights) : places_(lights.size(), 0) {
  if (lights.empty()) return;
  std::vector<std::uint32_t> order(lights.size());
  std::iota(order.begin(), order.end(), 0u);
  Builder builder{lights, {}, nodes_, places_};
  builder.pairs.reserve(2 * lights.size());
  builder.fold(builder.split(order, 0), kNoParent);
}

// For each child: intensity times the largest cosines that any part of it can make at the light and at the
// receiver, over the squared distance. Written without branches, for the vectorizer.
void LightTree::judge(const Node& node, const Receiver& at, float (&importance)[kWidth]) {
  const float px = at.position.x, py = at.position.y, pz = at.position.z;
  const float nx = at.normal.x, ny = at.normal.y, nz = at.normal.z;
  const float behind = at.bothSides ? 1.0f : 0.0f;
  for (int k = 0; k < kWidth; ++k) {
    const float x = node.x[k] - px, y = node.y[k] - py, z = node.z[k] - pz;
    const float d2 = std::max(x * x + y * y + z * z, 1e-12f);
    const float inverse = 1 / std::sqrt(d2);
    // Half the angle under which the child is seen; from within it is all around.
    const float sin2 = std::min(node.radius2[k] / d2, 1.0f);
    const float cosBox = node.radius2[k] >= d2 ? -1.0f : std::sqrt(1 - sin2);
    const float sinBox = node.radius2[k] >= d2 ? 0.0f : std::sqrt(sin2);

    // cos(max(0, angle to the axis - spread - half angle)).
    const float c = -(node.axisX[k] * x + node.axisY[k] * y + node.axisZ[k] * z) * inverse;
    const float cosAxis = node.bothSides[k] > 0 ? std::fabs(c) : c;
    const float sinAxis = std::sqrt(std::max(0.0f, 1 - cosAxis * cosAxis));
    const float off = cosAxis * node.cosSpread[k] + sinAxis * node.sinSpread[k];
    const float cosOff = cosAxis >= node.cosSpread[k] ? 1.0f : off;
    const float sinOff = std::sqrt(std::max(0.0f, 1 - cosOff * cosOff));
    const float cosLight = cosOff >= cosBox ? 1.0f : cosOff * cosBox + sinOff * sinBox;

    const float r = (nx * x + ny * y + nz * z) * inverse;
    const float cosNormal = behind > 0 ? std::fabs(r) : r;
    const float sinNormal = std::sqrt(std::max(0.0f, 1 - cosNormal * cosNormal));
    const float cosHere = cosNormal >= cosBox ? 1.0f : cosNormal * cosBox + sinNormal * sinBox;

    importance[k] = node.intensity[k] * std::max(cosLight, 0.0f) * std::max(cosHere, 0.0f) /
                    std::max(d2, std::max(node.radius2[k], 1e-6f));
  }
}

LightTree::Choice LightTree::choose(const Receiver& at, float u) const {
  Choice choice{0, 1.0f, u};
  for (std::uint32_t node = 0;;) {
    float importance[kWidth];
    judge(nodes_[node], at, importance);
    float sum = 0;
    for (const float i : importance) sum += i;
    if (!(sum > 0)) return {};
    float rest = choice.u * sum;
    int chosen = -1;
    for (int k = 0; k < kWidth; ++k) {
      if (importance[k] <= 0) continue;
      chosen = k;
      if (rest < importance[k]) break;
      rest -= importance[k];
    }
    choice.u = std::clamp(rest / importance[chosen], 0.0f, 0.99999994f);
    choice.probability *= importance[chosen] / sum;
    const std::uint32_t child = nodes_[node].child[chosen];
    if (child & kLeaf) {
      choice.light = child & ~kLeaf;
      return choice;
    }
    node = child;
  }
}

float LightTree::probability(const Receiver& at, std::uint32_t light) const {
  float probability = 1;
  for (std::uint32_t place = places_[light]; place != kNoParent;) {
    const Node& node = nodes_[place / kWidth];
    float importance[kWidth];
    judge(node, at, importance);
    float sum = 0;
    for (const float i : importance) sum += i;
    if (!(sum > 0)) return 0;
    probability *= importance[place % kWidth] / sum;
    place = node.parent;
  }
  return probability;
}

}  // namespace idap::render
