#include "protocol/json/fields.h"

#include <algorithm>
#include <cmath>

namespace selvage::protocol::json {
namespace {

const Json& nothing() {
  static const Json empty = Json::object();
  return empty;
}

// JSON pointer escapes: "~" is "~0" and "/" is "~1".
std::string escaped(std::string_view key) {
  std::string out;
  for (const char c : key) {
    if (c == '~') {
      out += "~0";
    } else if (c == '/') {
      out += "~1";
    } else {
      out += c;
    }
  }
  return out;
}

std::string range_text(Range allowed) {
  const bool open_below = allowed.least == std::numeric_limits<double>::lowest();
  const bool open_above = allowed.most == std::numeric_limits<double>::max();
  if (open_below && open_above) return "any finite number is allowed";
  if (open_above) return "at least " + number_text(allowed.least) + " is allowed";
  if (open_below) return "at most " + number_text(allowed.most) + " is allowed";
  return number_text(allowed.least) + " to " + number_text(allowed.most) + " is allowed";
}

}  // namespace

Fields::Fields(const Json& value, std::string at, Mistake& mistake)
    : value_{value.is_object() ? value : nothing()}, at_{std::move(at)}, mistake_{mistake} {
  if (!value.is_object()) {
    mistake_.add(ErrorCode::kWrongType, shortened(value) + " where an object is required", at_);
  }
}

std::string Fields::pointer(std::string_view key) const {
  return at_ + "/" + escaped(key);
}
bool Fields::has(std::string_view key) const {
  return value_.contains(key);
}

const Json* Fields::find(std::string_view key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
  return value_.find(key);
}

const Json* Fields::require(std::string_view key) {
  const Json* value = find(key);
  if (!value) mistake_.add(ErrorCode::kMissingField, "the field is missing; it is required", pointer(key));
  return value;
}

const Json* Fields::typed(const Json* value, bool matches, std::string_view key, std::string_view allowed) {
  if (!value || matches) return value;
  mistake_.add(ErrorCode::kWrongType, shortened(*value) + " where " + std::string{allowed} + " is required",
               pointer(key));
  return nullptr;
}

double checked_number(const Json& value, Range allowed, Mistake& mistake, const std::string& at) {
  if (!value.is_number()) {
    mistake.add(ErrorCode::kWrongType, shortened(value) + " where a number is required", at);
    return allowed.least;
  }
  const double number = value.get<double>();
  if (!(std::isfinite(number) && number >= allowed.least && number <= allowed.most)) {
    mistake.add(ErrorCode::kOutOfRange, shortened(value) + " is out of range; " + range_text(allowed), at);
    return allowed.least;
  }
  return number;
}

double Fields::number(std::string_view key, Range allowed) {
  const Json* value = require(key);
  return value ? checked_number(*value, allowed, mistake_, pointer(key)) : allowed.least;
}

double Fields::number_or(std::string_view key, double fallback, Range allowed) {
  return maybe_number(key, allowed).value_or(fallback);
}

std::optional<double> Fields::maybe_number(std::string_view key, Range allowed) {
  const Json* value = find(key);
  if (!value) return std::nullopt;
  return checked_number(*value, allowed, mistake_, pointer(key));
}

std::optional<std::int64_t> whole_number(const Json& value) {
  if (value.is_number_unsigned() && value.get<std::uint64_t>() > INT64_MAX) return std::nullopt;
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (!value.is_number()) return std::nullopt;
  constexpr double kEnd = 0x1p63;
  const double number = value.get<double>();
  if (!(number >= -kEnd && number < kEnd) || std::trunc(number) != number) return std::nullopt;
  return static_cast<std::int64_t>(number);
}

std::optional<std::int64_t> Fields::maybe_integer(std::string_view key, std::int64_t least, std::int64_t most) {
  const Json* value = find(key);
  if (!value) return std::nullopt;
  const bool whole = value->is_number() && std::trunc(value->get<double>()) == value->get<double>();
  if (!whole) {
    typed(value, false, key, "a whole number");
    return std::nullopt;
  }
  const auto number = whole_number(*value);
  if (!number || *number < least || *number > most) {
    mistake_.add(ErrorCode::kOutOfRange,
                 shortened(*value) + " is out of range; " + std::to_string(least) + " to " + std::to_string(most) +
                     " is allowed",
                 pointer(key));
    return std::nullopt;
  }
  return number;
}

std::string Fields::text(std::string_view key) {
  const Json* value = require(key);
  value = typed(value, value && value->is_string(), key, "a string");
  return value ? value->get<std::string>() : std::string{};
}

std::string Fields::text_or(std::string_view key, std::string fallback) {
  const Json* value = find(key);
  value = typed(value, value && value->is_string(), key, "a string");
  return value ? value->get<std::string>() : std::move(fallback);
}

std::string checked_id(const Json& value, Mistake& mistake, const std::string& at) {
  if (value.is_number_integer()) return to_text(value);
  if (const auto number = whole_number(value)) return std::to_string(*number);
  if (value.is_string()) return value.text();
  mistake.add(ErrorCode::kWrongType, shortened(value) + " where a string or a whole number is required", at);
  return {};
}

std::string Fields::id(std::string_view key) {
  const Json* value = require(key);
  return value ? checked_id(*value, mistake_, pointer(key)) : std::string{};
}

bool Fields::flag_or(std::string_view key, bool fallback) {
  const Json* value = find(key);
  value = typed(value, value && value->is_boolean(), key, "true or false");
  return value ? value->get<bool>() : fallback;
}

std::size_t Fields::word_or(std::string_view key, std::size_t fallback, std::span<const std::string_view> words) {
  const Json* value = find(key);
  value = typed(value, value && value->is_string(), key, "a string");
  if (!value) return fallback;
  const auto found = std::find(words.begin(), words.end(), value->text());
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  std::string allowed;
  for (const std::string_view word : words) allowed += (allowed.empty() ? "" : ", ") + std::string{word};
  mistake_.add(ErrorCode::kOutOfRange, shortened(*value) + " is not known; one of " + allowed + " is allowed",
               pointer(key));
  return fallback;
}

const Json& Fields::array(std::string_view key) {
  const Json* value = require(key);
  value = typed(value, value && value->is_array(), key, "an array");
  return value ? *value : nothing();
}

const Json& Fields::object(std::string_view key) {
  const Json* value = require(key);
  value = typed(value, value && value->is_object(), key, "an object");
  return value ? *value : nothing();
}

const Json* Fields::required_any(std::string_view key) {
  return require(key);
}

const Json* Fields::maybe_array(std::string_view key) {
  const Json* value = find(key);
  return typed(value, value && value->is_array(), key, "an array");
}

const Json* Fields::maybe_object(std::string_view key) {
  const Json* value = find(key);
  return typed(value, value && value->is_object(), key, "an object");
}

const Json* Fields::maybe_any(std::string_view key) {
  return find(key);
}

void Fields::finish() {
  if (mistake_) return;
  for (const auto& [key, value] : value_.items()) {
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    std::string allowed;
    for (const std::string& known : known_) allowed += (allowed.empty() ? "" : ", ") + known;
    mistake_.add(ErrorCode::kUnknownField,
                 "the field is not known; allowed here: " + (allowed.empty() ? "none" : allowed), pointer(key));
    return;
  }
}

Json Fields::rest() const {
  Json left = Json::object();
  for (const auto& [key, value] : value_.items()) {
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) left[key] = value;
  }
  return left;
}

Error within(std::string_view prefix, Error error) {
  error.field.insert(0, prefix);
  return error;
}

std::string describe(const Error& error) {
  return error.field.empty() ? error.message : error.field + ": " + error.message;
}

}  // namespace selvage::protocol::json
