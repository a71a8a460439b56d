// Reads a JSON object field by field and reports mistakes with the field's name.
//
// A Fields wraps one object and knows its JSON pointer.  Each getter checks the type and the range and marks the field
// as read; finish() reports the first field that was not read.  The first mistake is kept in the shared Mistake and is
// the one that is reported.  After it, getters return harmless values, so the calling code needs only one check at its
// end.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "protocol/json/json_text.h"

namespace selvage::protocol::json {

// A closed range of numbers.
struct Range {
  double least = std::numeric_limits<double>::lowest();
  double most = std::numeric_limits<double>::max();
};

// The first thing that was wrong.
class Mistake {
 public:
  void add(ErrorCode code, std::string message, std::string field) {
    if (!first_) first_ = Error{code, std::move(message), std::move(field)};
  }
  void add(const Error& error) {
    if (!first_) first_ = error;
  }
  [[nodiscard]] explicit operator bool() const { return first_.has_value(); }
  // REQUIRES: there is one.
  [[nodiscard]] const Error& error() const { return *first_; }

 private:
  std::optional<Error> first_;
};

class Fields {
 public:
  // `at` is the JSON pointer of `value`, "" for the whole document.  A mistake when `value` is not an object.
  // REQUIRES: `value` and `mistake` outlive the reader.
  Fields(const Json& value, std::string at, Mistake& mistake);

  [[nodiscard]] std::string pointer(std::string_view key) const;  // of a field
  [[nodiscard]] const std::string& pointer() const { return at_; }
  [[nodiscard]] bool has(std::string_view key) const;

  // Required fields: a mistake when absent.
  [[nodiscard]] double number(std::string_view key, Range allowed = {});
  [[nodiscard]] std::string text(std::string_view key);
  [[nodiscard]] std::string id(std::string_view key);  // a string, or an integer read as its digits
  [[nodiscard]] const Json& array(std::string_view key);
  [[nodiscard]] const Json& object(std::string_view key);
  [[nodiscard]] const Json* required_any(std::string_view key);  // of any type; null when absent

  // Optional fields: the fallback when absent.
  [[nodiscard]] double number_or(std::string_view key, double fallback, Range allowed = {});
  [[nodiscard]] std::optional<double> maybe_number(std::string_view key, Range allowed = {});
  [[nodiscard]] std::optional<std::int64_t> maybe_integer(std::string_view key, std::int64_t least, std::int64_t most);
  [[nodiscard]] std::string text_or(std::string_view key, std::string fallback);
  [[nodiscard]] bool flag_or(std::string_view key, bool fallback);
  // The position of the field's value among `words`.
  [[nodiscard]] std::size_t word_or(std::string_view key, std::size_t fallback,
                                    std::span<const std::string_view> words);
  [[nodiscard]] const Json* maybe_array(std::string_view key);
  [[nodiscard]] const Json* maybe_object(std::string_view key);
  [[nodiscard]] const Json* maybe_any(std::string_view key);

  // Reports the first field that no getter has read.
  void finish();
  // The fields that no getter has read, for formats that may contain more than we read.
  [[nodiscard]] Json rest() const;

 private:
  const Json* find(std::string_view key);
  const Json* require(std::string_view key);
  const Json* typed(const Json* value, bool matches, std::string_view key, std::string_view allowed);

  const Json& value_;
  std::string at_;
  Mistake& mistake_;
  std::vector<std::string> known_;  // the fields that getters have asked for, present or not
};

// One number outside an object, such as an element of an array.  `at` is called only for a mistake.
[[nodiscard]] double checked_number(const Json& value, Range allowed, Mistake& mistake, const std::string& at);

// The value if it is a whole number of at most 64 bits, however it is written: 60, 60.0 and 6e1 are the same number.
[[nodiscard]] std::optional<std::int64_t> whole_number(const Json& value);
// An id that is an element of an array: a string, or an integer read as its digits.
[[nodiscard]] std::string checked_id(const Json& value, Mistake& mistake, const std::string& at);

// The error with its field moved below `prefix`: "/shapes/0" becomes "/marker/shapes/0".
[[nodiscard]] Error within(std::string_view prefix, Error error);
// An error as one line: "/strip/width: -5 is out of range; 1e-06 to 1000000000 is allowed".
[[nodiscard]] std::string describe(const Error& error);

}  // namespace selvage::protocol::json
