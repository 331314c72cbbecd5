#include "render/emitter/light_tree.h"

#include <algorithm>
#include <numeric>

#include "render/lanes/lane_math.h"

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
    node.radius[k] = 0.5f * length(size);
    node.inverseRadius[k] = 1 / std::max(node.radius[k], 1e-6f);
    // The smallest ball around a cap of unit vectors; beyond a half sphere it is the whole sphere's.
    const float cosine = std::max(c.bounds.cosSpread, 0.0f);
    const Vec3f axis = c.bounds.axis * cosine;
    node.axisX[k] = axis.x, node.axisY[k] = axis.y, node.axisZ[k] = axis.z;
    node.slack[k] = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
    node.intensity[k] = c.bounds.intensity;
    node.backSign[k] = c.bounds.bothSides ? -1.0f : 1.0f;
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

// Of one child: intensity times bounds of the cosines at the light and at the receiver, over the squared
// distance. A ball around the normals and one around the places make both bounds a dot product and a sum:
// looser than angles between cones, and several times faster. Written without branches, for the vectorizer.
// behind: -1 where light from behind counts as well, else 1.
template <class F>
IDAP_INLINE F LightTree::importanceOf(const Node& node, int k, const Vec3T<F>& position,
                                      const Vec3T<F>& normal, F behind) {
  using namespace lane_math;
  const Vec3T<F> to = spread<F>({node.x[k], node.y[k], node.z[k]}) - position;
  const F inverse = min(inverseSqrt(max(dot(to, to), 1e-12f)), node.inverseRadius[k]);
  const F size = node.radius[k] * inverse;
  const F a = -dot(spread<F>({node.axisX[k], node.axisY[k], node.axisZ[k]}), to) * inverse;
  const F cosLight = max(a, F(node.backSign[k] * a)) + (node.slack[k] + size);
  const F r = dot(normal, to) * inverse;
  const F cosHere = max(r, F(behind * r)) + size;
  return node.intensity[k] * (inverse * inverse) * clamp(cosLight, 0.0f, 1.0f) * clamp(cosHere, 0.0f, 1.0f);
}

float LightTree::judge(const Node& node, const Receiver& at, float (&importance)[kWidth]) {
  const float behind = at.bothSides ? -1.0f : 1.0f;
  for (int k = 0; k < kWidth; ++k) importance[k] = importanceOf(node, k, at.position, at.normal, behind);
  const float(&i)[kWidth] = importance;
  return ((i[0] + i[1]) + (i[2] + i[3])) + ((i[4] + i[5]) + (i[6] + i[7]));
}

LightTree::Choice LightTree::choose(const Receiver& at, float u) const {
  return descend(0, at, {0, 1.0f, u});
}

LightTree::Choice LightTree::descend(std::uint32_t node, const Receiver& at, Choice choice) const {
  for (;;) {
    float importance[kWidth];
    const float sum = judge(nodes_[node], at, importance);
    if (!(sum > 0)) return {};
    const float target = choice.u * sum;
    float below[kWidth];  // sums of the importances of the children before
    float running = 0;
    for (int k = 0; k < kWidth; ++k) {
      below[k] = running;
      running += importance[k];
    }
    int chosen = 0;
    for (int k = 1; k < kWidth; ++k) chosen += below[k] <= target ? 1 : 0;
    while (importance[chosen] <= 0) --chosen;  // rounding may have led past the last one
    choice.u = std::clamp((target - below[chosen]) / importance[chosen], 0.0f, 0.99999994f);
    choice.probability *= importance[chosen] / sum;
    const std::uint32_t child = nodes_[node].child[chosen];
    if (child & kLeaf) {
      choice.light = child & ~kLeaf;
      return choice;
    }
    node = child;
  }
}

// All begin at the root, which is judged for all lanes at once; below it each goes its own way.
void LightTree::choose(LaneMask active, const LaneReceiver& at, const Floats& u,
                       Choice (&choices)[kLanes]) const {
  using namespace lane_math;
  const Node& root = nodes_[0];
  const Floats behind = select(at.bothSides, Floats(-1.0f), Floats(1.0f));
  Floats importance[kWidth], sum = 0.0f;
  for (int k = 0; k < kWidth; ++k) {
    importance[k] = 0.0f;
    if (!(root.intensity[k] > 0)) continue;
    importance[k] = importanceOf(root, k, at.position, at.normal, behind);
    sum += importance[k];
  }
  Floats rest = u * sum, chosen = 0.0f;
  Ints place = 0;
  LaneMask open = active && sum > 0.0f;
  for (int k = 0; k < kWidth; ++k) {
    const LaneMask takes = open && importance[k] > 0.0f;
    place = select(takes, Ints(k), place);
    chosen = select(takes, importance[k], chosen);
    open = open && !(takes && rest < importance[k]);
    rest = select(takes && open, rest - importance[k], rest);
  }
  // Rounding may have led past the last one.
  const Floats left = clamp(Floats(select(open, Floats(1.0f), rest / chosen)), 0.0f, 0.99999994f);
  const Floats probability = chosen / sum;
  forLanes(active, [&](int k) {
    Choice& choice = choices[k];
    choice = {};
    if (!(lane(chosen, k) > 0)) return;
    choice = {0, lane(probability, k), lane(left, k)};
    const std::uint32_t child = root.child[lane(place, k)];
    if (child & kLeaf)
      choice.light = child & ~kLeaf;
    else
      choice = descend(child, {lane(at.position, k), lane(at.normal, k), lane(at.bothSides, k)}, choice);
  });
}

float LightTree::probability(const Receiver& at, std::uint32_t light) const {
  float probability = 1;
  for (std::uint32_t place = places_[light]; place != kNoParent;) {
    const Node& node = nodes_[place / kWidth];
    float importance[kWidth];
    const float sum = judge(node, at, importance);
    if (!(sum > 0)) return 0;
    probability *= importance[place % kWidth] / sum;
    place = node.parent;
  }
  return probability;
}

}  // namespace idap::render
