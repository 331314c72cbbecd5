#include "formats/sh3d/sh3d_contents.h"

#include <algorithm>
#include <functional>

#include "base/error.h"
#include "catalog/model_file.h"

namespace idap {

namespace {

// An archive inside the archive: one model with its textures, not a whole library.
constexpr ZipLimits kInnerLimits{
    .maxEntries = 2000, .maxEntryBytes = std::size_t{256} << 20, .maxTotalBytes = std::size_t{512} << 20};
constexpr std::size_t kMaxAssetBytes = std::size_t{2} << 30;

// "%20" and its like, which older versions put into names.
std::string percentDecoded(const std::string& text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto digit = [&](std::size_t at) -> int {
      const char c = at < text.size() ? text[at] : 'x';
      return c >= '0' && c <= '9'   ? c - '0'
             : c >= 'A' && c <= 'F' ? c - 'A' + 10
             : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                    : -1;
    };
    if (text[i] == '%' && digit(i + 1) >= 0 && digit(i + 2) >= 0) {
      decoded += char(digit(i + 1) * 16 + digit(i + 2));
      i += 2;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

std::string assetPath(const std::string& entry) { return std::string("models/").append(entry); }

std::string_view pictureExtension(const Bytes& bytes) {
  const std::string_view head = asText(bytes).substr(0, 16);
  if (head.starts_with("\x89PNG")) return "png";
  if (head.starts_with("\xFF\xD8")) return "jpg";
  if (head.starts_with("GIF8")) return "gif";
  if (head.starts_with("BM")) return "bmp";
  if (head.starts_with("RIFF")) return "webp";
  if (head.starts_with(std::string_view("II*\0", 4)) || head.starts_with(std::string_view("MM\0*", 4)))
    return "tif";
  return {};
}

}  // namespace

SharedBytes Sh3dContents::read(const std::string& entry) {
  auto bytes = std::make_shared<const Bytes>(archive_.read(entry));
  const std::size_t hash = std::hash<std::string_view>()(asText(*bytes));
  const auto [begin, end] = bytes_.equal_range(hash);
  for (auto known = begin; known != end; ++known)
    if (*known->second == *bytes) return known->second;
  bytes_.emplace(hash, bytes);
  return bytes;
}

std::string Sh3dContents::entryOf(const std::string& content) const {
  if (archive_.contains(content)) return content;
  const std::string decoded = percentDecoded(content);
  return archive_.contains(decoded) ? decoded : std::string();
}

template <class Add>
std::string Sh3dContents::remembered(std::map<std::string, std::string>& known, const std::string& content,
                                     const char* missing, const std::string& place, ImportReport& report,
                                     const Add& add) {
  const auto [found, isNew] = known.try_emplace(content);
  if (isNew) {
    try {
      found->second = add();
      if (found->second.empty()) report.add(place, std::string(missing) + " (" + content + ") is missing");
    } catch (const ParseError& error) {
      report.add(place, std::string(missing) + " cannot be used: " + error.what());
    }
  }
  return found->second;
}

std::string Sh3dContents::model(const std::string& content, const std::string& place, ImportReport& report) {
  return remembered(models_, content, "its model", place, report, [&] { return addModel(content); });
}

std::string Sh3dContents::picture(const std::string& content, const std::string& place,
                                  ImportReport& report) {
  return remembered(pictures_, content, "its picture", place, report, [&] { return addPicture(content); });
}

std::string Sh3dContents::addModel(const std::string& content) {
  const std::string entry = entryOf(content);
  if (entry.empty()) return {};
  const std::size_t slash = entry.find('/');
  if (slash == std::string::npos) {
    SharedBytes bytes = read(entry);
    if (const auto known = pathOf_.find(bytes.get()); known != pathOf_.end()) return known->second;
    const std::string folder = assetPath(entry) + '/';
    std::string path;
    if (looksLikeZip(*bytes)) {
      path = addArchivedModel(folder, bytes);
    } else {
      const std::string kind = modelFileKind(*bytes, entry);
      if (kind.empty()) throw ParseError(entry, "", "not a model of a known kind");
      path = folder + "model." + kind;
      assets_[path] = bytes;
    }
    pathOf_[bytes.get()] = path;
    return path;
  }
  // Everything in the model's folder comes along: its materials and textures.
  const std::string folder = entry.substr(0, slash + 1);
  for (const std::string& other : archive_.entries())
    if (other.starts_with(folder) && !assets_.contains(assetPath(other)))
      assets_[assetPath(other)] = read(other);
  return assetPath(entry);
}

std::string Sh3dContents::addArchivedModel(const std::string& folder, SharedBytes bytes) {
  const ZipReader inner(std::move(bytes), folder, kInnerLimits);
  const std::string model = modelInArchive(inner.entries());
  if (model.empty()) throw ParseError(folder, "", "the archive holds no model");
  std::size_t total = 0;
  for (const std::string& entry : inner.entries()) {
    auto unpacked = std::make_shared<const Bytes>(inner.read(entry));
    total += unpacked->size();
    if (total > kMaxAssetBytes) throw ParseError(folder, entry, "the archive unpacks to too much");
    assets_[folder + entry] = std::move(unpacked);
  }
  return folder + model;
}

std::string Sh3dContents::addPicture(const std::string& content) {
  const std::string entry = entryOf(content);
  if (entry.empty()) return {};
  SharedBytes bytes = read(entry);
  if (const auto known = pathOf_.find(bytes.get()); known != pathOf_.end()) return known->second;
  const std::string_view extension = pictureExtension(*bytes);
  if (extension.empty()) throw ParseError(entry, "", "not a picture of a known kind");
  std::string path = "textures/" + entry;
  if (entry.find('.') == std::string::npos) path.append(1, '.').append(extension);
  assets_[path] = bytes;
  return pathOf_[bytes.get()] = path;
}

}  // namespace idap
