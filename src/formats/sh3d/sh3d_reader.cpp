#include "formats/sh3d/sh3d_reader.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "base/error.h"
#include "base/zip.h"
#include "formats/sh3d/sh3d_context.h"

namespace idap {

namespace {

constexpr const char* kHomeXml = "Home.xml";
constexpr const char* kSerializedHome = "Home";
constexpr std::size_t kMaxXmlBytes = std::size_t{512} << 20;

// What is read elsewhere, and what says nothing about the home itself.
const std::set<std::string_view> kOtherElements = {"property", "furnitureVisibleProperty", "print"};

// Settings of Sweet Home 3D's windows are no business of the home's.
bool isWindowSetting(std::string_view property) { return property.starts_with("com.eteks.sweethome3d."); }

std::string homeName(std::string name, const std::string& fileName) {
  if (name.empty()) name = fileName;
  return std::filesystem::path(name).stem().string();
}

void readHomeElement(Sh3dContext& context, const Sh3dElement& root, const std::string& fileName) {
  Home& home = context.home;
  home.name = homeName(root.text("name"), fileName);
  if (const auto height = root.length("wallHeight"); height && *height > 0) home.wallHeight = *height;
  context.basePlanLocked = root.flag("basePlanLocked", false);
  for (const pugi::xml_node node : root.node().children("property")) {
    const std::string name = node.attribute("name").as_string();
    if (!name.empty() && !isWindowSetting(name)) home.properties[name] = node.attribute("value").as_string();
  }
}

// The elements in the order in which they need each other, whatever their order in the file.
void readElements(Sh3dContext& context, const pugi::xml_node& root) {
  const auto each = [&](auto&& wanted, auto&& read) {
    for (const pugi::xml_node node : root.children())
      if (node.type() == pugi::node_element && wanted(std::string_view(node.name()))) {
        context.progress.check();
        read(Sh3dElement(node, context.report));
      }
  };
  const auto all = [&](std::string_view kind, void (*read)(Sh3dContext&, const Sh3dElement&)) {
    each([&](std::string_view name) { return name == kind; },
         [&](const Sh3dElement& element) { read(context, element); });
  };
  all("compass", readCompass);  // its time zone is that of the cameras' times
  all("environment", readEnvironment);
  all("backgroundImage", [](Sh3dContext& c, const Sh3dElement& e) { readBackground(c, e, LevelId{}); });
  each([](std::string_view name) { return name == "camera" || name == "observerCamera"; },
       [&](const Sh3dElement& element) { readCamera(context, element); });
  all("level", readLevel);
  context.progress.report(0.2, "walls");
  Sh3dWalls walls;
  each([](std::string_view name) { return name == "wall"; },
       [&](const Sh3dElement& element) { walls.read(context, element); });
  walls.join(context);
  all("room", readRoom);
  context.progress.report(0.3, "furniture");
  each(isSh3dFurniture, [&](const Sh3dElement& element) { readFurniture(context, element); });
  all("polyline", readPolyline);
  all("dimensionLine", readDimension);
  all("label", readLabel);
}

void reportUnknown(Sh3dContext& context, const pugi::xml_node& root) {
  static const std::set<std::string_view> known = {
      "compass", "environment",  "backgroundImage", "camera",        "observerCamera", "level",
      "wall",    "room",         "polyline",        "dimensionLine", "label",          "pieceOfFurniture",
      "light",   "doorOrWindow", "furnitureGroup"};
  std::map<std::string, std::size_t> unknown;
  for (const pugi::xml_node node : root.children())
    if (node.type() == pugi::node_element && !known.contains(node.name()) &&
        !kOtherElements.contains(node.name()))
      ++unknown[node.name()];
  for (const auto& [name, count] : unknown)
    context.report.entries.push_back({"element " + name, "not known to this program: dropped", count});
}

}  // namespace

bool sniffSh3d(const SharedBytes& bytes, const std::string& fileName) {
  if (!bytes || !looksLikeZip(*bytes)) return false;
  try {
    const ZipReader archive(bytes, fileName);
    return archive.contains(kHomeXml) || archive.contains(kSerializedHome);
  } catch (const Error&) {
    return false;
  }
}

ReadResult readSh3d(const SharedBytes& bytes, const std::string& fileName, const Progress& progress) {
  if (!bytes) throw ParseError(fileName, "", "nothing to read");
  progress.report(0, "archive");
  const ZipReader archive(bytes, fileName);
  if (!archive.contains(kHomeXml)) {
    if (archive.contains(kSerializedHome))
      throw UnsupportedVersion(fileName + ": saved by Sweet Home 3D before 5.3; open and save it there once");
    throw ParseError(fileName, "", "the archive holds no home (Home.xml is missing)");
  }
  const Bytes xml = archive.read(kHomeXml);
  if (xml.size() > kMaxXmlBytes) throw ParseError(fileName, kHomeXml, "too large");
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(xml.data(), xml.size());
  if (!parsed)
    throw ParseError(fileName, fmt::format("{}, byte {}", kHomeXml, parsed.offset), parsed.description());
  const pugi::xml_node root = document.child("home");
  if (!root) throw ParseError(fileName, kHomeXml, "no home in it");

  Sh3dContext context(archive, progress);
  readHomeElement(context, Sh3dElement(root, context.report), fileName);
  readElements(context, root);
  reportUnknown(context, root);
  context.home.assets = std::make_shared<const Assets>(context.contents.takeAssets());
  progress.report(1, "done");
  return {std::move(context.home), std::move(context.report)};
}

}  // namespace idap
