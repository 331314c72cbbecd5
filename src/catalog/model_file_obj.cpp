#include "catalog/model_file_obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <unordered_map>

#include "base/error.h"
#include "catalog/model_file_material.h"
#include "catalog/text_scan.h"

namespace idap {

namespace {

constexpr std::size_t kMaxMaterialLibraries = 64;
constexpr std::size_t kMaxSlots = 65'536;

// "\" before a line end joins the next line.
std::string joinContinuedLines(std::string_view text) {
  std::string joined(text);
  for (std::size_t at = joined.find('\\'); at != std::string::npos; at = joined.find('\\', at + 1)) {
    std::size_t stop = at + 1;
    if (stop < joined.size() && joined[stop] == '\r') ++stop;
    if (stop < joined.size() && joined[stop] == '\n')
      std::fill(joined.begin() + std::ptrdiff_t(at), joined.begin() + std::ptrdiff_t(stop) + 1, ' ');
  }
  return joined;
}

SlotRole roleOf(std::string_view group) {
  if (group.starts_with("sweethome3d_window_pane")) return SlotRole::Pane;
  if (group.starts_with("sweethome3d_window_mirror")) return SlotRole::Mirror;
  return SlotRole::Plain;
}

class ObjParser {
 public:
  ObjParser(std::string_view text, const std::string& name, const SiblingFiles& siblings,
            const Progress* progress)
      : file_(text), name_(name), siblings_(siblings), progress_(progress), whole_(text.size()) {
    // A guess that spares most of the growing; a vertex and a face together take some 50 characters.
    const std::size_t guess = text.size() / 50 + 16;
    model_.positions.reserve(guess);
    model_.faces.reserve(guess);
    model_.corners.reserve(guess * 4);
  }

  PolygonModel parse() {
    while (!file_.atEnd()) {
      if (++lineNumber_ % kLinesToReport == 0) report();
      TextScan line = file_.line();
      line.skipBlanks();
      statement(line);
    }
    for (const auto& [key, slot] : slots_) {
      const auto found = materials_.find(key.first);
      const PhongMaterial phong = found != materials_.end() ? found->second : defaultPhongMaterial(key.first);
      model_.slots[slot] = {key.first, materialOf(phong, key.second, siblings_)};
    }
    return std::move(model_);
  }

 private:
  static constexpr std::size_t kLinesToReport = 8192;

  void report() const {
    if (!progress_) return;
    progress_->check();
    progress_->report(1 - double(file_.left()) / double(whole_), "");
  }

  [[noreturn]] void fail(const char* reason) const {
    throw ParseError(name_, fmt::format("line {}", lineNumber_), reason);
  }

  void statement(TextScan& line) {
    switch (line.peek()) {
      case 'v':
        line.skip();
        return vertexData(line);
      case 'f':
        line.skip();
        if (line.peek() == 'o') line.word();  // "fo", an old spelling
        return face(line);
      default:
        break;
    }
    const std::string_view key = line.word();
    if (key == "s") {
      const std::string_view group = line.rest();
      std::int64_t number = 1;
      if (group == "off")
        number = 0;
      else if (TextScan scan(group); !scan.integer(number))
        number = 1;
      smoothing_ =
          std::uint32_t(std::clamp<std::int64_t>(number, 0, std::numeric_limits<std::uint32_t>::max()));
    } else if (key == "usemtl") {
      material_ = std::string(line.rest());
      slotKnown_ = false;
    } else if (key == "g" || key == "o") {
      const SlotRole role = roleOf(line.rest());
      if (role != role_) slotKnown_ = false;
      role_ = role;
    } else if (key == "mtllib") {
      readLibraries(line);
    }
  }

  void vertexData(TextScan& line) {
    const char kind = line.peek();
    if (kind == ' ' || kind == '\t') {
      Vec3f p;
      if (!line.number(p.x) || !line.number(p.y) || !line.number(p.z)) fail("a vertex needs three numbers");
      model_.positions.push_back(p);
    } else if (kind == 't') {
      line.skip();
      Vec2f uv;
      if (!line.number(uv.x)) fail("a texture coordinate needs a number");
      if (!line.number(uv.y)) uv.y = 0;
      model_.uvs.push_back(uv);
    } else if (kind == 'n') {
      line.skip();
      Vec3f n;
      if (!line.number(n.x) || !line.number(n.y) || !line.number(n.z)) fail("a normal needs three numbers");
      model_.normals.push_back(n);
    }
  }

  // Indices count from 1; negative ones from the last read backwards.
  std::int32_t resolved(std::int64_t index, std::size_t count) const {
    const std::int64_t at = index > 0 ? index - 1 : index + std::int64_t(count);
    if (index == 0 || at < 0 || at >= std::numeric_limits<std::int32_t>::max()) return PolygonModel::kNone;
    return std::int32_t(at);
  }

  void face(TextScan& line) {
    PolygonModel::Face face;
    face.first = std::uint32_t(model_.corners.size());
    while (true) {
      line.skipBlanks();
      if (line.atEnd() || line.peek() == '#') break;
      std::int64_t index = 0;
      if (!line.integer(index)) fail("a face needs vertex numbers");
      PolygonModel::Corner corner;
      corner.position = resolved(index, model_.positions.size());
      if (line.peek() == '/') {
        line.skip();
        if (line.integer(index)) corner.uv = resolved(index, model_.uvs.size());
        if (line.peek() == '/') {
          line.skip();
          if (line.integer(index)) corner.normal = resolved(index, model_.normals.size());
        }
      }
      model_.corners.push_back(corner);
      if (const char after = line.peek(); after && after != ' ' && after != '\t')
        fail("a face needs vertex numbers");
    }
    face.count = std::uint32_t(model_.corners.size()) - face.first;
    face.slot = slot();
    face.smoothing = smoothing_;
    model_.faces.push_back(face);
  }

  std::uint32_t slot() {
    if (slotKnown_) return slot_;
    const auto [found, added] = slots_.try_emplace({material_, role_}, std::uint32_t(model_.slots.size()));
    if (added) {
      if (model_.slots.size() >= kMaxSlots) fail("too many materials");
      model_.slots.emplace_back();
    }
    slot_ = found->second;
    slotKnown_ = true;
    return slot_;
  }

  // The statement may name several files, or one with blanks in its name.
  void readLibraries(TextScan& line) {
    const std::string whole(line.rest());
    if (readLibrary(whole)) return;
    while (true) {
      const std::string_view one = line.word();
      if (one.empty()) return;
      readLibrary(std::string(one));
    }
  }

  bool readLibrary(std::string file) {
    if (!siblings_ || ++libraries_ > kMaxMaterialLibraries) return false;
    std::replace(file.begin(), file.end(), '\\', '/');
    const SharedBytes bytes = siblings_(file);
    if (!bytes) return false;
    for (PhongMaterial& m : parseMtl(asText(*bytes))) {
      std::string key = m.name;
      materials_.insert_or_assign(std::move(key), std::move(m));
    }
    return true;
  }

  TextScan file_;
  const std::string& name_;
  const SiblingFiles& siblings_;
  const Progress* progress_;
  std::size_t whole_;
  std::size_t lineNumber_ = 0, libraries_ = 0;
  PolygonModel model_;
  std::unordered_map<std::string, PhongMaterial> materials_;
  std::map<std::pair<std::string, SlotRole>, std::uint32_t> slots_;
  std::string material_ = "default";
  SlotRole role_ = SlotRole::Plain;
  std::uint32_t slot_ = 0, smoothing_ = 0;
  bool slotKnown_ = false;
};

}  // namespace

bool looksLikeObj(std::string_view text) {
  TextScan file(text.substr(0, 65'536));
  while (!file.atEnd()) {
    TextScan line = file.line();
    const std::string_view key = line.word();
    if (key.empty() || key.front() == '#') continue;
    if (key == "mtllib" || key == "usemtl" || key == "g" || key == "o" || key == "s") continue;
    if (key != "v" && key != "vt" && key != "vn") return false;
    float number;
    return line.number(number);
  }
  return false;
}

PolygonModel parseObj(std::string_view text, const std::string& name, const SiblingFiles& siblings,
                      const Progress* progress) {
  if (text.find('\\') != std::string_view::npos) {
    const std::string joined = joinContinuedLines(text);
    return ObjParser(joined, name, siblings, progress).parse();
  }
  return ObjParser(text, name, siblings, progress).parse();
}

}  // namespace idap
