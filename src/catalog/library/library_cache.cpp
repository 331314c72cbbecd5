#include "catalog/library/library_cache.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <type_traits>

#include "base/error.h"
#include "base/file.h"

namespace idap {

namespace {

// Raised whenever what visit() walks over changes.
constexpr std::uint32_t kVersion = 2;
constexpr std::string_view kMagic = "IDAPlib";

class Writer {
 public:
  void raw(const void* data, std::size_t size) {
    const auto* begin = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), begin, begin + size);
  }
  std::uint32_t count(std::size_t n) {
    const auto value = static_cast<std::uint32_t>(n);
    raw(&value, sizeof value);
    return value;
  }
  static constexpr bool kReads = false;
  Bytes take() { return std::move(bytes_); }

 private:
  Bytes bytes_;
};

struct Damaged {};

class Reader {
 public:
  explicit Reader(const Bytes& bytes) : bytes_(bytes) {}
  void raw(void* data, std::size_t size) {
    if (size > bytes_.size() - at_) throw Damaged{};
    if (size > 0) std::memcpy(data, bytes_.data() + at_, size);
    at_ += size;
  }
  std::uint32_t count(std::size_t) {
    std::uint32_t value = 0;
    raw(&value, sizeof value);
    if (value > bytes_.size() - at_) throw Damaged{};  // every element takes a byte at least
    return value;
  }
  static constexpr bool kReads = true;

 private:
  const Bytes& bytes_;
  std::size_t at_ = 0;
};

// One walk serves both ways, so that what is written is what is read.
template <class Archive, class T>
requires std::is_arithmetic_v<T> || std::is_enum_v<T>
void visit(Archive& a, T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    std::uint8_t byte = value ? 1 : 0;
    a.raw(&byte, 1);
    if constexpr (Archive::kReads) value = byte != 0;
  } else {
    a.raw(&value, sizeof value);
  }
}
template <class Archive>
void visit(Archive& a, std::string& text) {
  const std::uint32_t size = a.count(text.size());
  if constexpr (Archive::kReads) text.resize(size);
  a.raw(text.data(), size);
}
template <class Archive>
void visit(Archive& a, Vec3& v) {
  visit(a, v.x), visit(a, v.y), visit(a, v.z);
}
template <class Archive>
void visit(Archive& a, Color& c) {
  visit(a, c.r), visit(a, c.g), visit(a, c.b);
}
template <class Archive, class T>
void visit(Archive& a, std::optional<T>& value);
template <class Archive, class T>
void visit(Archive& a, std::vector<T>& values);
template <class Archive, class Key, class T>
void visit(Archive& a, std::map<Key, T>& values);

template <class Archive>
void visit(Archive& a, Sash& s) {
  visit(a, s.axis.x), visit(a, s.axis.y), visit(a, s.width), visit(a, s.startAngle), visit(a, s.endAngle);
}
template <class Archive>
void visit(Archive& a, LightSource& s) {
  visit(a, s.position), visit(a, s.diameter), visit(a, s.color), visit(a, s.share);
}
template <class Archive>
void visit(Archive& a, Lamp& l) {
  visit(a, l.lumens), visit(a, l.colorTemperature), visit(a, l.color), visit(a, l.beamAngle), visit(a, l.on);
  visit(a, l.dimmer), visit(a, l.sources);
}
template <class Archive>
void visit(Archive& a, CatalogPiece& p) {
  visit(a, p.id), visit(a, p.name), visit(a, p.category), visit(a, p.tags), visit(a, p.kind),
      visit(a, p.size), visit(a, p.minSize), visit(a, p.maxSize);
  visit(a, p.elevation), visit(a, p.ceilingMounted), visit(a, p.price), visit(a, p.creator),
      visit(a, p.license);
  visit(a, p.library), visit(a, p.translations), visit(a, p.lamp), visit(a, p.staircaseCutOut);
  visit(a, p.dropOnTopHeight), visit(a, p.cutOut), visit(a, p.wallThickness), visit(a, p.wallDistance);
  visit(a, p.cutsBothSides), visit(a, p.sashes);
  for (Vec3& axis : p.modelRotation) visit(a, axis);
}
template <class Archive>
void visit(Archive& a, LibraryIndex::Entry& e) {
  visit(a, e.piece), visit(a, e.model), visit(a, e.icon);
}
template <class Archive>
void visit(Archive& a, LibraryIndex& i) {
  visit(a, i.id), visit(a, i.name), visit(a, i.description), visit(a, i.version), visit(a, i.license);
  visit(a, i.provider), visit(a, i.entries);
}
template <class Archive>
void visit(Archive& a, LibraryStamp& s) {
  visit(a, s.path), visit(a, s.size), visit(a, s.time);
}

template <class Archive, class T>
void visit(Archive& a, std::optional<T>& value) {
  bool present = value.has_value();
  visit(a, present);
  if (!present) return;
  if constexpr (Archive::kReads) value.emplace();
  visit(a, *value);
}
template <class Archive, class T>
void visit(Archive& a, std::vector<T>& values) {
  const std::uint32_t size = a.count(values.size());
  if constexpr (Archive::kReads) {
    for (std::uint32_t i = 0; i < size; ++i) visit(a, values.emplace_back());
  } else {
    for (T& value : values) visit(a, value);
  }
}
template <class Archive, class Key, class T>
void visit(Archive& a, std::map<Key, T>& values) {
  const std::uint32_t size = a.count(values.size());
  if constexpr (Archive::kReads) {
    for (std::uint32_t i = 0; i < size; ++i) {
      Key key;
      visit(a, key);
      visit(a, values.emplace_hint(values.end(), std::move(key), T{})->second);
    }
  } else {
    for (auto& [key, value] : values) {
      Key copy = key;
      visit(a, copy);
      visit(a, value);
    }
  }
}

// FNV-1a: of the path, for the name; of the content, against damage.
std::uint64_t hashOf(std::string_view text) {
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
  return hash;
}

std::filesystem::path fileFor(const std::filesystem::path& folder, const LibraryStamp& stamp) {
  return folder / fmt::format("{:016x}.library", hashOf(stamp.path));
}

struct Head {
  char magic[8] = {};
  std::uint32_t version = 0;
  std::uint32_t byteOrder = 0;
  std::uint64_t check = 0;  // of what follows
};
constexpr std::uint32_t kByteOrder = 0x01020304;

}  // namespace

LibraryStamp stampOf(const std::filesystem::path& library) {
  std::error_code failed;
  LibraryStamp stamp;
  stamp.path = std::filesystem::absolute(library, failed).lexically_normal().string();
  if (!failed) stamp.size = std::filesystem::file_size(library, failed);
  if (!failed)
    stamp.time = static_cast<std::int64_t>(
        std::filesystem::last_write_time(library, failed).time_since_epoch().count());
  if (failed) throw IoError(library.string() + ": " + failed.message());
  return stamp;
}

std::optional<LibraryIndex> loadLibraryIndex(const std::filesystem::path& folder, const LibraryStamp& stamp) {
  try {
    const std::filesystem::path file = fileFor(folder, stamp);
    if (std::error_code failed; !std::filesystem::exists(file, failed)) return std::nullopt;
    const Bytes bytes = readFile(file, std::size_t{256} << 20);
    Reader reader(bytes);
    Head head;
    reader.raw(&head, sizeof head);
    if (std::memcmp(head.magic, kMagic.data(), kMagic.size()) != 0 || head.version != kVersion ||
        head.byteOrder != kByteOrder || head.check != hashOf(asText(bytes).substr(sizeof head)))
      return std::nullopt;
    LibraryStamp stored;
    visit(reader, stored);
    if (!(stored == stamp)) return std::nullopt;
    LibraryIndex index;
    visit(reader, index);
    return index;
  } catch (const Damaged&) {
    return std::nullopt;
  } catch (const IoError&) {
    return std::nullopt;
  }
}

void storeLibraryIndex(const std::filesystem::path& folder, const LibraryStamp& stamp,
                       const LibraryIndex& index) {
  Writer body;
  LibraryStamp stampCopy = stamp;
  LibraryIndex copy = index;
  visit(body, stampCopy);
  visit(body, copy);
  const Bytes content = body.take();
  Head head;
  std::memcpy(head.magic, kMagic.data(), kMagic.size());
  head.version = kVersion;
  head.byteOrder = kByteOrder;
  head.check = hashOf(asText(content));
  Writer whole;
  whole.raw(&head, sizeof head);
  whole.raw(content.data(), content.size());
  try {
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    writeFileAtomically(fileFor(folder, stamp), whole.take());
  } catch (const IoError&) {
    // A cache that cannot be written costs the next start some time and nothing else.
  }
}

}  // namespace idap
