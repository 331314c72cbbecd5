// The welcome page's templates are homes that one could live in: everything stands on the floor or on
// something, nothing stands in another's place or in a door's way.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "catalog/catalog.h"
#include "formats/registry.h"
#include "geometry/polygon.h"

namespace idap {
namespace {

namespace fs = std::filesystem;

constexpr double kTolerance = 0.01;  // m, that boxes may run into each other

fs::path folder() { return fs::path(IDAP_SOURCE_DIR) / "share/templates"; }

nlohmann::json index() {
  std::ifstream file(folder() / "index.json");
  return nlohmann::json::parse(file);
}

bool isRug(const Furniture& f) { return f.position.z == 0 && f.size.z < 0.03; }

// How far two turned boxes run into each other on the plan, m; negative: apart.
double overlap(const Piece& a, const Piece& b) {
  const auto p = footprint(a), q = footprint(b);
  double least = 1e9;
  for (const auto* box : {&p, &q}) {
    for (int k = 0; k < 2; ++k) {
      const Vec2 along = (*box)[std::size_t(k + 1)] - (*box)[std::size_t(k)];
      const double length = std::hypot(along.x, along.y);
      const Vec2 axis{along.x / length, along.y / length};
      const auto range = [&](const std::array<Vec2, 4>& corners) {
        double low = 1e9, high = -1e9;
        for (const Vec2 c : corners) {
          low = std::min(low, c.x * axis.x + c.y * axis.y);
          high = std::max(high, c.x * axis.x + c.y * axis.y);
        }
        return std::pair{low, high};
      };
      const auto [pLow, pHigh] = range(p);
      const auto [qLow, qHigh] = range(q);
      least = std::min(least, std::min(pHigh, qHigh) - std::max(pLow, qLow));
    }
  }
  return least;
}

// Round things reach their box's corners with nothing.
bool isRound(const Furniture& f) {
  for (const char* word : {"round", "pedestal", "light", "plant", "pouf", "stool", "vase", "bowl"})
    if (f.model.catalogId.find(word) != std::string::npos) return true;
  return false;
}

bool inside(const Piece& piece, Vec2 at) {
  const double c = std::cos(piece.angle), s = std::sin(piece.angle);
  const Vec2 d = at - Vec2{piece.position.x, piece.position.y};
  const double x = d.x * c + d.y * s, y = -d.x * s + d.y * c;
  return std::abs(x) < piece.size.x / 2 - kTolerance && std::abs(y) < piece.size.y / 2 - kTolerance;
}

class Templates : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { home = readHome(folder() / GetParam()).home; }
  Home home;
  Catalog catalog{std::vector<fs::path>{}};
};

TEST_P(Templates, ReadsWithNothingToMend) {
  const ReadResult read = readHome(folder() / GetParam());
  EXPECT_TRUE(read.report.empty());
}

TEST_P(Templates, HasRoomsDoorsWindowsLampsAndPointsOfView) {
  EXPECT_FALSE(home.rooms.empty());
  for (const auto& [id, room] : home.rooms) EXPECT_NE(room->name, "");
  EXPECT_GE(home.cameras.size(), 2u);
  int doors = 0, windows = 0, lamps = 0;
  for (const auto& [id, opening] : home.openings) {
    doors += opening->kind == OpeningKind::Door;
    windows += opening->kind == OpeningKind::Window;
    EXPECT_TRUE(home.walls.find(opening->wall)) << opening->name;
  }
  for (const auto& [id, piece] : home.furniture) lamps += piece->lamp.has_value();
  EXPECT_GE(doors, int(home.rooms.size()));
  EXPECT_GE(windows, 1);
  EXPECT_GE(lamps, int(home.rooms.size()));
}

TEST_P(Templates, PiecesAreOfTheCatalogInASizeItAllows) {
  for (const auto& [id, piece] : home.furniture) {
    const CatalogPiecePtr kind = catalog.find(piece->model.catalogId);
    ASSERT_TRUE(kind) << piece->model.catalogId;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(piece->size[axis], kind->minSize[axis] - 1e-9) << kind->id << " axis " << axis;
      if (kind->maxSize[axis] > 0) {
        EXPECT_LE(piece->size[axis], kind->maxSize[axis] + 1e-9) << kind->id << " axis " << axis;
      }
    }
  }
}

TEST_P(Templates, NothingStandsInAnothersPlace) {
  for (const auto& [id, a] : home.furniture) {
    for (const auto& [other, b] : home.furniture) {
      if (!(id < other) || isRug(*a) || isRug(*b)) continue;
      const double high = std::min(a->position.z + a->size.z, b->position.z + b->size.z);
      if (high - std::max(a->position.z, b->position.z) < kTolerance) continue;
      const double allowed = isRound(*a) || isRound(*b) ? 0.06 : kTolerance;
      EXPECT_LT(overlap(*a, *b), allowed) << a->model.catalogId << " and " << b->model.catalogId << " at "
                                          << b->position.x << ", " << b->position.y;
    }
  }
}

TEST_P(Templates, EverythingIsInARoom) {
  for (const auto& [id, piece] : home.furniture) {
    const auto corners = footprint(*piece);
    bool found = false;
    for (const auto& [roomId, room] : home.rooms)
      found = found || std::ranges::all_of(corners, [&](Vec2 c) {
                // Towards the middle, so that what touches a wall counts as inside.
                const Vec2 middle{piece->position.x, piece->position.y};
                return contains(room->points, c + (middle - c) * 0.02);
              });
    EXPECT_TRUE(found) << piece->model.catalogId << " at " << piece->position.x << ", " << piece->position.y;
  }
}

TEST_P(Templates, NothingFloats) {
  for (const auto& [id, piece] : home.furniture) {
    const double base = piece->position.z;
    if (base == 0) continue;
    const CatalogPiecePtr kind = catalog.find(piece->model.catalogId);
    if (kind->ceilingMounted) {
      EXPECT_NEAR(base + piece->size.z, home.wallHeight, 1e-6) << kind->id;
      continue;
    }
    bool held = false;
    for (const auto& [other, table] : home.furniture) {
      const double top = table->position.z + table->dropOnTopHeight.value_or(table->size.z);
      held = held || (std::abs(top - base) < 0.025 && inside(*table, {piece->position.x, piece->position.y}));
    }
    // Or its back is at a wall.
    const auto corners = footprint(*piece);
    const Vec2 back = (corners[2] + corners[3]) * 0.5;
    for (const auto& [wallId, wall] : home.walls) {
      const Vec2 along = wall->end - wall->start;
      const double length = std::hypot(along.x, along.y);
      const Vec2 to = back - wall->start;
      const double at = (to.x * along.x + to.y * along.y) / length;
      const double away = std::abs(to.x * along.y - to.y * along.x) / length - wall->thickness / 2;
      held = held || (at > 0 && at < length && away < 0.08);
    }
    EXPECT_TRUE(held) << kind->id << " at " << piece->position.x << ", " << piece->position.y << ", " << base;
  }
}

TEST_P(Templates, DoorsSwingFreely) {
  for (const auto& [id, door] : home.openings) {
    if (door->kind != OpeningKind::Door) continue;
    const double c = std::cos(door->angle), s = std::sin(door->angle);
    for (const Sash& sash : door->sashes) {
      const double radius = sash.width * door->size.x;
      for (int step = 0; step <= 20; ++step) {
        const double angle = sash.startAngle + (sash.endAngle - sash.startAngle) * step / 20;
        for (double r = 0.1; r <= radius; r += 0.04) {
          const double x = (sash.axis.x - 0.5) * door->size.x + r * std::cos(angle);
          const double y = (0.5 - sash.axis.y) * door->size.y + r * std::sin(angle);
          const Vec2 at{door->position.x + x * c - y * s, door->position.y + x * s + y * c};
          for (const auto& [other, piece] : home.furniture) {
            if (isRug(*piece) || piece->position.z >= door->size.z) continue;
            ASSERT_FALSE(inside(*piece, at)) << piece->model.catalogId << " in the way of " << door->name
                                             << " at " << door->position.x << ", " << door->position.y;
          }
        }
      }
    }
  }
}

std::vector<std::string> files() {
  std::vector<std::string> out;
  for (const auto& entry : index()) out.push_back(entry.at("file"));
  return out;
}

std::string testName(const testing::TestParamInfo<std::string>& file) {
  std::string name = file.param;
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, Templates, testing::ValuesIn(files()), testName);

TEST(TemplatesIndex, NamesEveryHomeAndItsPicture) {
  const nlohmann::json all = index();
  EXPECT_EQ(all.size(), 7u);
  std::size_t homes = 0;
  for (const auto& entry : fs::directory_iterator(folder())) homes += entry.path().extension() == ".idap";
  EXPECT_EQ(all.size(), homes);
  for (const auto& entry : all) {
    for (const char* language : {"en", "th"}) EXPECT_NE(entry.at("name").at(language), "");
    EXPECT_TRUE(fs::exists(folder() / entry.at("picture"))) << entry;
  }
}

}  // namespace
}  // namespace idap
