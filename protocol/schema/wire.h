// How values of C++ types are represented in JSON.  Wire<T> has
//   type():          the description of the type
//   write(value):    the value as JSON
//   read(at, value): the value from a field of an object; a mistake is noted when the field does not suit, and `value`
//                    keeps its default when the field is absent and not required.  For types of results, read may be
//                    missing.
// Other folders specialise it for their own types.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "protocol/json/fields.h"
#include "protocol/schema/choices.h"
#include "protocol/schema/description.h"

namespace selvage::protocol::schema {

// A field that is being read.
struct FieldAt {
  json::Fields& fields;
  json::Mistake& mistake;
  std::string_view key;
  bool required{};
  const Limits& limits;

  [[nodiscard]] std::string pointer() const { return fields.pointer(key); }
};

template <class T>
struct Wire;

// An id in parameters: a string, or a whole number, which is read as the string of its digits.
struct Id {
  std::string text;
};

template <>
struct Wire<bool> {
  static Type type() { return {Type::Kind::kBoolean}; }
  static Json write(bool value);
  static void read(const FieldAt& at, bool& value) { value = at.fields.flag_or(at.key, value); }
};

template <>
struct Wire<double> {
  static Type type() { return {Type::Kind::kNumber}; }
  static Json write(double value);
  static void read(const FieldAt& at, double& value);
};

// A whole number within the limits' range.  REQUIRES: the range is given.
[[nodiscard]] std::optional<std::int64_t> read_integer(const FieldAt& at);
[[nodiscard]] Json integer_json(std::int64_t value);
[[nodiscard]] Json natural_json(std::uint64_t value);

template <class T>
requires(std::integral<T> && !std::same_as<T, bool>) struct Wire<T> {
  static Type type() { return {Type::Kind::kInteger}; }
  static Json write(T value) {
    return std::signed_integral<T> ? integer_json(static_cast<std::int64_t>(value))
                                   : natural_json(static_cast<std::uint64_t>(value));
  }
  static void read(const FieldAt& at, T& value) {
    if (const auto number = read_integer(at)) value = static_cast<T>(*number);
  }
};

template <>
struct Wire<std::string> {
  static Type type() { return {Type::Kind::kString}; }
  static Json write(const std::string& value);
  static void read(const FieldAt& at, std::string& value);
};

template <>
struct Wire<std::string_view> {
  static Type type() { return {Type::Kind::kString}; }
  static Json write(std::string_view value);
};

template <>
struct Wire<Id> {
  static Type type();
  static Json write(const Id& value);
  static void read(const FieldAt& at, Id& value);
  static Id read_entry(const Json& value, const std::string& at, json::Mistake& mistake);
};

template <Choice Enum>
struct Wire<Enum> {
  static const Component& component() {
    static const Component kComponent{.name = Choices<Enum>::kName,
                                      .meaning = Choices<Enum>::kMeaning,
                                      .words = {std::begin(Choices<Enum>::kWords), std::end(Choices<Enum>::kWords)}};
    return kComponent;
  }
  static Type type() { return {.kind = Type::Kind::kNamed, .component = &component}; }
  static Json write(Enum value) { return Wire<std::string_view>::write(word_of(value)); }
  static void read(const FieldAt& at, Enum& value) {
    if (at.required && !at.fields.required_any(at.key)) return;
    value =
        static_cast<Enum>(at.fields.word_or(at.key, static_cast<std::size_t>(value), std::span{Choices<Enum>::kWords}));
  }
};

// An optional parameter may be absent; a required field of a result that has no value is null (visitors.h).
template <class T>
struct Wire<std::optional<T>> {
  static Type type() { return Wire<T>::type(); }
  static Json write(const std::optional<T>& value) { return value ? Wire<T>::write(*value) : Json{}; }
  static void read(const FieldAt& at, std::optional<T>& value) {
    if (!at.fields.maybe_any(at.key)) return;
    Wire<T>::read({at.fields, at.mistake, at.key, true, at.limits}, value.emplace());
  }
};

// The elements of a list parameter, each with its JSON pointer; none if the list does not satisfy its limits.
[[nodiscard]] std::vector<std::pair<const Json*, std::string>> read_entries(const FieldAt& at);

template <class T>
struct Wire<std::vector<T>> {
  static Type type() { return list_of(Wire<T>::type()); }
  static Json write(const std::vector<T>& values) {
    Json list = Json::array();
    for (const T& value : values) list.push_back(Wire<T>::write(value));
    return list;
  }
  static void read(const FieldAt& at, std::vector<T>& values) {
    for (const auto& [entry, pointer] : read_entries(at)) {
      if (at.mistake) return;
      values.push_back(Wire<T>::read_entry(*entry, pointer, at.mistake));
    }
  }
};

}  // namespace selvage::protocol::schema
