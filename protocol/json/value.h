// A JSON value: null, a boolean, a number, a text, an array or an object.
//
// It is a plain class rather than a library's template because nearly every source of the protocol, the server and the
// command holds one: a template would be instantiated again in each of them, which took half of the time of a first
// build.  JSON text is still parsed by a library (json_text.cpp).
//
// An object keeps the order of its fields, so that documents that are passed through remain readable.  Looking up a
// field takes time linear in the number of fields, which the reader limits.  Integers are stored separately from
// decimals, so that 64-bit ids are preserved.
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
  // The constructors are implicit, so that values and parts of objects can be written without a cast.
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

  // An object if every part is a pair of a text and a value, otherwise an array.
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
  // Parses a text from the program itself.  Throws std::invalid_argument if it is not JSON.  Use parse() of json_text.h
  // for text from outside.
  [[nodiscard]] static Json parse(std::string_view text);

  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] bool is_null() const { return kind_ == Kind::kNull; }
  [[nodiscard]] bool is_boolean() const { return kind_ == Kind::kBoolean; }
  [[nodiscard]] bool is_number() const { return is_number_integer() || kind_ == Kind::kDecimal; }
  [[nodiscard]] bool is_number_integer() const { return kind_ == Kind::kInteger || is_number_unsigned(); }
  // Not negative: the reader stores every integer that is at least 0 as unsigned.
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
  // The field, made when it is missing, which invalidates references to the others; a null becomes an object.
  // REQUIRES: null or an object.
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
  // Adds a field without checking whether it exists.  REQUIRES: an object without this field.
  Json& append(std::string key, Json value);
  // Removes the field or the element, if there is one.
  void erase(std::string_view key);
  void erase(std::size_t index);
  // Sets every field of `fields`, in their order.  REQUIRES: both are objects.
  void update(const Json& fields);

  // Numbers are equal if their values are.  The order of an object's fields does not matter.
  friend bool operator==(const Json& a, const Json& b) { return equal(a, b); }
  // Orders numbers by value and texts by their characters; anything else is unordered.
  friend std::partial_ordering operator<=>(const Json& a, const Json& b) {
    if (a.is_number() && b.is_number()) return a.number() <=> b.number();
    if (a.is_string() && b.is_string()) return a.text() <=> b.text();
    return std::partial_ordering::unordered;
  }
  // Prints compact text, for the messages of tests.
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

// Allows moving a value out of an initializer list, which would otherwise copy it.
struct Json::Part {
  Part(Parts parts) : value(parts) {}
  template <typename T>
  // NOLINTNEXTLINE(google-explicit-constructor,bugprone-forwarding-reference-overload): no Json is made of a Part
  requires std::constructible_from<Json, T&&> Part(T&& from) : value(std::forward<T>(from)) {}

  mutable Json value;
};

inline Json::Json(const char* value) : Json(std::string_view{value}) {}

}  // namespace selvage::protocol::json

// Also declared in the namespace selvage, so that every folder may use the name unqualified.
namespace selvage {
using protocol::json::Json;
}  // namespace selvage
