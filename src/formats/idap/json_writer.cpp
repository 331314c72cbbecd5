#include "formats/idap/json_writer.h"

#include <charconv>
#include <nlohmann/json.hpp>

#include "formats/idap/fields.h"

namespace idap::idap_format {

using nlohmann::json;

namespace {

// A float as the number people would write for it: 0.7, not 0.699999988079071.
double shortest(float value) {
  char text[32];
  const auto written = std::to_chars(text, text + sizeof text, value);
  double result = 0;
  std::from_chars(text, written.ptr, result);
  return static_cast<float>(result) == value ? result : static_cast<double>(value);
}

json write(bool value) { return value; }
json write(int value) { return value; }
json write(std::int64_t value) { return value; }
json write(std::uint64_t value) { return value; }
json write(double value) { return value; }
json write(const std::string& value) { return value; }
json write(Vec2 v) { return json::array({v.x, v.y}); }
json write(Vec3 v) { return json::array({v.x, v.y, v.z}); }
json write(const Color& c) { return json::array({shortest(c.r), shortest(c.g), shortest(c.b)}); }
template <class Tag>
json write(Id<Tag> id) {
  return id.value;
}
template <NamedEnum E>
json write(E value) {
  return std::string(EnumNames<E>::kNames.at(static_cast<std::size_t>(value)));
}
template <Described T>
json write(const T& value);
template <class T>
json write(const std::optional<T>& value) {
  return value ? write(*value) : json();
}
template <class Range>
json writeAll(const Range& values) {
  json result = json::array();
  for (const auto& value : values) result.push_back(write(value));
  return result;
}
template <class T>
json write(const std::vector<T>& values) {
  return writeAll(values);
}
template <class T, std::size_t N>
json write(const std::array<T, N>& values) {
  return writeAll(values);
}
template <class T>
json write(const std::map<std::string, T>& values) {
  json result = json::object();
  for (const auto& [key, value] : values) result[key] = write(value);
  return result;
}
json write(const std::map<LevelId, Background>& values) {
  json result = json::array();
  for (const auto& [level, background] : values) {
    result.push_back(write(background));
    if (level) result.back()["level"] = level.value;
  }
  return result;
}
template <class IdType, class T>
json write(const Table<IdType, T>& table) {
  json result = json::array();
  for (const auto& [id, element] : table) {
    result.push_back(write(*element));
    result.back()["id"] = id.value;
  }
  return result;
}

template <class T>
class Writer {
 public:
  Writer(const T& value, json& into) : value_(value), into_(into) {}

  template <class Member>
  Writer& operator()(const char* name, Member member) {
    static const T defaults{};
    if (!(value_.*member == defaults.*member)) into_[name] = write(value_.*member);
    return *this;
  }

 private:
  const T& value_;
  json& into_;
};

template <Described T>
json write(const T& value) {
  json result = json::object();
  Writer<T> writer(value, result);
  listFields(writer, Of<T>{});
  return result;
}

void print(const json& value, std::size_t depth, std::string& out) {
  const auto newLine = [&out](std::size_t indent) {
    out += '\n';
    out.append(indent, ' ');
  };
  const bool plainArray = value.is_array() && std::none_of(value.begin(), value.end(),
                                                           [](const json& v) { return v.is_structured(); });
  if (!value.is_structured() || value.empty()) {
    out += value.dump();
  } else if (plainArray) {
    out += '[';
    for (std::size_t i = 0; i < value.size(); ++i) out += (i ? ", " : "") + value[i].dump();
    out += ']';
  } else if (value.is_array()) {
    out += '[';
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (i) out += ',';
      newLine(depth + 1);
      print(value[i], depth + 1, out);
    }
    newLine(depth);
    out += ']';
  } else {
    out += '{';
    bool first = true;
    for (const auto& [key, member] : value.items()) {
      if (!first) out += ',';
      first = false;
      newLine(depth + 1);
      out += json(key).dump() + ": ";
      print(member, depth + 1, out);
    }
    newLine(depth);
    out += '}';
  }
}

}  // namespace

json toJson(const Home& home) { return write(home); }

std::string printJson(const json& value) {
  std::string out;
  print(value, 0, out);
  out += '\n';
  return out;
}

}  // namespace idap::idap_format
