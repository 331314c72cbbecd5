#include "editor/tools/typed_fields.h"

#include <algorithm>
#include <string_view>

#include "base/error.h"

namespace idap {

namespace {

constexpr std::size_t kLongest = 200;  // bytes: nobody types more by hand

bool isOneOf(std::string_view character, std::string_view set) {
  return character.size() == 1 && set.find(character) != std::string_view::npos;
}

// Signs that people type for feet, inches and degrees beyond ASCII.
bool isSign(std::string_view c) {
  return c == "\xE2\x80\xB2" || c == "\xE2\x80\xB3" || c == "\xE2\x80\x99" || c == "\xE2\x80\x9D" ||
         c == "\xC2\xB0";
}

bool belongs(const Field& field, std::string_view c) {
  if (c.empty()) return false;
  if (field.kind == Field::Kind::Text) return static_cast<unsigned char>(c.front()) >= 0x20 && c != "\x7F";
  if (isOneOf(c, "0123456789.,-+(")) return true;
  if (field.typed.empty()) return false;
  if (isOneOf(c, "*/) ") || isSign(c)) return true;
  return field.kind == Field::Kind::Length ? isOneOf(c, "'\"mcdftin") : isOneOf(c, "deg");
}

void dropLastCharacter(std::string& text) {
  while (!text.empty()) {
    const bool continues = (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80;
    text.pop_back();
    if (!continues) return;
  }
}

}  // namespace

std::optional<double> parseAngle(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size();) {
    if (text.substr(i).starts_with("\xC2\xB0")) {
      i += 2;
    } else if (text.substr(i).starts_with("deg")) {
      i += 3;
    } else {
      plain += text[i++];
    }
  }
  if (plain.find_first_not_of("0123456789.,+-*/() ") != std::string::npos) return std::nullopt;
  try {
    return parseLength(plain, LengthUnit::Metre) * kPi / 180;
  } catch (const Error&) {
    return std::nullopt;
  }
}

void TypedFields::define(std::vector<Field> fields) {
  fields_ = std::move(fields);
  values_.assign(fields_.size(), std::nullopt);
  std::size_t chosen = 0;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (fields_[i].active) chosen = i;
    fields_[i].typed.clear();
    fields_[i].wrong = false;
  }
  activate(chosen);
}

void TypedFields::show(std::size_t index, double value) {
  if (index < fields_.size()) fields_[index].value = value;
}

void TypedFields::activate(std::size_t index) {
  active_ = index < fields_.size() ? index : 0;
  for (std::size_t i = 0; i < fields_.size(); ++i) fields_[i].active = i == active_;
}

bool TypedFields::typing() const {
  return std::any_of(fields_.begin(), fields_.end(), [](const Field& f) { return !f.typed.empty(); });
}

bool TypedFields::wrong() const {
  return std::any_of(fields_.begin(), fields_.end(), [](const Field& f) { return f.wrong; });
}

std::optional<double> TypedFields::value(std::size_t index) const {
  return index < values_.size() ? values_[index] : std::nullopt;
}

std::string TypedFields::text(std::size_t index) const {
  return index < fields_.size() ? fields_[index].typed : std::string();
}

TypedFields::Answer TypedFields::key(const KeyEvent& event, LengthUnit unit) {
  if (fields_.empty()) return Answer::Unused;
  Field& field = fields_[active_];
  switch (event.key) {
    case Key::Character:
      // A shortcut is not typed; AltGr, which writes signs on many keyboards, comes as both.
      if (event.modifiers.control != event.modifiers.alt) return Answer::Unused;
      if (!belongs(field, event.text) || field.typed.size() + event.text.size() > kLongest)
        return Answer::Unused;
      field.typed += event.text;
      break;
    case Key::Backspace:
      if (field.typed.empty()) return Answer::Unused;
      dropLastCharacter(field.typed);
      break;
    case Key::Tab:
    case Key::BackTab: {
      if (fields_.size() < 2) return Answer::Unused;
      const std::size_t step = event.key == Key::Tab ? 1 : fields_.size() - 1;
      activate((active_ + step) % fields_.size());
      return Answer::Changed;
    }
    case Key::Escape:
      if (!typing()) return Answer::Unused;
      clear();
      return Answer::Changed;
    case Key::Enter:
      if (field.kind == Field::Kind::Text && event.modifiers.shift) {
        field.typed += '\n';
        break;
      }
      if (!typing()) return Answer::Unused;
      return wrong() ? Answer::Wrong : Answer::Apply;
    default:
      return Answer::Unused;
  }
  read(active_, unit);
  return Answer::Changed;
}

void TypedFields::read(std::size_t index, LengthUnit unit) {
  Field& field = fields_[index];
  values_[index].reset();
  field.wrong = false;
  if (field.typed.empty() || field.kind == Field::Kind::Text) return;
  if (field.kind == Field::Kind::Angle) {
    values_[index] = parseAngle(field.typed);
  } else {
    try {
      values_[index] = parseLength(field.typed, unit);
    } catch (const Error&) {
      // Half typed, or nonsense: the field shows it.
    }
  }
  field.wrong = !values_[index];
}

void TypedFields::clear() {
  for (std::size_t i = 0; i < fields_.size(); ++i) clear(i);
}

void TypedFields::clear(std::size_t index) {
  if (index >= fields_.size()) return;
  fields_[index].typed.clear();
  fields_[index].wrong = false;
  values_[index].reset();
}

void TypedFields::into(Overlay& overlay, Vec2 at) const {
  overlay.fields = fields_;
  overlay.fieldsAt = at;
}

}  // namespace idap
