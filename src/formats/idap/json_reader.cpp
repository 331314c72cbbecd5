#include "formats/idap/json_reader.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "formats/idap/fields.h"

namespace idap::idap_format {

using nlohmann::json;

namespace {

constexpr std::size_t kMaxDepth = 64;
constexpr std::size_t kMaxValues = 20'000'000;

// The way from the root to the value being read, on the stack of the reader.
struct Place {
  const Place* parent = nullptr;
  std::string_view key;
  std::size_t index = 0;
  bool isIndex = false;

  std::string pointer() const {
    if (!parent) return "home.json#";
    if (isIndex) return parent->pointer() + '/' + std::to_string(index);
    std::string escaped;  // RFC 6901
    for (const char c : key.substr(0, 80)) escaped += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return parent->pointer() + '/' + escaped;
  }
  // The same for all elements of a list, to count equal complaints.
  std::string pattern() const {
    if (!parent) return "home.json#";
    return parent->pattern() + '/' + (isIndex ? "*" : std::string(key.substr(0, 80)));
  }
};

class Source {
 public:
  Source(const std::string& fileName, const Progress& progress) : fileName_(fileName), progress_(progress) {}

  [[noreturn]] void fail(const Place& at, const std::string& expected) const {
    throw ParseError(fileName_, at.pointer(), "expected " + expected);
  }
  void unknown(const Place& at) { ++unknown_[at.pattern()]; }
  void usedTwice(const Place& at) { ++usedTwice_[at.pattern()]; }
  void step(double fraction) const {
    progress_.check();
    progress_.report(fraction, "reading the home");
  }
  void moveTo(ImportReport& report) {
    for (const auto& [place, count] : unknown_)
      report.entries.push_back({place, "unknown to this version: ignored", count});
    for (const auto& [place, count] : usedTwice_)
      report.entries.push_back({place, "number missing or used twice: given a new one", count});
  }

 private:
  const std::string& fileName_;
  const Progress& progress_;
  std::map<std::string, std::size_t> unknown_, usedTwice_;
};

class Reader {
 public:
  Reader(Source& source, const Place& at, const json& value) : source_(source), at_(at), json_(value) {}

  void read(bool& value) const {
    if (!json_.is_boolean()) source_.fail(at_, "true or false");
    value = json_.get<bool>();
  }
  void read(int& value) const {
    value = static_cast<int>(integer(std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
  }
  void read(std::int64_t& value) const {
    value = integer(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max());
  }
  void read(std::uint64_t& value) const {
    if (!json_.is_number_integer() || (!json_.is_number_unsigned() && json_.get<std::int64_t>() < 0))
      source_.fail(at_, "a whole number from 0");
    value = json_.get<std::uint64_t>();
  }
  void read(double& value) const {
    if (!json_.is_number()) source_.fail(at_, "a number");
    value = json_.get<double>();
  }
  void read(float& value) const {
    double wide = 0;
    read(wide);
    value = std::abs(wide) <= 1e30 ? static_cast<float>(wide) : 1e30f;
  }
  void read(std::string& value) const {
    if (!json_.is_string()) source_.fail(at_, "a text");
    value = json_.get_ref<const std::string&>();
  }
  void read(Vec2& v) const { readEach({&v.x, &v.y}, "two numbers"); }
  void read(Vec3& v) const { readEach({&v.x, &v.y, &v.z}, "three numbers"); }
  void read(Color& c) const {
    requireArray(3, "three numbers from 0 to 1");
    element(0, [&](const Reader& reader) { reader.read(c.r); });
    element(1, [&](const Reader& reader) { reader.read(c.g); });
    element(2, [&](const Reader& reader) { reader.read(c.b); });
  }
  template <class Tag>
  void read(Id<Tag>& id) const {
    read(id.value);
  }
  template <NamedEnum E>
  void read(E& value) const {
    const auto& names = EnumNames<E>::kNames;
    std::string word, choices;
    read(word);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == word) {
        value = static_cast<E>(i);
        return;
      }
      choices += (i ? ", " : "") + std::string(names[i]);
    }
    source_.fail(at_, "one of " + choices);
  }
  template <class T>
  void read(std::optional<T>& value) const {
    if (json_.is_null()) {
      value.reset();
      return;
    }
    read(value.emplace());
  }
  template <class T>
  void read(std::vector<T>& values) const {
    requireArray();
    values.clear();
    values.reserve(json_.size());
    eachElement([&](const Reader& element) { element.read(values.emplace_back()); });
  }
  template <class T, std::size_t N>
  void read(std::array<T, N>& values) const {
    requireArray(N, std::to_string(N) + " values");
    for (std::size_t i = 0; i < N; ++i) element(i, [&](const Reader& reader) { reader.read(values[i]); });
  }
  template <class T>
  void read(std::map<std::string, T>& values) const {
    requireObject();
    values.clear();
    for (auto member = json_.begin(); member != json_.end(); ++member) {
      const Place place{&at_, member.key()};
      Reader(source_, place, *member).read(values[member.key()]);
    }
  }
  void read(std::map<LevelId, Background>& values) const {
    requireArray();
    values.clear();
    eachElement([&](const Reader& element) {
      LevelId level;
      Background background;
      element.readFields(background, "level", &level);
      values[level] = std::move(background);
    });
  }
  template <class IdType, class T>
  void read(Table<IdType, T>& table) const {
    requireArray();
    typename Table<IdType, T>::Chunk entries;
    entries.reserve(json_.size());
    std::map<IdType, std::size_t> seen;
    std::uint64_t last = 0;
    eachElement([&](const Reader& element) {
      IdType id;
      auto value = std::make_shared<T>();
      element.readFields(*value, "id", &id);
      entries.emplace_back(id, std::move(value));
      if (id.value < kUnusable) last = std::max(last, id.value);
    });
    // A number used twice in one list would hide an element: it gets one that validation may change again.
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (seen.emplace(entries[i].first, i).second && entries[i].first) continue;
      source_.usedTwice(at_);
      entries[i].first = IdType{++last};
    }
    table = Table<IdType, T>::of(std::move(entries));
  }
  template <Described T>
  void read(T& value) const {
    value = T{};
    readFields(value, nullptr, static_cast<LevelId*>(nullptr));
  }

  // The members of a struct, and one member beside them.
  template <class T, class Beside>
  void readFields(T& value, const char* besideName, Beside* beside) const {
    requireObject();
    Members<T> members{*this, value};
    listFields(members, Of<T>{});
    if (besideName) members.take(besideName, *beside);
    if (members.taken == json_.size()) return;
    Names<T> known;
    listFields(known, Of<T>{});
    for (auto member = json_.begin(); member != json_.end(); ++member)
      if (!known.names.contains(member.key()) && (!besideName || member.key() != besideName))
        source_.unknown(Place{&at_, member.key()});
  }

 private:
  static constexpr std::uint64_t kUnusable = std::uint64_t{1} << 60;

  template <class T>
  struct Members {
    const Reader& reader;
    T& value;
    std::size_t taken = 0;

    template <class Member>
    Members& operator()(const char* name, Member member) {
      take(name, value.*member);
      return *this;
    }
    template <class V>
    void take(const char* name, V& into) {
      const auto found = reader.json_.find(name);
      if (found == reader.json_.end()) return;
      ++taken;
      const Place place{&reader.at_, name};
      Reader(reader.source_, place, *found).read(into);
    }
  };
  template <class T>
  struct Names {
    std::set<std::string> names;
    template <class Member>
    Names& operator()(const char* name, Member) {
      names.insert(name);
      return *this;
    }
  };

  void requireObject() const {
    if (!json_.is_object()) source_.fail(at_, "an object");
  }
  void requireArray() const {
    if (!json_.is_array()) source_.fail(at_, "a list");
  }
  void requireArray(std::size_t size, const std::string& what) const {
    if (!json_.is_array() || json_.size() != size) source_.fail(at_, what);
  }
  std::int64_t integer(std::int64_t low, std::int64_t high) const {
    const bool whole =
        json_.is_number_integer() &&
        (!json_.is_number_unsigned() ||
         json_.get<std::uint64_t>() <= std::uint64_t(std::numeric_limits<std::int64_t>::max()));
    if (!whole) source_.fail(at_, "a whole number");
    const auto value = json_.get<std::int64_t>();
    if (value < low || value > high) source_.fail(at_, "a smaller whole number");
    return value;
  }
  void readEach(std::initializer_list<double*> into, const char* what) const {
    requireArray(into.size(), what);
    std::size_t i = 0;
    for (double* target : into) element(i++, [&](const Reader& reader) { reader.read(*target); });
  }
  template <class F>
  void element(std::size_t i, F&& f) const {
    const Place place{&at_, {}, i, true};
    f(Reader(source_, place, json_[i]));
  }
  template <class F>
  void eachElement(F&& f) const {
    for (std::size_t i = 0; i < json_.size(); ++i) {
      if (i % 4096 == 4095) source_.step(0.5);
      element(i, f);
    }
  }

  Source& source_;
  const Place& at_;
  const json& json_;
};

// The recursion of everything that walks the tree is bounded here, before a tree is built.
void checkExtent(std::string_view text, const std::string& fileName) {
  std::size_t depth = 0, values = 0;
  bool inString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inString) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        inString = false;
      continue;
    }
    if (c == '"') inString = true;
    if (c == '[' || c == '{') {
      if (++depth > kMaxDepth)
        throw ParseError(fileName, "home.json byte " + std::to_string(i), "nested too deeply");
      ++values;
    }
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (c == ',' && ++values > kMaxValues) throw ParseError(fileName, "home.json", "holds too many values");
  }
}

}  // namespace

json parseJson(std::string_view text, const std::string& fileName) {
  checkExtent(text, fileName);
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    throw ParseError(fileName, "home.json byte " + std::to_string(error.byte), "is not JSON");
  } catch (const json::exception& error) {  // a number that no double holds
    throw ParseError(fileName, "home.json", error.what());
  }
}

Home fromJson(const json& value, const std::string& fileName, const Progress& progress,
              ImportReport& report) {
  Source source(fileName, progress);
  Home home;
  const Place root;
  std::uint64_t version = 0;
  Reader(source, root, value).readFields(home, "version", &version);
  source.moveTo(report);
  return home;
}

}  // namespace idap::idap_format
