// The homes of ../shared/homes, where they are: real files, read whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/file.h"
#include "catalog/model_file.h"
#include "formats/sh3d/sh3d_reader.h"
#include "geometry/polygon.h"

namespace idap {
namespace {

constexpr double kMillimetre = 1e-3;

class RealHome : public ::testing::Test {
 protected:
  // Reads a home; skips the test where the homes are not installed.
  void read(const std::string& name) {
    const auto file = std::filesystem::path(IDAP_SOURCE_DIR) / ".." / "shared" / "homes" / (name + ".sh3d");
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "the homes for development are not here: " << file;
    const auto bytes = std::make_shared<const Bytes>(readFile(file));
    ASSERT_TRUE(sniffSh3d(bytes, file.string()));
    ReadResult result = readSh3d(bytes, file.string(), Progress{});
    home = std::move(result.home);
    report = std::move(result.report);
  }

  struct Counts {
    std::size_t levels, walls, rooms, pieces, groups, openings, lamps, cameras, dimensions, labels, polylines;
    friend bool operator==(const Counts&, const Counts&) = default;
  };
  Counts counts() const {
    std::size_t lamps = 0;
    for (const auto& [id, piece] : home.furniture) lamps += piece->lamp ? 1 : 0;
    return {home.levels.size(),
            home.walls.size(),
            home.rooms.size(),
            home.furniture.size() + home.openings.size(),
            home.groups.size(),
            home.openings.size(),
            lamps,
            home.cameras.size(),
            home.dimensions.size(),
            home.labels.size(),
            home.polylines.size()};
  }
  template <class Elements, class Wanted>
  auto first(const Elements& elements, const Wanted& wanted) const {
    for (const auto& [id, element] : elements)
      if (wanted(*element)) return element;
    return decltype(elements.begin()->second){};
  }
  const Camera* camera(const std::string& name) const {
    return first(home.cameras, [&](const Camera& c) { return c.name == name; }).get();
  }
  // Every model, read as the scene builder would.
  std::map<std::string, SurfaceModel> models() const {
    std::map<std::string, SurfaceModel> all;
    const auto add = [&](const ModelRef& ref) {
      if (ref.asset.empty() || all.contains(ref.asset)) return;
      const std::string folder = ref.asset.substr(0, ref.asset.rfind('/') + 1);
      const auto beside = [&](const std::string& path) -> SharedBytes {
        const auto found = home.assets->find(folder + path);
        return found == home.assets->end() ? nullptr : found->second;
      };
      all[ref.asset] =
          readModelFile(*home.assets->at(ref.asset), ref.asset, beside, {.rotation = ref.rotation});
    };
    for (const auto& [id, piece] : home.furniture) add(piece->model);
    for (const auto& [id, opening] : home.openings) add(opening->model);
    return all;
  }

  Home home;
  ImportReport report;
};

TEST_F(RealHome, StudioHasAllThatItsReadmeCounts) {
  read("Studio");
  if (IsSkipped()) return;
  EXPECT_EQ(counts(), (Counts{0, 16, 5, 48, 0, 5, 7, 3, 8, 1, 0}));
  EXPECT_TRUE(report.empty()) << report.entries.front().place << ": " << report.entries.front().what;
  EXPECT_EQ(home.name, "Studio");
  EXPECT_NE(home.properties["License"].find("CC-BY"), std::string::npos);
}

TEST_F(RealHome, ApartmentHasAllThatItsReadmeCounts) {
  read("1-BedroomApartment");
  if (IsSkipped()) return;
  EXPECT_EQ(counts(), (Counts{0, 14, 3, 109, 8, 12, 7, 4, 7, 1, 0}));
  EXPECT_TRUE(report.empty());
}

TEST_F(RealHome, MezzanineHouseHasAllThatItsReadmeCounts) {
  read("3-BedroomHouseWithMezzanine");
  if (IsSkipped()) return;
  EXPECT_EQ(counts(), (Counts{3, 67, 23, 168, 0, 37, 18, 8, 18, 2, 2}));
  EXPECT_TRUE(report.empty());
}

TEST_F(RealHome, SampleHasAllThatItsReadmeCounts) {
  read("Sample");
  if (IsSkipped()) return;
  EXPECT_EQ(counts(), (Counts{0, 18, 0, 10, 0, 10, 0, 0, 0, 0, 0}));
  ASSERT_TRUE(home.observer);
  EXPECT_NEAR(home.observer->eye.z, 1.70, kMillimetre);
  ASSERT_TRUE(home.aerial);
  EXPECT_NEAR(home.aerial->eye.z, 8.06177, kMillimetre);
}

TEST_F(RealHome, EveryModelOfEveryHomeHasFacesInItsUnitBox) {
  for (const char* name : {"Studio", "1-BedroomApartment", "3-BedroomHouseWithMezzanine", "Sample"}) {
    read(name);
    if (IsSkipped()) return;
    for (const auto& [id, piece] : home.furniture) EXPECT_FALSE(piece->model.asset.empty()) << piece->name;
    const auto all = models();
    EXPECT_GE(all.size(), 2u) << name;
    for (const auto& [path, model] : all) {
      EXPECT_GT(model.mesh.triangles.size(), 3u) << path;
      const Box3f box = model.mesh.bounds();
      EXPECT_NEAR(box.min.z, 0, 1e-4) << path;
      EXPECT_NEAR(box.max.z, 1, 1e-4) << path;
      EXPECT_NEAR(box.size().x, 1, 1e-4) << path;
      EXPECT_NEAR(box.size().y, 1, 1e-4) << path;
    }
  }
}

TEST_F(RealHome, SlopedWallsKeepBothHeights) {
  read("3-BedroomHouseWithMezzanine");
  if (IsSkipped()) return;
  const auto sloped = first(home.walls, [](const Wall& w) { return w.heightAtStart != w.heightAtEnd; });
  ASSERT_TRUE(sloped);
  EXPECT_NEAR(sloped->heightAtStart, 1.20, kMillimetre);
  EXPECT_NEAR(sloped->heightAtEnd, 0.62, kMillimetre);
  EXPECT_NEAR(sloped->start.x, 12.982, kMillimetre);
  EXPECT_NEAR(sloped->start.y, -3.298, kMillimetre);
}

TEST_F(RealHome, FourRoundWallsMakeACircle) {
  read("Sample");
  if (IsSkipped()) return;
  std::size_t clockwise = 0, counterClockwise = 0;
  for (const auto& [id, wall] : home.walls) {
    if (wall->arcExtent == 0) continue;
    EXPECT_NEAR(std::abs(wall->arcExtent), kPi / 2, 1e-6);
    const Vec2 chord = wall->end - wall->start;
    // The centre of a quarter turn lies half a chord to the side the arc turns to.
    const double side = wall->arcExtent > 0 ? 0.5 : -0.5;
    const Vec2 centre = (wall->start + wall->end) * 0.5 + perpendicular(chord) * side;
    const Vec2 expected = wall->arcExtent < 0 ? Vec2{2, -2} : Vec2{7, -2};
    EXPECT_LT(length(centre - expected), 0.05);
    ++(wall->arcExtent > 0 ? counterClockwise : clockwise);
  }
  EXPECT_EQ(clockwise, 4u);
  EXPECT_EQ(counterClockwise, 4u);
}

TEST_F(RealHome, BaseboardsRunAlongTheInnerSidesOfWalls) {
  // Left and right would be exchanged by a wrong turn of the plan; baseboards tell, as they are inside rooms.
  std::size_t inside = 0, outside = 0;
  for (const char* name : {"Studio", "3-BedroomHouseWithMezzanine"}) {
    read(name);
    if (IsSkipped()) return;
    for (const auto& [id, wall] : home.walls) {
      if (wall->left.baseboard.has_value() == wall->right.baseboard.has_value()) continue;
      const Vec2 left = perpendicular(normalized(wall->end - wall->start));
      const double out = wall->thickness / 2 + 0.1;
      const Vec2 beside = (wall->start + wall->end) * 0.5 + left * (wall->left.baseboard ? out : -out);
      bool found = false;
      for (const auto& [roomId, room] : home.rooms)
        found = found || (room->level == wall->level && contains(room->points, beside));
      ++(found ? inside : outside);
    }
  }
  EXPECT_GT(inside, 10u);
  EXPECT_EQ(outside, 0u);
}

TEST_F(RealHome, CamerasStandAtEyeHeightAboveTheirFloorAndLookIntoTheHome) {
  read("3-BedroomHouseWithMezzanine");
  if (IsSkipped()) return;
  const Camera* mezzanine = camera("Mezzanine");
  ASSERT_TRUE(mezzanine);
  // 410 cm in the file is a height in the world: 1.48 m above the upper floor at 2.62 m.
  EXPECT_NEAR(mezzanine->eye.z, 4.10, kMillimetre);
  Box2 house;
  for (const auto& [id, wall] : home.walls) house.add(wall->start), house.add(wall->end);
  const Vec2 middle = (house.min + house.max) * 0.5;
  for (const auto& [id, view] : home.cameras) {
    const Vec3 direction = viewDirection(*view);
    const Vec2 flat{direction.x, direction.y};
    EXPECT_GT(dot(flat, middle - Vec2{view->eye.x, view->eye.y}), 0)
        << view->name << " looks out of the house";
  }
}

TEST_F(RealHome, NoonAtTheHomeIsTenOClockInUtcThere) {
  read("3-BedroomHouseWithMezzanine");
  if (IsSkipped()) return;
  // The file says 2017-04-27 12:00 by the clock in Paris, which was two hours ahead.
  EXPECT_EQ(home.site.timeZone, "Europe/Paris");
  EXPECT_EQ(camera("Kitchen")->time, 1493294400000 - 2 * 3600 * 1000);
  EXPECT_EQ(home.site.time, 1493294400000 - 2 * 3600 * 1000);
  EXPECT_NEAR(home.site.north, 2 * kPi - 5.4454274, 1e-6);
}

TEST_F(RealHome, OpeningsSitInTheWallsTheyCut) {
  for (const char* name : {"Studio", "1-BedroomApartment", "Sample"}) {
    read(name);
    if (IsSkipped()) return;
    for (const auto& [id, opening] : home.openings) {
      EXPECT_TRUE(opening->wall) << name << ": " << opening->name;
      EXPECT_TRUE(opening->cutsWalls);
    }
  }
}

TEST_F(RealHome, LampsGiveWhatHouseholdLampsGive) {
  for (const char* name : {"Studio", "1-BedroomApartment", "3-BedroomHouseWithMezzanine"}) {
    read(name);
    if (IsSkipped()) return;
    for (const auto& [id, piece] : home.furniture) {
      if (!piece->lamp) continue;
      EXPECT_GT(piece->lamp->lumens, 200) << piece->name;
      EXPECT_LT(piece->lamp->lumens, 1500) << piece->name;
      ASSERT_TRUE(piece->lamp->color);
      EXPECT_EQ(piece->lamp->color->r, 1) << "warm light is reddest";
      EXPECT_LT(piece->lamp->color->b, piece->lamp->color->r);
      EXPECT_EQ(piece->lamp->sources.size(), 1u);
    }
  }
}

TEST_F(RealHome, PiecesInGroupsKeepTheirGroupAndTheirPlace) {
  read("1-BedroomApartment");
  if (IsSkipped()) return;
  std::map<GroupId, std::size_t> members;
  for (const auto& [id, piece] : home.furniture)
    if (piece->group) ++members[piece->group];
  EXPECT_EQ(members.size(), 8u);
  for (const auto& [group, count] : members) EXPECT_TRUE(home.groups.contains(group));
  std::size_t all = 0;
  for (const auto& [group, count] : members) all += count;
  EXPECT_EQ(all, 37u);
}

TEST_F(RealHome, MirroredModelsAndGlassAndInvisiblePartsComeThrough) {
  read("3-BedroomHouseWithMezzanine");
  if (IsSkipped()) return;
  const auto stairs = first(home.furniture, [](const Furniture& f) { return !f.staircaseCutOut.empty(); });
  ASSERT_TRUE(stairs);
  EXPECT_TRUE(stairs->mirrored);
  EXPECT_NEAR(stairs->position.x, 13.376118, kMillimetre);
  EXPECT_NEAR(stairs->position.y, -3.3579626, kMillimetre);
  EXPECT_EQ(stairs->slotFinishes.at("flblonde").color, (Color{0x97 / 255.f, 0x87 / 255.f, 0x7C / 255.f}));

  const auto window = first(home.openings, [](const Opening& o) { return o.name == "Slider window"; });
  ASSERT_TRUE(window);
  const SurfaceModel model = models().at(window->model.asset);
  const auto pane = std::find_if(model.slots.begin(), model.slots.end(),
                                 [](const SurfaceModel::Slot& s) { return s.material.transmission > 0.5; });
  ASSERT_NE(pane, model.slots.end()) << "window panes are glass";
  EXPECT_EQ(pane->name, "flltgrey");
}

}  // namespace
}  // namespace idap
