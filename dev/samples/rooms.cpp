#include "rooms.h"

#include "home_maker.h"

namespace idap::samples {

namespace {

constexpr double kOuter = 0.2;     // m, thickness of outer walls
constexpr double kO = kOuter / 2;  // from a room's edge to the centre line of its wall

Polygon rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

}  // namespace

Home bedroom() {
  constexpr double w = 4.0, d = 4.2;
  HomeMaker m("Bedroom", 2.6);
  const auto walls = m.shell(w, d, kOuter, "warm-white-paint", "cream-paint");
  m.paint(walls.north, "dusty-blue-paint");
  m.room("Bedroom", rectangle(0, 0, w, d), "light-oak-planks");
  m.opening("door-panelled", walls.south, {0.75, -kO}, kNorth, 0, {0.85, 2.05});
  m.opening("window-triple", walls.east, {w + kO, 2.15}, kWest, 0.85, {2.1, 1.4});

  m.put("rug-plain", {1.9, 2.5}, kSouth, -1, {2.6, 1.8, 0});
  m.against("bed-channel", {1.9, d}, kSouth);
  for (const double x : {0.68, 3.12}) {
    m.against("night-table-drawers", {x, d}, kSouth);
    m.against("light-bedside", {x, d - 0.06}, kSouth, 0.5);
  }
  m.against("picture-dusk", {1.9, d}, kSouth, 1.45);
  m.against("wardrobe-sliding", {2.95, 0}, kNorth);
  m.against("vanity-oval", {0, 1.75}, kEast);
  m.put("vanity-stool", {0.76, 1.75}, kWest);
  m.against("curtain", {w, 2.15}, kWest, -1, {2.7, 0, 0});
  m.put("plant-snake", {3.72, 3.9});
  m.put("light-drum", {1.9, 2.0}, kSouth, -1, {0.55, 0.55, 0.5});

  m.camera("Towards the bed", {3.55, 0.85, 1.5}, {1.3, 3.6, 0.75}, 72);
  m.camera("From the door", {0.55, 0.25, 1.55}, {2.7, 3.2, 0.8}, 78);
  m.camera("Dressing table", {2.5, 1.15, 1.4}, {0.1, 1.85, 0.95}, 62);
  return m.take();
}

Home livingRoom() {
  constexpr double w = 5.4, d = 4.2;
  HomeMaker m("Living room", 2.7);
  const auto walls = m.shell(w, d, kOuter, "warm-white-paint", "cream-paint");
  m.paint(walls.north, "sage-paint");
  m.room("Living room", rectangle(0, 0, w, d), "oak-herringbone");
  m.opening("door-glazed", walls.north, {0.75, d + kO}, kSouth, 0, {0.9, 2.1});
  m.opening("door-sliding-glass", walls.south, {2.75, -kO}, kNorth, 0, {2.6, 2.25});
  m.opening("window-fixed", walls.west, {-kO, 1.95}, kEast, 1.05, {1.8, 1.2});

  m.put("rug", {1.85, 1.95}, kEast, -1, {2.6, 1.9, 0});
  m.against("sofa-three", {0, 1.95}, kEast);
  m.put("table-coffee", {1.85, 1.95}, kEast);
  m.put("books-stack", {1.8, 2.2}, 0.4, 0.42);
  m.put("candles", {1.9, 1.65}, kEast, 0.42);
  m.put("armchair-lounge", {2.3, 3.4}, kSouth - 0.35);
  m.put("pouf-knitted", {3.05, 1.0});
  m.against("tv-bench", {w, 1.95}, kWest);
  m.against("tv-feet", {w - 0.06, 1.95}, kWest, 0.48);
  m.against("bookcase-wide", {3.95, d}, kSouth, -1, {2.6, 0, 2.3});
  m.against("picture-landscape", {w, 3.25}, kWest, 1.35, {0.8, 0, 0.6});
  m.put("light-tripod", {0.42, 0.45});
  m.put("plant-monstera", {4.9, 0.52}, kSouth, -1, {0.85, 0.85, 1.15});
  m.against("curtain-sheer", {1.3, 0}, kNorth, -1, {0.8, 0, 0});
  m.against("curtain-sheer", {4.1, 0}, kNorth, -1, {0.8, 0, 0});
  m.put("light-lantern", {1.9, 1.95}, kSouth, -1, {0.6, 0.6, 0.8});
  m.put("light-lantern", {4.0, 1.95}, kSouth, -1, {0.45, 0.45, 0.7});

  m.camera("Towards the television", {0.3, 3.2, 1.5}, {4.9, 1.7, 0.85}, 74);
  m.camera("Towards the garden", {4.65, 3.55, 1.55}, {1.3, 0.7, 0.8}, 78);
  m.camera("Reading corner", {3.6, 0.5, 1.4}, {2.9, 4.0, 1.1}, 76);
  return m.take();
}

Home kitchen() {
  constexpr double w = 4.2, d = 3.7;
  HomeMaker m("Kitchen", 2.6);
  const auto walls = m.shell(w, d, kOuter, "warm-white-paint", "cream-paint");
  m.paint(walls.north, "metro-tiles");
  m.room("Kitchen", rectangle(0, 0, w, d), "grey-tiles");
  m.opening("door-glazed", walls.west, {-kO, 0.8}, kEast, 0, {0.9, 2.1});
  m.opening("window-double", walls.north, {1.7, d + kO}, kSouth, 1.2, {1.0, 1.0});
  m.opening("window-triple", walls.south, {2.3, -kO}, kNorth, 0.85, {2.1, 1.4});

  // One run of units from wall to wall; the worktops meet.
  double x = 0;
  const auto unit = [&](const char* id, double width) {
    m.against(id, {x + width / 2, d}, kSouth, -1, {width, 0, 0});
    x += width;
  };
  unit("fridge", 0.6);
  unit("kitchen-base-drawers", 0.8);
  unit("kitchen-sink", 0.8);
  unit("kitchen-base", 0.6);
  unit("kitchen-hob", 0.6);
  unit("kitchen-base-drawers", 0.8);
  m.against("kitchen-wall", {0.9, d}, kSouth, 1.45);
  m.against("kitchen-wall", {2.5, d}, kSouth, 1.45);
  m.against("kitchen-hood", {3.1, d}, kSouth, 1.6);
  m.against("kitchen-wall", {3.8, d}, kSouth, 1.45, {0.8, 0, 0});
  m.put("plant-herb", {2.42, d - 0.25}, kSouth, 0.9);
  m.put("fruit-bowl", {3.8, d - 0.3}, kSouth, 0.9);

  m.put("table-dining", {2.3, 1.4});
  for (const double at : {1.92, 2.68}) {
    m.put("chair-shell", {at, 0.63}, kNorth);
    m.put("chair-shell", {at, 2.17}, kSouth);
    m.put("light-cone", {at, 1.4});
  }
  m.put("plant-daisies", {2.3, 1.4}, kSouth, 0.75);
  m.against("sideboard-slats", {w, 1.3}, kWest);
  m.put("vase", {w - 0.24, 0.75}, kWest, 0.78);
  m.put("radio", {w - 0.24, 1.6}, kWest, 0.78);
  m.against("picture-abstract", {w, 1.3}, kWest, 1.3);
  m.against("wall-clock", {0, 2.0}, kEast, 1.75);
  m.put("light-spots", {1.7, 2.75});
  m.put("light-spots", {3.2, 2.75});

  m.camera("Counter", {3.5, 0.3, 1.55}, {1.75, 3.4, 1.0}, 74);
  m.camera("Table", {0.35, 2.65, 1.5}, {2.9, 1.0, 0.75}, 72);
  return m.take();
}

Home bathroom() {
  constexpr double w = 2.6, d = 2.8;
  HomeMaker m("Bathroom", 2.5);
  const auto walls = m.shell(w, d, kOuter, "white-tiles", "cream-paint");
  m.paint(walls.north, "green-metro-tiles");
  m.room("Bathroom", rectangle(0, 0, w, d), "terrazzo");
  m.opening("door-flush", walls.south, {0.75, -kO}, kNorth, 0, {0.8, 2.05});
  m.opening("window-single", walls.north, {1.75, d + kO}, kSouth, 1.35, {0.8, 0.8});

  m.against("bathtub", {1.735, d}, kSouth);
  m.against("basin-cabinet-double", {w, 1.1}, kWest);
  m.against("toilet", {0, 1.4}, kEast);
  m.against("washing-machine", {0.45, d}, kSouth);
  m.put("plant-succulent", {0.33, d - 0.3}, kSouth, 0.85);
  m.against("towel-rail", {0, 0.62}, kEast, 0.9, {0.45, 0, 0.9});
  m.put("rug-plain", {1.45, 1.6}, kSouth, -1, {0.9, 0.6, 0.02});
  m.put("light-flush", {1.2, 1.4});
  m.put("light-downlight", {2.2, 0.75});
  m.put("light-downlight", {2.2, 1.45});

  m.camera("From the door", {0.6, 0.12, 1.55}, {1.65, 2.5, 0.75}, 82);
  m.camera("Washbasins", {0.35, 1.95, 1.55}, {2.4, 0.9, 1.0}, 78);
  return m.take();
}

Home office() {
  constexpr double w = 4.8, d = 4.0;
  HomeMaker m("Office", 2.7);
  const auto walls = m.shell(w, d, kOuter, "light-grey-paint", "cream-paint");
  m.paint(walls.west, "navy-paint");
  m.room("Office", rectangle(0, 0, w, d), "walnut-planks");
  m.opening("door-flush", walls.north, {1.0, d + kO}, kSouth, 0, {0.9, 2.1});
  m.opening("window-loft", walls.south, {1.4, -kO}, kNorth, 0.7, {1.9, 1.7});
  m.opening("window-loft", walls.south, {3.5, -kO}, kNorth, 0.7, {1.9, 1.7});

  m.put("rug-plain", {2.35, 2.2}, kEast, -1, {2.5, 1.9, 0});
  m.put("desk-pedestal", {2.75, 2.2}, kEast);
  m.put("chair-executive", {3.56, 2.2}, kWest);
  m.put("monitor", {2.58, 2.25}, kEast, 0.75);
  m.put("laptop", {2.85, 1.75}, kEast - 0.2, 0.75);
  m.put("light-desk", {2.6, 2.8}, kEast, 0.75, {0.4, 0.18, 0.45});
  m.put("chair-cantilever", {1.95, 1.78}, kEast);
  m.put("chair-cantilever", {1.95, 2.62}, kEast);
  m.against("bookcase-wide", {w, 2.2}, kWest);
  m.against("sofa-two", {0, 1.3}, kEast);
  m.put("table-side", {1.2, 0.45});
  m.put("plant-succulent", {1.2, 0.45}, kSouth, 0.52);
  m.put("plant-rubber", {0.42, 2.65}, kSouth, -1, {0.65, 0.65, 1.5});
  m.against("cabinet-cane", {2.55, d}, kSouth);
  m.put("vase-grass", {2.55, d - 0.21}, kSouth, 1.2, {0.35, 0.35, 0.6});
  m.against("air-conditioner", {3.7, d}, kSouth, 2.2);
  m.against("picture-blue", {0, 0.95}, kEast, 1.3);
  m.against("picture-abstract", {0, 1.65}, kEast, 1.25);
  for (const double x : {1.3, 3.3}) m.put("light-panel", {x, 2.1});

  m.camera("Desk", {0.6, 3.4, 1.55}, {3.3, 1.6, 0.85}, 72);
  m.camera("From the desk", {4.2, 2.7, 1.45}, {0.6, 1.6, 0.9}, 74);
  return m.take();
}

Home studioApartment() {
  constexpr double w = 6.6, d = 5.4;            // inside
  constexpr double bathX = 2.25, bathY = 3.55;  // centre lines of the bathroom's walls
  HomeMaker m("Studio apartment", 2.6);
  const auto walls = m.shell(w, d, kOuter, "warm-white-paint", "cream-paint");
  m.paint(walls.west, "sage-paint");
  const WallId bathSouth = m.wall({-kO, bathY}, {bathX, bathY}, 0.1, "white-tiles", "warm-white-paint");
  const WallId bathEast = m.wall({bathX, bathY}, {bathX, d + kO}, 0.1, "white-tiles", "warm-white-paint");
  m.join(bathSouth, bathEast);
  m.room("Studio",
         {{0, 0}, {w, 0}, {w, d}, {bathX + 0.05, d}, {bathX + 0.05, bathY - 0.05}, {0, bathY - 0.05}},
         "oak-planks");
  m.room("Bathroom", rectangle(0, bathY + 0.05, bathX - 0.05, d), "grey-tiles");
  m.opening("door-front", walls.north, {2.9, d + kO}, kSouth, 0, {1.0, 2.15});
  m.opening("door-panelled", bathEast, {bathX, 4.15}, kWest, 0, {0.75, 2.05});
  m.opening("door-sliding-glass", walls.south, {4.6, -kO}, kNorth, 0, {2.4, 2.2});
  m.opening("window-double", walls.south, {1.15, -kO}, kNorth, 0.9, {1.4, 1.3});
  m.opening("window-double", walls.north, {5.0, d + kO}, kSouth, 1.2, {1.0, 1.0});
  m.opening("window-single", walls.west, {-kO, 4.05}, kEast, 1.5, {0.6, 0.7});

  // Sleeping
  m.against("bed-double", {0, 1.35}, kEast);
  for (const double y : {0.265, 2.435}) {
    m.against("night-table", {0, y}, kEast);
    m.against("light-bedside", {0.06, y}, kEast, 0.55);
  }
  m.against("picture-landscape", {0, 1.35}, kEast, 1.4);
  m.against("wardrobe-sliding", {1.15, bathY - 0.05}, kSouth);
  m.against("curtain-sheer", {1.2, 0}, kNorth, -1, {1.5, 0, 0});
  // Living, behind a shelf that parts the two
  m.put("shelf-cubes", {2.93, 1.5}, kEast);
  m.put("tv-bench", {3.34, 1.5}, kEast, -1, {1.6, 0, 0});
  m.put("tv-feet", {3.34, 1.5}, kEast, 0.48, {1.1, 0, 0.68});
  m.put("rug-round", {4.7, 1.5}, kSouth, -1, {2.0, 2.0, 0});
  m.put("table-coffee-round", {4.75, 1.5});
  m.put("plant-tulips", {4.85, 1.6}, kSouth, 0.42);
  m.against("sofa-two", {w, 1.5}, kWest);
  m.put("light-tripod", {6.28, 0.34}, kSouth, -1, {0.5, 0.5, 0});
  m.put("plant-palm", {6.15, 2.83}, kSouth, -1, {0.78, 0.78, 1.6});
  m.against("curtain-sheer", {3.25, 0}, kNorth, -1, {0.8, 0, 0});
  m.against("curtain-sheer", {5.6, 0}, kNorth, -1, {0.8, 0, 0});
  // Kitchen and table
  m.against("fridge", {4.3, d}, kSouth);
  m.against("kitchen-sink", {5.0, d}, kSouth);
  m.against("kitchen-hob", {5.7, d}, kSouth);
  m.against("kitchen-base", {6.3, d}, kSouth);
  m.against("kitchen-hood", {5.82, d}, kSouth, 1.6, {0.6, 0, 0});
  m.against("kitchen-wall", {6.36, d}, kSouth, 1.45, {0.45, 0, 0});
  m.against("shoe-cabinet", {3.7, d}, kSouth, -1, {0.55, 0, 0});
  m.put("table-pedestal", {5.25, 3.6}, kSouth, -1, {0.9, 0.9, 0});
  m.put("chair-windsor", {4.47, 3.6}, kEast);
  m.put("chair-windsor", {6.03, 3.6}, kWest);
  m.put("fruit-bowl", {5.25, 3.6}, kSouth, 0.75);
  m.put("light-dome", {5.25, 3.6});
  // Bathroom
  m.put("shower", {0.47, d - 0.47});
  m.against("toilet", {1.35, d}, kSouth);
  m.against("washbasin", {0.55, bathY + 0.05}, kNorth);
  m.against("mirror-round", {0.55, bathY + 0.05}, kNorth, 1.3, {0.6, 0, 0.6});
  m.put("light-flush", {1.1, 4.5});

  m.put("light-drum", {1.6, 1.35}, kSouth, -1, {0.45, 0.45, 0.45});
  m.put("light-lantern", {4.75, 1.5}, kSouth, -1, {0.5, 0.5, 0.7});
  m.put("light-flush", {2.95, 4.0});

  m.camera("From the entrance", {2.75, 4.9, 1.6}, {4.9, 0.9, 0.8}, 78);
  m.camera("Sofa and kitchen", {3.3, 2.75, 1.5}, {6.2, 3.4, 0.9}, 84);
  m.camera("Bed", {2.6, 2.5, 1.5}, {0.3, 0.8, 0.75}, 80);
  return m.take();
}

Home twoBedroomApartment() {
  constexpr double w = 10.0, d = 8.2;  // inside
  constexpr double px = 5.35;          // centre line of the wall between living and sleeping
  constexpr double y1 = 3.35, y2 = 5.25, cx = 8.05;
  constexpr double west = px - 0.05, east = px + 0.05;  // its faces
  HomeMaker m("Two-bedroom apartment", 2.6);
  const auto walls = m.shell(w, d, kOuter, "warm-white-paint", "cream-paint");
  m.paint(walls.west, "greige-paint");
  const WallId spine = m.wall({px, -kO}, {px, d + kO}, 0.1, "warm-white-paint", "warm-white-paint");
  const WallId south = m.wall({px, y1}, {w + kO, y1}, 0.1, "white-tiles", "blush-paint");
  m.wall({px, y2}, {w + kO, y2}, 0.1, "sky-paint", "white-tiles");
  m.wall({cx, y1}, {cx, y2}, 0.1, "white-tiles", "warm-white-paint");
  m.room("Living room and kitchen", rectangle(0, 0, west, d), "oak-herringbone");
  m.room("Main bedroom", rectangle(east, 0, w, y1 - 0.05), "light-oak-planks");
  m.room("Bathroom", rectangle(east, y1 + 0.05, cx - 0.05, y2 - 0.05), "grey-tiles");
  m.room("Dressing room", rectangle(cx + 0.05, y1 + 0.05, w, y2 - 0.05), "light-oak-planks");
  m.room("Second bedroom", rectangle(east, y2 + 0.05, w, d), "light-oak-planks");

  m.opening("door-front", walls.north, {4.6, d + kO}, kSouth, 0, {1.0, 2.15});
  m.opening("door-panelled", spine, {px, 2.85}, kEast, 0, {0.8, 2.05});
  m.opening("door-panelled", spine, {px, 4.6}, kEast, 0, {0.75, 2.05});
  m.opening("door-panelled", spine, {px, 5.8}, kEast, 0, {0.8, 2.05});
  m.opening("door-panelled", south, {9.52, y1}, kNorth, 0, {0.7, 2.05});
  m.opening("door-sliding-glass", walls.south, {2.7, -kO}, kNorth, 0, {2.8, 2.25});
  m.opening("window-fixed", walls.west, {-kO, 4.5}, kEast, 0.7, {1.8, 1.5});
  m.opening("window-double", walls.north, {1.8, d + kO}, kSouth, 1.2, {1.2, 1.0});
  m.opening("window-triple", walls.east, {w + kO, 1.6}, kWest, 0.85, {2.0, 1.4});
  m.opening("window-double", walls.south, {8.0, -kO}, kNorth, 0.9, {1.4, 1.3});
  m.opening("window-single", walls.east, {w + kO, 4.0}, kWest, 1.3, {0.6, 0.8});
  m.opening("window-double", walls.north, {6.95, d + kO}, kSouth, 0.95, {1.4, 1.25});
  m.opening("window-double", walls.east, {w + kO, 6.2}, kWest, 0.9, {1.2, 1.3});

  // Living room
  m.put("rug", {1.85, 1.5}, kEast, -1, {2.5, 1.9, 0});
  m.against("sofa-three", {0, 1.5}, kEast);
  m.put("table-coffee", {1.85, 1.5}, kEast);
  m.put("books-stack", {1.85, 1.75}, 0.4, 0.42);
  m.put("armchair-tub", {2.95, 2.2}, kWest - 0.25);
  m.against("tv-bench", {west, 1.5}, kWest);
  m.against("tv-feet", {west - 0.06, 1.5}, kWest, 0.48);
  m.put("light-tripod", {0.42, 2.95});
  m.put("plant-palm", {0.52, 3.75}, kSouth, -1, {0.8, 0.8, 1.6});
  m.against("curtain-sheer", {1.1, 0}, kNorth, -1, {0.8, 0, 0});
  m.against("curtain-sheer", {4.3, 0}, kNorth, -1, {0.8, 0, 0});
  m.put("light-lantern", {1.85, 1.5}, kSouth, -1, {0.55, 0.55, 0.75});
  // Dining
  m.put("table-dining", {3.1, 3.85});
  for (const double x : {2.7, 3.5}) {
    m.put("chair-dining", {x, 3.06}, kNorth);
    m.put("chair-dining", {x, 4.64}, kSouth);
    m.put("light-dome", {x, 3.85}, kSouth, -1, {0.35, 0.35, 0.95});
  }
  m.put("fruit-bowl", {3.1, 3.85}, kSouth, 0.75);
  m.against("picture-landscape", {west, 3.75}, kWest, 1.35, {0.8, 0, 0.6});
  // Kitchen
  double x = 0;
  const auto unit = [&](const char* id, double width) {
    m.against(id, {x + width / 2, d}, kSouth, -1, {width, 0, 0});
    x += width;
  };
  unit("fridge", 0.6);
  unit("kitchen-base-drawers", 0.8);
  unit("kitchen-sink", 0.8);
  unit("kitchen-base", 0.6);
  unit("kitchen-hob", 0.6);
  unit("kitchen-base", 0.4);
  m.against("kitchen-wall", {0.9, d}, kSouth, 1.45);
  m.against("kitchen-hood", {3.1, d}, kSouth, 1.6);
  m.put("kitchen-island", {1.9, 6.1}, kNorth);
  for (const double at : {1.3, 1.9, 2.5}) m.put("stool-bar", {at, 5.36}, kNorth);
  m.put("plant-herb", {2.5, d - 0.25}, kSouth, 0.9);
  for (const double at : {1.4, 2.4}) m.put("light-globe", {at, 6.1});
  m.put("light-spots", {1.9, 7.2});
  m.put("light-flush", {4.6, 6.8});
  m.against("shoe-cabinet", {west, 6.7}, kWest);
  // Main bedroom
  m.put("rug-plain", {7.67, 1.4}, kSouth, -1, {2.6, 1.5, 0});
  m.against("bed-upholstered", {7.67, y1 - 0.05}, kSouth);
  for (const double at : {6.475, 8.865}) {
    m.against("night-table", {at, y1 - 0.05}, kSouth);
    m.against("light-bedside", {at, y1 - 0.11}, kSouth, 0.55);
  }
  m.against("picture-dusk", {7.67, y1 - 0.05}, kSouth, 1.5);
  m.against("vanity-round", {6.3, 0}, kNorth);
  m.put("vanity-stool-round", {6.3, 0.72});
  m.against("chest-of-drawers", {east, 1.35}, kEast);
  m.put("vase", {east + 0.24, 1.35}, kEast, 0.95);
  m.against("curtain", {w, 1.6}, kWest, -1, {2.5, 0, 0});
  m.put("light-drum", {7.67, 1.6}, kSouth, -1, {0.5, 0.5, 0.45});
  // Dressing room
  m.against("wardrobe-hinged", {9.05, y2 - 0.05}, kSouth, -1, {1.8, 0, 0});
  m.put("light-flush", {9.05, 4.0});
  // Bathroom
  m.put("shower", {cx - 0.05 - 0.47, y2 - 0.05 - 0.47});
  m.against("basin-cabinet", {6.62, y2 - 0.05}, kSouth);
  m.against("toilet", {6.75, y1 + 0.05}, kNorth);
  m.against("washing-machine", {7.65, y1 + 0.05}, kNorth);
  m.against("towel-rail", {east, 3.75}, kEast, 0.9, {0.45, 0, 0.9});
  m.put("light-flush", {6.7, 4.3});
  // Second bedroom
  m.against("bed-single", {w, 7.65}, kWest);
  m.against("night-table", {w, 6.9}, kWest);
  m.put("light-table", {w - 0.22, 6.9}, kWest, 0.55, {0.26, 0.26, 0.42});
  m.against("desk-writing", {6.95, d}, kSouth);
  m.put("chair-office", {6.95, 7.15}, kNorth);
  m.put("laptop", {6.9, d - 0.3}, kSouth, 0.75);
  m.put("light-desk", {7.35, d - 0.25}, kSouth, 0.75, {0.4, 0.18, 0.45});
  m.against("bookcase", {east, 7.3}, kEast);
  m.against("wardrobe-hinged", {8.4, y2 + 0.05}, kNorth);
  m.put("rug-round", {8.2, 6.65}, kSouth, -1, {1.3, 1.3, 0});
  m.against("roller-blind", {6.95, d}, kSouth, 1.0, {1.4, 0, 1.2});
  m.put("light-cone", {7.7, 6.6}, kSouth, -1, {0.36, 0.36, 0.6});

  m.camera("Living room", {4.75, 3.1, 1.55}, {0.9, 0.9, 0.75}, 76);
  m.camera("Kitchen", {4.7, 4.9, 1.55}, {1.6, 7.4, 0.95}, 72);
  m.camera("Main bedroom", {9.6, 0.35, 1.5}, {6.8, 2.9, 0.75}, 76);
  m.camera("Second bedroom", {5.75, 5.6, 1.5}, {8.6, 7.6, 0.75}, 78);
  return m.take();
}

}  // namespace idap::samples
