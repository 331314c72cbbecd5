// Boxes, cylinders, balls, extruded outlines and turned profiles: as large as their formulas say, closed, in
// the box asked for; and every parameter of every piece at its least and most.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "catalog/parametric/builtin.h"
#include "catalog/parametric/outline_parameter.h"

namespace idap::parametric {
namespace {

SurfaceModel solid(const std::string& id, Vec3 size, const std::map<std::string, double>& parameters = {}) {
  return buildModel(*builtinCatalog().find("idap/" + id), size, parameters);
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles)
    sum += dot(toDouble(mesh.positions[t[0]]),
               cross(toDouble(mesh.positions[t[1]]), toDouble(mesh.positions[t[2]]))) /
           6;
  return sum;
}

double surface(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles)
    sum += length(toDouble(cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                                 mesh.positions[t[2]] - mesh.positions[t[0]]))) /
           2;
  return sum;
}

// Every edge is walked once each way.
bool watertight(const Mesh& mesh) {
  using Place = std::tuple<long, long, long>;
  const auto place = [&](std::uint32_t v) {
    const Vec3f p = mesh.positions[v];
    return Place{std::lround(p.x * 1e5), std::lround(p.y * 1e5), std::lround(p.z * 1e5)};
  };
  std::map<std::pair<Place, Place>, int> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Place a = place(t[i]), b = place(t[(i + 1) % 3]);
      if (a == b) continue;
      edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  for (const auto& [edge, balance] : edges)
    if (balance != 0) return false;
  return !edges.empty();
}

void expectSound(const SurfaceModel& model, Vec3 size) {
  const Mesh& mesh = model.mesh;
  EXPECT_TRUE(watertight(mesh));
  const Box3f box = mesh.bounds();
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(box.size()[i], size[i], 1e-4) << "axis " << i;
  EXPECT_NEAR(box.min.z, 0, 1e-5);
  EXPECT_NEAR(box.centre().x, 0, 1e-5);
  EXPECT_NEAR(box.centre().y, 0, 1e-5);
  for (const Vec3f& n : mesh.normals) ASSERT_NEAR(length(n), 1, 1e-3);
  EXPECT_EQ(model.slots.size(), 1u);
}

TEST(Solids, BoxIsTheProductOfItsSides) {
  const Vec3 size{0.7, 0.4, 1.2};
  const SurfaceModel box = solid("solid-box", size);
  expectSound(box, size);
  EXPECT_NEAR(volume(box.mesh), 0.7 * 0.4 * 1.2, 1e-6);
  EXPECT_NEAR(surface(box.mesh), 2 * (0.7 * 0.4 + 0.7 * 1.2 + 0.4 * 1.2), 1e-5);
  EXPECT_EQ(box.mesh.triangles.size(), 12u);
  const SurfaceModel round = solid("solid-box", size, {{"rounding", 0.05}});
  expectSound(round, size);
  EXPECT_LT(volume(round.mesh), volume(box.mesh));
  EXPECT_GT(volume(round.mesh), 0.9 * volume(box.mesh));
}

TEST(Solids, BoxTexturesKeepTheirScale) {
  const SurfaceModel box = solid("solid-box", {2, 1, 0.5});
  float lo = 1e9f, hi = -1e9f;
  for (const Vec2f& uv : box.mesh.uvs) lo = std::min(lo, uv.x), hi = std::max(hi, uv.x);
  EXPECT_NEAR(hi - lo, 2, 1e-4);
}

TEST(Solids, CylinderStandsOrLies) {
  for (int axis = 0; axis < 3; ++axis) {
    SCOPED_TRACE(axis);
    const Vec3 sizes[] = {{0.6, 0.6, 1.5}, {1.5, 0.6, 0.6}, {0.6, 1.5, 0.6}};
    const SurfaceModel cylinder = solid("solid-cylinder", sizes[axis], {{"axis", axis}, {"sides", 128}});
    expectSound(cylinder, sizes[axis]);
    EXPECT_NEAR(volume(cylinder.mesh), kPi * 0.09 * 1.5, 0.001);
    EXPECT_NEAR(surface(cylinder.mesh), 2 * kPi * 0.09 + 2 * kPi * 0.3 * 1.5, 0.005);
  }
}

TEST(Solids, CylinderOfAnyTaperIsAConeOrAStump) {
  const SurfaceModel cone = solid("solid-cylinder", {1, 1, 1}, {{"taper", 0}, {"sides", 128}});
  expectSound(cone, {1, 1, 1});
  EXPECT_NEAR(volume(cone.mesh), kPi * 0.25 / 3, 0.002);
  const SurfaceModel stump = solid("solid-cylinder", {1, 1, 1}, {{"taper", 0.5}, {"sides", 128}});
  EXPECT_NEAR(volume(stump.mesh), kPi / 3 * (0.25 + 0.125 + 0.0625), 0.002);
}

TEST(Solids, ManySidesAreSmoothFewAreFlat) {
  const auto smooth = [](const Mesh& mesh) {
    for (const auto& t : mesh.triangles) {
      const Vec3f n = normalized(
          cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]));
      for (const std::uint32_t v : t)
        if (dot(n, mesh.normals[v]) < 0.9999f) return true;
    }
    return false;
  };
  EXPECT_TRUE(smooth(solid("solid-cylinder", {1, 1, 1}).mesh));
  EXPECT_FALSE(smooth(solid("solid-cylinder", {1, 1, 1}, {{"sides", 6}}).mesh));
  EXPECT_FALSE(smooth(solid("solid-extrusion", {1, 1, 1}).mesh));
}

TEST(Solids, BallIsABall) {
  const SurfaceModel ball = solid("solid-sphere", {0.8, 0.8, 0.8}, {{"sides", 128}});
  expectSound(ball, {0.8, 0.8, 0.8});
  EXPECT_NEAR(volume(ball.mesh), 4.0 / 3 * kPi * 0.064, 0.001);
  EXPECT_NEAR(surface(ball.mesh), 4 * kPi * 0.16, 0.004);
  expectSound(solid("solid-sphere", {0.8, 0.4, 1.2}), {0.8, 0.4, 1.2});
}

TEST(Solids, ExtrusionHasTheAreaOfItsOutline) {
  auto parameters = outlineParameters({{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}});
  for (int axis = 0; axis < 3; ++axis) {
    SCOPED_TRACE(axis);
    parameters["axis"] = axis;
    const SurfaceModel model = solid("solid-extrusion", {2, 1, 0.5}, parameters);
    expectSound(model, {2, 1, 0.5});
    EXPECT_NEAR(volume(model.mesh), 0.75 * 2 * 1 * 0.5, 1e-5);
  }
}

TEST(Solids, ExtrusionShowsTheOutlineAsItWasDrawn) {
  // The corner that is cut off lies where the plane's axes are largest.
  auto parameters = outlineParameters({{0, 0}, {1, 0}, {1, 0.5}, {0.5, 1}, {0, 1}});
  const int u[] = {0, 1, 0}, v[] = {1, 2, 2};  // up: x and y; across: y and z; deep: x and z
  for (int axis = 0; axis < 3; ++axis) {
    parameters["axis"] = axis;
    const Mesh mesh = solid("solid-extrusion", {1, 1, 1}, parameters).mesh;
    const Box3f box = mesh.bounds();
    for (const Vec3f& p : mesh.positions) {
      const Vec3f q = p - box.min;
      EXPECT_LE(q[u[axis]] + q[v[axis]], 1.5 + 1e-4) << "axis " << axis;
    }
  }
}

TEST(Solids, TurnedProfilesAreClosed) {
  // A cone upside down on a cylinder, drawn from the axis outwards and the other way round.
  const std::vector<Vec2> up{{0, 0}, {0.5, 0}, {0.5, 0.5}, {1, 1}, {0, 1}};
  const double exact = kPi * 0.25 * 1 + kPi / 3 * (0.25 + 0.5 + 1);  // radius 1 m, height 2 m
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 sizes[] = {{2, 2, 2}, {2, 2, 2}, {2, 2, 2}};
    for (const bool reversed : {false, true}) {
      std::vector<Vec2> points = up;
      if (reversed) std::reverse(points.begin(), points.end());
      auto parameters = outlineParameters(points);
      parameters["axis"] = axis;
      parameters["sides"] = 128;
      const SurfaceModel model = solid("solid-turned", sizes[axis], parameters);
      expectSound(model, sizes[axis]);
      EXPECT_NEAR(volume(model.mesh), exact, 0.01);
    }
  }
  auto parameters = outlineParameters({{0.4, 0}, {1, 0.5}, {0.6, 1}});
  parameters["smooth"] = 1;
  expectSound(solid("solid-turned", {0.3, 0.3, 0.6}, parameters), {0.3, 0.3, 0.6});
}

TEST(Solids, HostileOutlinesGiveASoundBodyAllTheSame) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::vector<Vec2>> outlines{
      {},
      {{0.5, 0.5}},
      {{0, 0}, {1, 1}},
      {{0, 0}, {0.5, 0.5}, {1, 1}},            // no area
      {{0, 0}, {1, 1}, {1, 0}, {0, 1}},        // crosses itself
      {{0, 0}, {0, 0}, {0, 0}, {0, 0}},        // one place
      {{-1e300, 2}, {1e300, -5}, {3, 1e308}},  // far outside
      {{0, 0}, {1, 0}, {nan, 1}, {0, 1}, {0, 0.5}},
  };
  for (const auto& outline : outlines)
    for (const char* id : {"solid-extrusion", "solid-turned"}) {
      auto parameters = outlineParameters(outline);
      parameters["axis"] = 1e9;
      parameters["sides"] = -5;
      parameters["smooth"] = 1;
      const SurfaceModel model = solid(id, {1, 2, 0.5}, parameters);
      ASSERT_FALSE(model.mesh.empty()) << id;
      for (const Vec3f& p : model.mesh.positions) ASSERT_TRUE(isFinite(toDouble(p)));
      for (const Vec3f& n : model.mesh.normals) ASSERT_NEAR(length(n), 1, 1e-3);
    }
  std::vector<Vec2> many(100'000, Vec2{0.5, 0.5});
  EXPECT_EQ(outlineParameters(many).size(), 2 * kMaxOutlinePoints);
}

TEST(Parameters, EveryOneOfEveryPieceWorksFromItsLeastToItsMost) {
  std::set<std::pair<Generator, std::string>> done;  // pieces of one generator are alike
  for (const BuiltinPiece& built : builtinCatalog().pieces) {
    for (const PieceParameter& p : built.piece->parameters) {
      SCOPED_TRACE(built.piece->id + " " + p.name);
      EXPECT_FALSE(p.label.empty());
      EXPECT_NE(p.label, p.name) << "has no name for the user";
      if (!done.emplace(built.generator, p.name).second) continue;
      std::vector<double> values{p.min, p.max};
      if (p.kind == PieceParameter::Kind::Choice)
        for (std::size_t i = 0; i < p.choices.size(); ++i) values.push_back(static_cast<double>(i));
      for (const double value : values) {
        const SurfaceModel model = buildModel(built, built.piece->size, {{p.name, value}});
        ASSERT_FALSE(model.mesh.empty()) << value;
        const Box3f box = model.mesh.bounds();
        for (int i = 0; i < 3; ++i)
          ASSERT_NEAR(box.size()[i], built.piece->size[i], 0.002) << value << ", axis " << i;
        for (const Vec3f& n : model.mesh.normals) ASSERT_NEAR(length(n), 1, 1e-3) << value;
        for (const SurfaceModel::Slot& slot : model.slots)
          EXPECT_FALSE(slot.material.name.empty()) << value << ": " << slot.name << " has no material";
      }
    }
  }
}

TEST(Parameters, ValuesFarOutsideTheirRangeAreKeptWithin) {
  const BuiltinPiece& built = *builtinCatalog().find("idap/solid-cylinder");
  for (const double value : {-1e30, 1e30, std::numeric_limits<double>::infinity()}) {
    const Parameters p = withChanges(built, {{"sides", value}, {"axis", value}, {"taper", value}});
    EXPECT_GE(p.number("sides", 64), 3);
    EXPECT_LE(p.number("sides", 64), 128);
    EXPECT_GE(p.number("taper", 1), 0);
    EXPECT_LE(p.number("taper", 1), 1);
  }
}

TEST(Parameters, ChoicesAndSwitchesChangeTheShape) {
  const BuiltinPiece* chest = nullptr;
  for (const BuiltinPiece& built : builtinCatalog().pieces)
    if (!chest && built.generator == generators().at("chestOfDrawers")) chest = &built;
  ASSERT_NE(chest, nullptr);
  const auto triangles = [&](const std::map<std::string, double>& changes) {
    return buildModel(*chest, chest->piece->size, changes).mesh.triangles.size();
  };
  EXPECT_NE(triangles({{"front", 0}}), triangles({{"front", 1}}));
  EXPECT_NE(triangles({{"drawers", 2}}), triangles({{"drawers", 5}}));
  EXPECT_NE(triangles({{"handle", 0}}), triangles({{"handle", 4}}));
}

}  // namespace
}  // namespace idap::parametric
