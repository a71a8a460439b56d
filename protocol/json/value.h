// A JSON value as the protocol passes it on: null, a boolean, a number, a text, an array or an object.
//
// It is a plain class rather than a library's template because nearly every source of the protocol, the server and the
// command holds one: a template would be instantiated anew in each of them, which made up half of the time that a first
// build took.  The text is still read by a library (json_text.cpp).
//
// An object keeps the order of its fields, so that what is passed through stays readable; looking up a field takes time
// linear in their number, which the reader limits.  Integers are kept apart from decimals, so that ids of 64 bits
// survive.
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace selvage::protocol::json {

class Json {
 public:
  enum class Kind : std::uint8_t { kNull, kBoolean, kInteger, kUnsigned, kDecimal, kText, kArray, kObject };
  using Array = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;
  struct Part;  // of a value that is written out in braces
  using Parts = std::initializer_list<Part>;

  Json() = default;  // null
  // Implicit, so that values and the parts of objects can be written as they are.
  // NOLINTBEGIN(google-explicit-constructor)
  Json(std::nullptr_t) {}
  Json(std::same_as<bool> auto value) : kind_{Kind::kBoolean} { held_.boolean = value; }
  Json(std::signed_integral auto value) : kind_{Kind::kInteger} { held_.integer = value; }
  template <std::unsigned_integral T>
  requires(!std::same_as<T, bool>) Json(T value) : kind_{Kind::kUnsigned} { held_.natural = value; }
  Json(double value) : kind_{Kind::kDecimal} { held_.decimal = value; }
  Json(std::string value);
  Json(std::string_view value);
  Json(const char* value);
  // NOLINTEND(google-explicit-constructor)
  // An object when every part is a pair of a text and a value, otherwise an array.
  Json(Parts parts);
  Json(const Json& other);
  Json(Json&& other) noexcept : kind_{other.kind_}, held_{other.held_} { other.kind_ = Kind::kNull; }
  Json& operator=(const Json& other);
  Json& operator=(Json&& other) noexcept;
  ~Json() {
    if (kind_ >= Kind::kText) release();
  }

  [[nodiscard]] static Json array(Parts parts = {});
  [[nodiscard]] static Json array(std::size_t size);  // of nulls
  [[nodiscard]] static Json object(Parts parts = {});
  // A text of our own making.  Throws std::invalid_argument when it is not JSON; what comes from outside is read by
  // parse() of json_text.h.
  [[nodiscard]] static Json parse(std::string_view text);

  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] bool is_null() const { return kind_ == Kind::kNull; }
  [[nodiscard]] bool is_boolean() const { return kind_ == Kind::kBoolean; }
  [[nodiscard]] bool is_number() const { return is_number_integer() || kind_ == Kind::kDecimal; }
  [[nodiscard]] bool is_number_integer() const { return kind_ == Kind::kInteger || is_number_unsigned(); }
  // Not negative: the reader makes every integer from zero up unsigned.
  [[nodiscard]] bool is_number_unsigned() const { return kind_ == Kind::kUnsigned; }
  [[nodiscard]] bool is_string() const { return kind_ == Kind::kText; }
  [[nodiscard]] bool is_array() const { return kind_ == Kind::kArray; }
  [[nodiscard]] bool is_object() const { return kind_ == Kind::kObject; }

  // The value as a bool, a number type or a string; numbers are converted as by static_cast.
  // Throws std::logic_error when the value is of another kind.
  template <typename T>
  [[nodiscard]] T get() const {
    if constexpr (std::same_as<T, bool>) {
      return boolean();
    } else if constexpr (std::integral<T>) {
      return static_cast<T>(kind_ == Kind::kUnsigned ? static_cast<std::int64_t>(natural()) : integer());
    } else if constexpr (std::floating_point<T>) {
      return static_cast<T>(number());
    } else {
      return T{text()};
    }
  }
  [[nodiscard]] const std::string& text() const;
  [[nodiscard]] double number() const;

  // Elements of an array or fields of an object; 0 for null, 1 for anything else.
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] bool empty() const { return size() == 0; }

  // Of an array; no elements for any other kind.
  [[nodiscard]] Json* begin() { return elements().data(); }
  [[nodiscard]] Json* end() { return begin() + elements().size(); }
  [[nodiscard]] const Json* begin() const { return elements().data(); }
  [[nodiscard]] const Json* end() const { return begin() + elements().size(); }
  // REQUIRES: an array that has the element.
  [[nodiscard]] Json& operator[](std::size_t index) { return elements()[index]; }
  [[nodiscard]] const Json& operator[](std::size_t index) const { return elements()[index]; }
  [[nodiscard]] Json& operator[](int index) { return elements()[static_cast<std::size_t>(index)]; }
  [[nodiscard]] const Json& operator[](int index) const { return elements()[static_cast<std::size_t>(index)]; }
  [[nodiscard]] Json& front() { return elements().front(); }
  [[nodiscard]] const Json& front() const { return elements().front(); }
  [[nodiscard]] Json& back() { return elements().back(); }
  [[nodiscard]] const Json& back() const { return elements().back(); }
  // A null becomes an array.  REQUIRES: null or an array.
  Json& push_back(Json value);

  // Of an object; no fields for any other kind.
  [[nodiscard]] std::span<const std::pair<std::string, Json>> items() const;
  [[nodiscard]] const Json* find(std::string_view key) const;  // null when there is no such field
  [[nodiscard]] Json* find(std::string_view key);
  [[nodiscard]] bool contains(std::string_view key) const { return find(key) != nullptr; }
  // The field, made when it is missing; a null becomes an object.  REQUIRES: null or an object.
  [[nodiscard]] Json& operator[](std::string_view key);
  [[nodiscard]] Json& operator[](const char* key) { return (*this)[std::string_view{key}]; }
  // The field, or null when there is none.
  [[nodiscard]] const Json& operator[](std::string_view key) const;
  [[nodiscard]] const Json& operator[](const char* key) const { return (*this)[std::string_view{key}]; }
  template <typename T>
  [[nodiscard]] T value(std::string_view key, T fallback) const {
    const Json* found = find(key);
    if (!found) return fallback;
    if constexpr (std::same_as<T, Json>) {
      return *found;
    } else {
      return found->get<T>();
    }
  }
  [[nodiscard]] std::string value(std::string_view key, const char* fallback) const {
    return value(key, std::string{fallback});
  }
  // Adds a field without looking whether it is there.  REQUIRES: an object without this field.
  Json& append(std::string key, Json value);
  // Removes the field or the element, if there is one.
  void erase(std::string_view key);
  void erase(std::size_t index);
  // Sets every field of `fields`, in their order.  REQUIRES: both are objects.
  void update(const Json& fields);

  // Numbers are equal when their values are; objects whatever the order of their fields.
  friend bool operator==(const Json& a, const Json& b) { return equal(a, b); }
  // Numbers by their value, texts by their characters; anything else is unordered.
  friend std::partial_ordering operator<=>(const Json& a, const Json& b) {
    if (a.is_number() && b.is_number()) return a.number() <=> b.number();
    if (a.is_string() && b.is_string()) return a.text() <=> b.text();
    return std::partial_ordering::unordered;
  }
  // As compact text, for messages of tests.
  friend std::ostream& operator<<(std::ostream& out, const Json& value) { return print(out, value); }

 private:
  union Held {
    bool boolean;
    std::int64_t integer;
    std::uint64_t natural = 0;
    double decimal;
    std::string* text;
    Array* array;
    Object* object;
  };

  [[nodiscard]] bool boolean() const;
  [[nodiscard]] std::int64_t integer() const;
  [[nodiscard]] std::uint64_t natural() const { return held_.natural; }
  [[nodiscard]] std::span<Json> elements();
  [[nodiscard]] std::span<const Json> elements() const;
  [[nodiscard]] Object& fields();
  void become(Kind container);
  void release() noexcept;
  static bool equal(const Json& a, const Json& b);
  static std::ostream& print(std::ostream& out, const Json& value);

  Kind kind_ = Kind::kNull;
  Held held_{};
};

// Moved rather than copied out of the braces that it is written in.
struct Json::Part {
  Part(Parts parts) : value(parts) {}
  template <typename T>
  // NOLINTNEXTLINE(google-explicit-constructor,bugprone-forwarding-reference-overload): no Json is made of a Part
  requires std::constructible_from<Json, T&&> Part(T&& from) : value(std::forward<T>(from)) {}

  mutable Json value;
};

inline Json::Json(const char* value) : Json(std::string_view{value}) {}

}  // namespace selvage::protocol::json

// Vocabulary: named in selvage itself as well, so that every room may use it unqualified.
namespace selvage {
using protocol::json::Json;
}  // namespace selvage
