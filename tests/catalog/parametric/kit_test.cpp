#include "catalog/parametric/kit.h"

#include <gtest/gtest.h>

namespace idap::parametric {
namespace {

double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles)
    sum += dot(toDouble(mesh.positions[t[0]]),
               cross(toDouble(mesh.positions[t[1]]), toDouble(mesh.positions[t[2]]))) /
           6;
  return sum;
}

// What f builds, not stretched: the box asked for is the box it fills.
template <class F>
Mesh built(Vec3 size, F&& f) {
  Builder b(size);
  f(b);
  const Builder::Result result = b.finish();
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(result.fit[i], 1, 0.02);
  return result.mesh;
}

TEST(Kit, BoardHasItsVolumeLessTheBevels) {
  const Mesh mesh = built({1, 0.5, 0.03}, [](Builder& b) {
    b.box({-0.5, -0.25, 0}, {0.5, 0.25, 0.03}, 0.002);
  });
  EXPECT_NEAR(volume(mesh), 0.015, 0.0002);
  EXPECT_LT(volume(mesh), 0.015);
}

TEST(Kit, BoardsGrainRunsAlongItsLongSide) {
  const Mesh mesh = built({0.2, 1.5, 0.03}, [](Builder& b) { b.box({-0.1, -0.75, 0}, {0.1, 0.75, 0.03}); });
  float lo = 1e9f, hi = -1e9f;
  for (std::size_t i = 0; i < mesh.uvs.size(); ++i) {
    if (mesh.normals[i].z < 0.9f) continue;
    lo = std::min(lo, mesh.uvs[i].x), hi = std::max(hi, mesh.uvs[i].x);
  }
  EXPECT_NEAR(hi - lo, 1.5, 0.01);
}

TEST(Kit, RoundedBoxIsBetweenItsCoreAndItsBox) {
  const Mesh mesh = built({0.4, 0.4, 0.4}, [](Builder& b) {
    b.roundedBox({-0.2, -0.2, 0}, {0.2, 0.2, 0.4}, 0.1, 8);
  });
  // Minkowski sum of a cube of 0.2 and a ball of 0.1.
  const double a = 0.2, r = 0.1,
               exact = a * a * a + 6 * a * a * r + 3 * kPi * r * r * a + 4.0 / 3 * kPi * r * r * r;
  EXPECT_NEAR(volume(mesh), exact, 0.03 * exact);
}

TEST(Kit, CylinderConeAndSphereHaveTheirVolumes) {
  const Mesh cylinder = built({0.2, 0.2, 0.5}, [](Builder& b) { b.cylinder({}, 0.1, 0.5, 0, 64); });
  EXPECT_NEAR(volume(cylinder), kPi * 0.01 * 0.5, 1e-4);
  const Mesh cone = built({0.2, 0.2, 0.5}, [](Builder& b) { b.cone({}, 0.1, 0, 0.5, 0, 64); });
  EXPECT_NEAR(volume(cone), kPi * 0.01 * 0.5 / 3, 1e-4);
  const Mesh sphere = built({0.2, 0.2, 0.2}, [](Builder& b) { b.sphere({0, 0, 0.1}, 0.1, 64); });
  EXPECT_NEAR(volume(sphere), 4.0 / 3 * kPi * 0.001, 3e-5);
}

TEST(Kit, TubeIsAsLongAsItsPathAndClosed) {
  const Mesh mesh = built({1, 0.04, 0.04}, [](Builder& b) {
    b.rod({-0.5, 0, 0.02}, {0.5, 0, 0.02}, 0.02, 32);
  });
  EXPECT_NEAR(volume(mesh), kPi * 0.0004, 2e-5);
}

TEST(Kit, ClosedTubeIsATorus) {
  const Mesh mesh = built({0.44, 0.44, 0.04}, [](Builder& b) {
    b.tube(atHeight(ellipse({}, {0.2, 0.2}, 64), 0.02), 0.02, 24, Cap::None, true);
  });
  EXPECT_NEAR(volume(mesh), 2 * kPi * kPi * 0.2 * 0.0004, 1e-4);
}

TEST(Kit, ExtrusionOfAConcaveOutlineHasItsArea) {
  const Polygon corner{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0}, {0, 0}, {0, 0.5}, {-0.5, 0.5}};
  const Mesh mesh = built({1, 1, 0.1}, [&](Builder& b) { b.extrude(corner, 0, 0.1, 0.001); });
  EXPECT_NEAR(volume(mesh), 0.075, 0.0003);
  const Mesh upright = built({1, 0.1, 1}, [&](Builder& b) {
    b.at({0, 0, 0.5}, [&] { b.extrudeAlongY(corner, -0.05, 0.05, 0.001); });
  });
  EXPECT_NEAR(volume(upright), 0.075, 0.0003);
}

TEST(Kit, MirroredPartsStayWoundOutward) {
  const Mesh mesh = built({1, 1, 0.2}, [](Builder& b) {
    b.mirroredXY([&] { b.box({0.3, 0.3, 0}, {0.5, 0.5, 0.2}, 0); });
  });
  EXPECT_NEAR(volume(mesh), 4 * 0.2 * 0.2 * 0.2, 1e-5);
}

TEST(Kit, CushionFillsItsBoxAndIsFullerInTheMiddle) {
  const Mesh mesh = built({0.6, 0.6, 0.15}, [](Builder& b) {
    b.cushion({-0.3, -0.3, 0}, {0.3, 0.3, 0.15}, {.radius = 0.04, .crown = 0.03});
  });
  EXPECT_GT(volume(mesh), 0.6 * 0.6 * 0.15 * 0.65);
  float middle = 0, rim = 0;
  for (const Vec3f p : mesh.positions) {
    if (std::abs(p.x) < 0.06f && std::abs(p.y) < 0.06f) middle = std::max(middle, p.z);
    if (p.x > 0.25f) rim = std::max(rim, p.z);
  }
  EXPECT_NEAR(middle, 0.15, 0.004);
  EXPECT_LT(rim, 0.14f);
}

TEST(Kit, ShellIsAsThickAsAsked) {
  const Mesh mesh = built({1, 1, 0.02}, [](Builder& b) {
    b.surface([](double u, double v) { return Vec3{u - 0.5, v - 0.5, 0.02}; }, 4, 4, 0.02);
  });
  EXPECT_NEAR(volume(mesh), 0.02, 0.0008);
}

TEST(Kit, StretchesTheWholeToTheBox) {
  Builder b({2, 1, 1});
  b.slot("wood");
  b.box({-0.5, -0.5, 0.2}, {0.5, 0.5, 1.2}, 0);
  b.light({0, 0, 0.7});
  const Builder::Result result = b.finish();
  EXPECT_NEAR(result.fit.x, 2, 1e-6);
  EXPECT_NEAR(result.mesh.bounds().max.x, 1, 1e-6);
  EXPECT_NEAR(result.mesh.bounds().min.z, 0, 1e-6);
  EXPECT_NEAR(result.lights.at(0).z, 0.5, 1e-6);
  EXPECT_EQ(result.slots, std::vector<std::string>{"wood"});
}

}  // namespace
}  // namespace idap::parametric
