// Small homes made in memory: what each element becomes, and what hostile ones do.
#include <gtest/gtest.h>

#include <map>

#include "base/error.h"
#include "base/zip.h"
#include "formats/sh3d/sh3d_reader.h"
#include "geometry/svg_path.h"

namespace idap {
namespace {

constexpr double kExact = 1e-9;
using Files = std::map<std::string, std::string>;

SharedBytes bytesOf(const std::string& text) {
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return std::make_shared<const Bytes>(begin, begin + text.size());
}

SharedBytes archiveOf(const Files& files) {
  std::map<std::string, SharedBytes> entries;
  for (const auto& [name, content] : files) entries[name] = bytesOf(content);
  return std::make_shared<const Bytes>(writeZip(entries));
}

ReadResult readXml(const std::string& body, Files files = {}, const std::string& attributes = "") {
  files["Home.xml"] = "<?xml version='1.0'?><home version='6500' " + attributes + ">" + body + "</home>";
  return readSh3d(archiveOf(files), "test.sh3d", Progress{});
}

template <class Elements>
const auto& only(const Elements& elements) {
  EXPECT_EQ(elements.size(), 1u);
  return *elements.begin()->second;
}

bool mentions(const ImportReport& report, const std::string& words) {
  for (const auto& entry : report.entries)
    if ((entry.place + ": " + entry.what).find(words) != std::string::npos) return true;
  return false;
}

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n";

TEST(Sh3d, WallsTurnTheirPlanUpAndKeepTheirHands) {
  const ReadResult read = readXml(
      "<wall id='a' xStart='0' yStart='100' xEnd='300' yEnd='100' thickness='20' height='200' "
      "heightAtEnd='150' "
      "arcExtent='0.5' leftSideColor='FFFF0000' rightSideColor='FF00FF00' topColor='FF0000FF' wallAtEnd='b'>"
      "<baseboard attribute='leftSideBaseboard' thickness='1' height='7' color='FF808080'/></wall>"
      "<wall id='b' xStart='300' yStart='100' xEnd='300' yEnd='400' thickness='10' wallAtStart='a' "
      "wallAtEnd='b'/>",
      {}, "wallHeight='260'");
  EXPECT_TRUE(read.report.empty());
  ASSERT_EQ(read.home.walls.size(), 2u);
  const auto& [firstId, first] = *read.home.walls.begin();
  EXPECT_NEAR(first->end.x, 3, kExact);
  EXPECT_NEAR(first->end.y, -1, kExact);
  EXPECT_NEAR(first->thickness, 0.2, kExact);
  EXPECT_NEAR(first->heightAtEnd, 1.5, kExact);
  EXPECT_NEAR(first->arcExtent, -0.5, kExact) << "clockwise on the file's plan is to the right";
  EXPECT_EQ(first->left.finish.color, (Color{1, 0, 0}));
  EXPECT_EQ(first->right.finish.color, (Color{0, 1, 0}));
  EXPECT_EQ(first->top.color, (Color{0, 0, 1}));
  ASSERT_TRUE(first->left.baseboard);
  EXPECT_NEAR(first->left.baseboard->height, 0.07, kExact);
  EXPECT_FALSE(first->right.baseboard);
  const auto& [secondId, second] = *++read.home.walls.begin();
  EXPECT_NEAR(second->heightAtStart, 2.6, kExact) << "the home's height where the wall has none";
  EXPECT_EQ(first->neighbourAtEnd, secondId);
  EXPECT_EQ(second->neighbourAtStart, firstId);
  EXPECT_FALSE(second->neighbourAtEnd) << "not joined to itself";
}

TEST(Sh3d, LevelsRoomsAndWhatIsOnThem) {
  const ReadResult read = readXml(
      "<level id='l0' name='Ground' elevation='0' floorThickness='12' height='250' elevationIndex='0'/>"
      "<level id='l1' name='Upper' elevation='262' floorThickness='12' height='240' visible='false' "
      "viewable='false'/>"
      "<room level='l1' name='Bath' areaVisible='true' ceilingVisible='false' floorColor='FF102030' "
      "nameAngle='0.5'>"
      "<textStyle attribute='nameStyle' fontSize='22' bold='true'/>"
      "<point x='0' y='0'/><point x='100' y='0'/><point x='100' y='200'/></room>"
      "<room level='nowhere'><point x='0' y='0'/><point x='1' y='0'/><point x='1' y='1'/></room>"
      "<room><point x='0' y='0'/><point x='nan' y='0'/><point x='1' y='1'/></room>");
  ASSERT_EQ(read.home.levels.size(), 2u);
  const auto upper = *++read.home.levels.begin();
  EXPECT_NEAR(upper.second->elevation, 2.62, kExact);
  EXPECT_TRUE(upper.second->visible) << "hidden only while the level below was edited";
  EXPECT_FALSE(upper.second->viewable);
  ASSERT_EQ(read.home.rooms.size(), 2u) << "the one with two good points is dropped";
  const Room& bath = *read.home.rooms.begin()->second;
  EXPECT_EQ(bath.level, upper.first);
  EXPECT_NEAR(bath.points[2].y, -2, kExact);
  EXPECT_TRUE(bath.floorVisible);
  EXPECT_FALSE(bath.ceilingVisible);
  EXPECT_TRUE(bath.nameStyle.bold);
  EXPECT_NEAR(bath.nameStyle.size, 0.22, kExact);
  EXPECT_NEAR(bath.nameAngle, -0.5, kExact);
  EXPECT_NEAR(bath.nameOffset.y, 0.4, kExact) << "where Sweet Home 3D writes a name by default";
  EXPECT_TRUE(mentions(read.report, "level does not exist"));
  EXPECT_TRUE(mentions(read.report, "fewer than three points"));
  EXPECT_TRUE(mentions(read.report, "not a usable number"));
}

TEST(Sh3d, FurnitureWithItsModelColoursAndAngles) {
  const ReadResult read = readXml(
      "<pieceOfFurniture id='p' name='Chair' catalogId='x#chair' model='3' x='100' y='200' elevation='10' "
      "angle='0.25' "
      "width='40' depth='50' height='90' color='FF804020' shininess='0.5' modelMirrored='true' "
      "visible='false' "
      "modelRotation='0 0 -1 0 1 0 1 0 0' dropOnTopElevation='0.5' creator='eTeks' price='12.5' "
      "movable='false' "
      "backFaceShown='true' description='d'><property name='k' value='v'/>"
      "<material name='legs' color='FF000000' shininess='0'/><material name='gone' "
      "color='00000000'/></pieceOfFurniture>",
      {{"3", kObj}});
  EXPECT_TRUE(read.report.empty());
  const Furniture& chair = only(read.home.furniture);
  EXPECT_NEAR(chair.position.x, 1, kExact);
  EXPECT_NEAR(chair.position.y, -2, kExact);
  EXPECT_NEAR(chair.position.z, 0.1, kExact);
  EXPECT_NEAR(chair.angle, -0.25, kExact);
  EXPECT_NEAR(chair.size.y, 0.5, kExact);
  EXPECT_TRUE(chair.mirrored);
  EXPECT_FALSE(chair.visible);
  EXPECT_TRUE(chair.model.backFacesShown);
  EXPECT_EQ(chair.model.catalogId, "x#chair");
  EXPECT_EQ(chair.model.asset, "models/3/model.obj");
  EXPECT_EQ(asText(*read.home.assets->at("models/3/model.obj")), kObj);
  EXPECT_EQ(chair.model.rotation[0], (Vec3{0, -1, 0}));
  EXPECT_NEAR(chair.dropOnTopHeight.value(), 0.45, kExact);
  EXPECT_EQ(chair.finish.color, (Color{0x80 / 255.f, 0x40 / 255.f, 0x20 / 255.f}));
  ASSERT_TRUE(chair.finish.roughness);
  EXPECT_LT(*chair.finish.roughness, 0.6);
  EXPECT_GT(chair.slotFinishes.at("legs").roughness.value(), 0.85) << "no shine is matt";
  EXPECT_EQ(chair.slotFinishes.at("gone").material, "invisible");
  EXPECT_EQ(chair.properties.at("creator"), "eTeks");
  EXPECT_EQ(chair.properties.at("k"), "v");
  EXPECT_NEAR(chair.price.value(), 12.5, kExact);
}

// Where a point of the piece's box ends up by Sweet Home 3D's rules, in our axes: its own axes are x right, y
// up, z front; pitch about x, then roll about z, then the angle about y, each negative.
Vec3 bySweetHome3D(Vec3 p, double pitch, double roll, double angle) {
  Vec3 q{p.x, p.z, -p.y};
  q = {q.x, q.y * std::cos(pitch) + q.z * std::sin(pitch), -q.y * std::sin(pitch) + q.z * std::cos(pitch)};
  q = {q.x * std::cos(roll) + q.y * std::sin(roll), -q.x * std::sin(roll) + q.y * std::cos(roll), q.z};
  q = {q.x * std::cos(angle) - q.z * std::sin(angle), q.y, q.x * std::sin(angle) + q.z * std::cos(angle)};
  return {q.x, -q.z, q.y};
}

TEST(Sh3d, TiltedPiecesStandAsSweetHome3dPutsThem) {
  for (const Vec3 angles : {Vec3{0.4, 0, 0}, Vec3{0, 0.7, 0}, Vec3{0.4, 0.7, 1.1}, Vec3{-1.2, 2.5, -2}}) {
    const auto attribute = [](const char* name, double value) {
      return std::string(name) + "='" + std::to_string(value) + "' ";
    };
    const ReadResult read = readXml(
        "<pieceOfFurniture name='p' model='1' x='0' y='0' elevation='50' width='100' depth='60' "
        "height='40' " +
            attribute("pitch", angles.x) + attribute("roll", angles.y) + attribute("angle", angles.z) + "/>",
        {{"1", kObj}});
    const Furniture& piece = only(read.home.furniture);
    const Transform ours = placement(piece);
    double lowest = 1e9;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p{corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.3 : -0.3, corner & 4 ? 0.2 : -0.2};
      const Vec3 theirs = bySweetHome3D(p, angles.x, angles.y, angles.z);
      const Vec3 here = ours.point(p + Vec3{0, 0, 0.2}) - Vec3{0, 0, piece.position.z + 0.2};
      EXPECT_NEAR(here.x, theirs.x, 1e-5);
      EXPECT_NEAR(here.y, theirs.y, 1e-5);
      EXPECT_NEAR(here.z, theirs.z, 1e-5);
      lowest = std::min(lowest, ours.point(p + Vec3{0, 0, 0.2}).z);
    }
    EXPECT_NEAR(lowest, 0.5, 1e-5) << "the elevation is that of the lowest point";
  }
}

TEST(Sh3d, GroupsNestAndGiveTheirLevel) {
  const std::string piece =
      "<pieceOfFurniture name='p' model='1' x='0' y='0' width='10' depth='10' height='10'/>";
  const ReadResult read = readXml(
      "<level id='l' name='L' elevation='0' floorThickness='1' height='250'/>"
      "<furnitureGroup name='outer' level='l' visible='false'>" +
          piece + "<furnitureGroup name='inner'>" + piece + "</furnitureGroup></furnitureGroup>" + piece,
      {{"1", kObj}});
  EXPECT_EQ(read.home.groups.size(), 2u);
  ASSERT_EQ(read.home.furniture.size(), 3u);
  const LevelId level = read.home.levels.begin()->first;
  std::size_t inGroups = 0;
  for (const auto& [id, p] : read.home.furniture) {
    inGroups += p->group ? 1 : 0;
    EXPECT_EQ(p->level, p->group ? level : LevelId{});
  }
  EXPECT_EQ(inGroups, 2u);
  const auto inner = *++read.home.groups.begin();
  EXPECT_EQ(inner.second->parent, read.home.groups.begin()->first);
  EXPECT_EQ(read.home.assets->size(), 1u) << "one model, thrice";
}

TEST(Sh3d, DoorsFindTheirWallAndKeepTheirSwing) {
  const ReadResult read = readXml(
      "<doorOrWindow name='Door' model='1' x='150' y='100' width='90' depth='30' height='208' "
      "cutOutShape='M0,0 v1 h1 v-0.5 z' "
      "wallThickness='0.5' wallDistance='0.25' wallCutOutOnBothSides='true'>"
      "<sash xAxis='0.05' yAxis='0.7' width='0.9' startAngle='0.0' endAngle='-1.5'/></doorOrWindow>"
      "<doorOrWindow name='Free' model='1' x='900' y='900' width='90' depth='30' height='208'/>"
      "<doorOrWindow name='Window' model='1' x='300' y='250' angle='1.5707963' elevation='100' width='90' "
      "depth='10' height='120' boundToWall='false'/>"
      "<wall id='a' xStart='0' yStart='100' xEnd='300' yEnd='100' thickness='20'/>"
      "<wall id='b' xStart='300' yStart='100' xEnd='300' yEnd='400' thickness='20'/>",
      {{"1", kObj}});
  EXPECT_TRUE(read.report.empty());
  ASSERT_EQ(read.home.openings.size(), 3u);
  std::map<std::string, Opening> openings;
  for (const auto& [id, opening] : read.home.openings) openings[opening->name] = *opening;
  const WallId a = read.home.walls.begin()->first, b = (++read.home.walls.begin())->first;
  EXPECT_EQ(openings["Door"].wall, a);
  EXPECT_EQ(openings["Door"].kind, OpeningKind::Door);
  EXPECT_EQ(openings["Door"].cutOut, "M0,0 v1 h1 v-0.5 z");
  EXPECT_TRUE(openings["Door"].cutsBothSides);
  EXPECT_NEAR(openings["Door"].sashes.at(0).endAngle, -1.5, kExact) << "sash angles turn as ours do";
  EXPECT_FALSE(openings["Free"].wall);
  EXPECT_FALSE(openings["Free"].cutsWalls);
  EXPECT_EQ(openings["Window"].wall, b) << "even where it is not bound to it";
  EXPECT_EQ(openings["Window"].kind, OpeningKind::Window);
  EXPECT_FALSE(openings["Window"].cutOut.empty());
}

TEST(Sh3d, AnOpeningMayCutAPartOfItsOutlineOnly) {
  const ReadResult read = readXml(
      "<wall id='a' xStart='0' yStart='100' xEnd='300' yEnd='100' thickness='20'/>"
      "<doorOrWindow name='Shop' model='1' x='150' y='100' width='200' depth='20' height='200' "
      "cutOutShape='M0,0 v1 h1 v-1 z' wallWidth='0.5' wallLeft='0.25' wallHeight='0.8' wallTop='0.1'/>",
      {{"1", kObj}});
  EXPECT_TRUE(read.report.empty());
  const auto rings = parseSvgPath(read.home.openings.begin()->second->cutOut);
  ASSERT_EQ(rings.size(), 1u);
  const Box2 box = bounds(rings[0]);
  EXPECT_NEAR(box.min.x, 0.25, 1e-6);
  EXPECT_NEAR(box.max.x, 0.75, 1e-6);
  EXPECT_NEAR(box.min.y, 0.1, 1e-6);
  EXPECT_NEAR(box.max.y, 0.9, 1e-6);
  EXPECT_NEAR(area(Regions{{rings[0], {}}}), 0.4, 1e-6);
}

TEST(Sh3d, LampsKeepTheirBulbs) {
  const ReadResult read = readXml(
      "<light name='Lamp' model='1' x='0' y='0' width='60' depth='30' height='50' power='0.5'>"
      "<lightSource x='0.5' y='0.1' z='0.8' color='00998764' diameter='0.1'/></light>",
      {{"1", kObj}});
  const Furniture& lamp = only(read.home.furniture);
  ASSERT_TRUE(lamp.lamp);
  EXPECT_NEAR(lamp.lamp->lumens, 800, 20);
  ASSERT_EQ(lamp.lamp->sources.size(), 1u);
  EXPECT_NEAR(lamp.lamp->sources[0].position.y, 0.1, kExact) << "near the front";
  EXPECT_NEAR(lamp.lamp->sources[0].diameter, 0.06, kExact);
}

TEST(Sh3d, CamerasLookTheSameWay) {
  const ReadResult read = readXml(
      "<compass x='0' y='0' diameter='100' northDirection='0.3' longitude='0.1' latitude='0.8' "
      "timeZone='Europe/Paris'/>"
      "<observerCamera attribute='observerCamera' lens='PINHOLE' x='1' y='2' z='170' yaw='0' pitch='0.1' "
      "fieldOfView='1' time='1750507200000'/>"
      "<camera attribute='topCamera' lens='PINHOLE' x='1' y='2' z='1000' yaw='0' pitch='1' fieldOfView='1'/>"
      "<observerCamera attribute='storedCamera' name='To the right' lens='FISHEYE' x='100' y='200' z='150' "
      "yaw='4.71238898' pitch='0' fieldOfView='1.2'/>"
      "<camera attribute='cameraPath' x='1' y='2' z='3' yaw='0' pitch='0' fieldOfView='1'/>");
  const Camera& stored = only(read.home.cameras);
  EXPECT_EQ(stored.name, "To the right");
  EXPECT_EQ(stored.lens, Lens::Fisheye);
  EXPECT_NEAR(viewDirection(stored).x, 1, 1e-6);
  EXPECT_NEAR(stored.eye.y, -2, kExact);
  EXPECT_FALSE(stored.time);
  ASSERT_TRUE(read.home.observer && read.home.aerial);
  EXPECT_LT(viewDirection(*read.home.observer).y, -0.9) << "yaw 0 looks down the file's page";
  EXPECT_LT(viewDirection(*read.home.observer).z, 0) << "a positive pitch looks down";
  EXPECT_EQ(read.home.site.time, 1750507200000 - 7200000) << "noon by the clock in Paris in summer";
  EXPECT_NEAR(read.home.site.north, -0.3, kExact);
}

TEST(Sh3d, DimensionsLabelsAndPolylines) {
  const ReadResult read = readXml(
      "<dimensionLine xStart='0' yStart='0' xEnd='100' yEnd='0' offset='20'/>"
      "<label x='10' y='20' angle='0.5' color='FFFF0000'><textStyle fontSize='30'/><text>Hello &amp; "
      "more</text></label>"
      "<polyline thickness='2' endArrowStyle='OPEN' dashStyle='DASH_DOT' joinStyle='CURVED' "
      "closedPath='true' color='FF00FF00'>"
      "<point x='0' y='0'/><point x='100' y='100'/></polyline>");
  EXPECT_NEAR(only(read.home.dimensions).offset, -0.2, kExact)
      << "below a line to the right is to its right hand";
  EXPECT_EQ(only(read.home.labels).text, "Hello & more");
  EXPECT_NEAR(only(read.home.labels).style.size, 0.3, kExact);
  EXPECT_EQ(only(read.home.labels).style.color, (Color{1, 0, 0}));
  const Polyline& line = only(read.home.polylines);
  EXPECT_EQ(line.endArrow, LineArrow::Open);
  EXPECT_EQ(line.dash, LineDash::DashDot);
  EXPECT_TRUE(line.curved && line.closed);
  EXPECT_NEAR(line.points[1].y, -1, kExact);
}

TEST(Sh3d, ModelsInFoldersAndArchivesBringTheirTextures) {
  const SharedBytes inner = archiveOf({{"chair.obj", kObj}, {"wood.png", "\x89PNG"}});
  const std::string piece = " x='0' y='0' width='10' depth='10' height='10'/>";
  const ReadResult read = readXml("<pieceOfFurniture name='a' model='4/My chair.obj'" + piece +
                                      "<pieceOfFurniture name='b' model='5'" + piece +
                                      "<pieceOfFurniture name='c' model='6/My%20chair.obj'" + piece,
                                  {{"4/My chair.obj", kObj},
                                   {"4/t.png", "\x89PNG"},
                                   {"5", std::string(asText(*inner))},
                                   {"6/My chair.obj", kObj},
                                   {"7", kObj}});
  EXPECT_TRUE(read.report.empty());
  const Assets& assets = *read.home.assets;
  EXPECT_TRUE(assets.contains("models/4/My chair.obj"));
  EXPECT_TRUE(assets.contains("models/4/t.png"));
  EXPECT_TRUE(assets.contains("models/5/chair.obj"));
  EXPECT_TRUE(assets.contains("models/5/wood.png"));
  EXPECT_EQ(assets.at("models/4/My chair.obj"), assets.at("models/6/My chair.obj"))
      << "equal contents are one";
  EXPECT_EQ(assets.size(), 5u) << "what nothing refers to stays behind";
}

TEST(Sh3d, TexturesOfFacesAndTheGround) {
  const std::string texture =
      "name='t' width='50' height='25' xOffset='0.5' angle='0.5' scale='2' image='9'/>";
  const ReadResult read = readXml(
      "<environment groundColor='FF102030' skyColor='00CCE4FC' wallsAlpha='0.25'><texture "
      "attribute='groundTexture' " +
          texture +
          "</environment>"
          "<room floorColor='FF000000'><texture attribute='floorTexture' " +
          texture + "<point x='0' y='0'/><point x='1' y='0'/><point x='1' y='1'/></room>",
      {{"9", "\x89PNG...."}});
  EXPECT_TRUE(read.report.empty());
  const auto& floor = only(read.home.rooms).floor;
  ASSERT_TRUE(floor.texture);
  EXPECT_FALSE(floor.color);
  EXPECT_EQ(floor.texture->asset, "textures/9.png");
  EXPECT_NEAR(floor.texture->size.x, 1, kExact);
  EXPECT_NEAR(floor.texture->offset.x, 0.5, kExact);
  EXPECT_NEAR(floor.texture->angle, -0.5, kExact);
  EXPECT_EQ(read.home.environment.ground.texture, floor.texture);
  EXPECT_NEAR(read.home.environment.wallTransparency, 0.25, kExact);
}

TEST(Sh3d, AMissingModelIsReportedAndThePieceStays) {
  const std::string piece = " x='0' y='0' width='10' depth='10' height='10'/>";
  const ReadResult read = readXml(
      "<pieceOfFurniture name='Sofa' model='77'" + piece + "<pieceOfFurniture name='Bad' model='8'" + piece,
      {{"8", "no model at all"}});
  EXPECT_EQ(read.home.furniture.size(), 2u);
  EXPECT_TRUE(mentions(read.report, "\"Sofa\": its model (77) is missing"));
  EXPECT_TRUE(mentions(read.report, "\"Bad\": its model cannot be used"));
}

TEST(Sh3d, UnknownElementsAndBrokenOnesAreReported) {
  const ReadResult read = readXml(
      "<teapot/><teapot/><wall id='a'/><pieceOfFurniture name='p' x='1' y='1' width='nan' depth='1' "
      "height='1'/>"
      "<wall xStart='0' yStart='0' xEnd='1e30' yEnd='0' thickness='1'/><label x='0' y='0'/><polyline/>"
      "<observerCamera attribute='storedCamera' x='0'/>");
  EXPECT_TRUE(mentions(read.report, "teapot"));
  EXPECT_EQ(read.home.walls.size(), 0u);
  EXPECT_EQ(read.home.furniture.size(), 0u);
  EXPECT_EQ(read.home.cameras.size(), 0u);
  EXPECT_TRUE(mentions(read.report, "a wall without ends"));
  EXPECT_TRUE(mentions(read.report, "without a place or a size"));
}

TEST(Sh3d, GroupsNestedWithoutEndDoNotOverflow) {
  std::string body;
  for (int i = 0; i < 100'000; ++i) body += "<furnitureGroup name='g'>";
  for (int i = 0; i < 100'000; ++i) body += "</furnitureGroup>";
  const ReadResult read = readXml(body);
  EXPECT_LE(read.home.groups.size(), 100u);
  EXPECT_TRUE(mentions(read.report, "nested too deeply"));
}

TEST(Sh3d, OldSerializedHomesAreRefusedByName) {
  const SharedBytes old = archiveOf({{"Home", "\xAC\xED serialized"}, {"0", "x"}});
  EXPECT_TRUE(sniffSh3d(old, "old.sh3d"));
  try {
    readSh3d(old, "old.sh3d", Progress{});
    FAIL();
  } catch (const UnsupportedVersion& error) {
    EXPECT_NE(
        std::string(error.what()).find("saved by Sweet Home 3D before 5.3; open and save it there once"),
        std::string::npos);
  }
}

TEST(Sh3d, ForeignAndTruncatedFilesAreRefused) {
  EXPECT_FALSE(sniffSh3d(bytesOf("hello"), "a.sh3d"));
  EXPECT_FALSE(sniffSh3d(archiveOf({{"home.json", "{}"}}), "a.idap"));
  EXPECT_THROW(readSh3d(archiveOf({{"home.json", "{}"}}), "a", Progress{}), ParseError);
  EXPECT_THROW(readSh3d(archiveOf({{"Home.xml", "<home"}}), "a", Progress{}), ParseError);
  EXPECT_THROW(readSh3d(archiveOf({{"Home.xml", "<house/>"}}), "a", Progress{}), ParseError);
  EXPECT_THROW(readSh3d(archiveOf({{"Home.xml", ""}}), "a", Progress{}), ParseError);
  const SharedBytes whole = archiveOf({{"Home.xml", "<home/>"}, {"1", std::string(2000, 'x')}});
  for (std::size_t size = 0; size < whole->size(); size += 7) {
    const auto part = std::make_shared<const Bytes>(whole->begin(), whole->begin() + std::ptrdiff_t(size));
    EXPECT_FALSE(sniffSh3d(part, "part.sh3d")) << size;
    EXPECT_THROW(readSh3d(part, "part.sh3d", Progress{}), Error) << size;
  }
}

TEST(Sh3d, StopsWhenAsked) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(readSh3d(archiveOf({{"Home.xml", "<home><level id='a'/></home>"}}), "a", progress), Cancelled);
}

}  // namespace
}  // namespace idap
