#include "protocol/json/json_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

namespace selvage::protocol::json {
namespace {

// "line 3, column 14" of a byte position.
std::string place_of(std::string_view text, std::size_t position) {
  std::size_t line = 1, column = 1;
  for (const char c : text.substr(0, position)) {
    column = c == '\n' ? 1 : column + 1;
    line += c == '\n';
  }
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

// Checks the depth of nesting and the number of values before anything is built, because a deep tree cannot even be
// destroyed safely.
std::optional<Error> check_shape(std::string_view text, std::size_t most) {
  int depth = 0;
  std::size_t values = 1;  // at most
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      in_string = c != '"';
      continue;
    }
    in_string = c == '"';
    if (c == ',' || c == '[' || c == '{') ++values;
    if (values > most) {
      return Error{ErrorCode::kOutOfRange, "JSON of more than " + std::to_string(most) + " values", ""};
    }
    if (c == '[' || c == '{') {
      if (++depth > kMaxDepth) {
        return Error{ErrorCode::kDepth,
                     "JSON nested deeper than " + std::to_string(kMaxDepth) + " levels at " + place_of(text, i), ""};
      }
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return std::nullopt;
}

using Library = nlohmann::json;

// Builds the document from the parser's events, in order to refuse texts that the parser itself
// accepts.
class Builder {
 public:
  using number_integer_t = Library::number_integer_t;
  using number_unsigned_t = Library::number_unsigned_t;
  using number_float_t = Library::number_float_t;
  using string_t = Library::string_t;
  using binary_t = Library::binary_t;

  explicit Builder(std::string_view text) : text_{text} {}

  bool null() { return place(Json(nullptr)); }
  bool boolean(bool value) { return place(Json(value)); }
  bool number_integer(number_integer_t value) { return place(Json(value)); }
  bool number_unsigned(number_unsigned_t value) { return place(Json(value)); }
  bool number_float(number_float_t value, const string_t&) { return place(Json(value)); }
  bool string(string_t& value) { return place(Json(std::move(value))); }
  bool binary(binary_t&) { return false; }

  bool start_object(std::size_t) { return open(Json::object()); }
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open(Json::array()); }
  bool end_array() { return close(); }

  bool key(string_t& value) {
    const Json& object = *open_.back();
    if (object.size() >= kMaxFields) {
      return fail(ErrorCode::kOutOfRange, "an object has more than " + std::to_string(kMaxFields) + " fields",
                  pointer());
    }
    const bool twice = object.contains(value);
    key_ = std::move(value);
    if (twice)
      return fail(ErrorCode::kDuplicateField, "the field appears twice; each may appear once", pointer() + "/" + key_);
    return true;
  }

  bool parse_error(std::size_t position, const std::string& last_token, const nlohmann::detail::exception& e) {
    constexpr int kNumberOverflow = 406;
    const std::string where = place_of(text_, position) + ", near " + shortened(Json(last_token), 40);
    if (e.id == kNumberOverflow) {
      return fail(ErrorCode::kOutOfRange, "a number is too large at " + where + "; numbers reach about 1.8e308", "");
    }
    if (text_.find_first_not_of(" \t\r\n") == std::string_view::npos)
      return fail(ErrorCode::kSyntax, "the text is empty, so it is not JSON", "");
    return fail(ErrorCode::kSyntax, "not JSON at " + where, "");
  }

  [[nodiscard]] Result<Json> take() && {
    if (error_) return *std::move(error_);
    return std::move(root_);
  }

 private:
  bool fail(ErrorCode code, std::string message, std::string field) {
    error_ = Error{code, std::move(message), std::move(field)};
    return false;
  }
  // The JSON pointer of the container being read.
  [[nodiscard]] std::string pointer() const {
    std::string at;
    for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
      const Json& outer = *open_[i];
      at += "/" + (outer.is_array() ? std::to_string(outer.size() - 1) : last_key(outer));
    }
    return at;
  }
  // The field being filled is always the newest.
  [[nodiscard]] static std::string last_key(const Json& object) { return object.items().back().first; }

  bool place(Json value) {
    slot(std::move(value));
    return true;
  }
  Json* slot(Json value) {
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    Json& outer = *open_.back();
    if (outer.is_array()) return &outer.push_back(std::move(value));
    return &outer.append(std::move(key_), std::move(value));  // key() has made sure that it is new
  }
  bool open(Json container) {
    open_.push_back(slot(std::move(container)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  Json root_;
  std::vector<Json*> open_;  // stays valid: a container only grows while it is the innermost
  std::string key_;
  std::optional<Error> error_;
};

void append_text(std::string& out, const Json& value);

void append_string(std::string& out, const std::string& text) {
  for (const char c : text) {
    if (c < 0x20 || c == '"' || c == '\\' || c == 0x7f) {
      // The rare case: escapes, other alphabets.  Invalid UTF-8 becomes the replacement character, not invalid JSON.
      out += Library(text).dump(-1, ' ', false, Library::error_handler_t::replace);
      return;
    }
  }
  out += '"';
  out += text;
  out += '"';
}

void append_object(std::string& out, const Json& object) {
  out += '{';
  bool first = true;
  for (const auto& [key, value] : object.items()) {
    if (!first) out += ',';
    first = false;
    append_string(out, key);
    out += ':';
    append_text(out, value);
  }
  out += '}';
}

void append_array(std::string& out, const Json& array) {
  out += '[';
  bool first = true;
  for (const Json& value : array) {
    if (!first) out += ',';
    first = false;
    append_text(out, value);
  }
  out += ']';
}

void append_text(std::string& out, const Json& value) {
  switch (value.kind()) {
    case Json::Kind::kObject: return append_object(out, value);
    case Json::Kind::kArray: return append_array(out, value);
    case Json::Kind::kText: return append_string(out, value.text());
    case Json::Kind::kBoolean: out += value.get<bool>() ? "true" : "false"; return;
    case Json::Kind::kDecimal: out += number_text(value.get<double>()); return;
    case Json::Kind::kInteger: out += std::to_string(value.get<std::int64_t>()); return;
    case Json::Kind::kUnsigned: out += std::to_string(value.get<std::uint64_t>()); return;
    case Json::Kind::kNull: out += "null"; return;
  }
}

bool holds_object(const Json& value) {
  if (value.is_object()) return true;
  if (!value.is_array()) return false;
  for (const Json& element : value) {
    if (holds_object(element)) return true;
  }
  return false;
}

// An array that holds no object, or an object whose fields are plain and whose text is short.
bool fits_one_line(const Json& value) {
  constexpr std::size_t kShort = 110;
  if (!value.is_object()) return !holds_object(value);
  for (const auto& [key, field] : value.items()) {
    if (holds_object(field) && !field.empty()) return false;
  }
  return to_text(value).size() <= kShort;
}

void append_indented(std::string& out, const Json& value, int level) {
  if (fits_one_line(value)) return append_text(out, value);
  const bool is_object = value.is_object();
  const std::string margin(static_cast<std::size_t>(level + 1), ' ');
  const char* before = "\n";
  const auto start_line = [&] {
    out += before;
    out += margin;
    before = ",\n";
  };
  out += is_object ? '{' : '[';
  for (const auto& [key, field] : value.items()) {
    start_line();
    append_string(out, key);
    out += ": ";
    append_indented(out, field, level + 1);
  }
  for (const Json& element : value) {
    start_line();
    append_indented(out, element, level + 1);
  }
  out += '\n';
  out.append(static_cast<std::size_t>(level), ' ');
  out += is_object ? '}' : ']';
}

}  // namespace

// A text of commas and brackets becomes a tree of forty times its size, so the number of values is limited to a
// fraction of the number of bytes.  Outlines come close to this limit: a point has three values and some twenty bytes.
std::size_t most_values(std::size_t max_bytes) {
  constexpr std::size_t kBytesPerValue = 16, kLeast = 10'000;
  return std::max(kLeast, max_bytes / kBytesPerValue);
}

Result<Json> parse(std::string_view text, std::size_t max_bytes) {
  if (text.size() > max_bytes) {
    return Error{ErrorCode::kOutOfRange,
                 "the text is " + std::to_string(text.size()) + " bytes long; at most " + std::to_string(max_bytes) +
                     " are read",
                 ""};
  }
  if (auto error = check_shape(text, most_values(max_bytes))) return *std::move(error);
  Builder builder{text};
  Library::sax_parse(text.begin(), text.end(), &builder);
  return std::move(builder).take();
}

std::string to_text(const Json& value, Layout layout) {
  std::string out;
  if (layout == Layout::kIndented) {
    append_indented(out, value, 0);
  } else {
    append_text(out, value);
  }
  return out;
}

std::string number_text(double value) {
  constexpr double kTiny = 1e-6, kHuge = 1e15;
  std::array<char, 40> buffer{};
  const double size = std::abs(value);
  const bool plain = size == 0 || (size >= kTiny && size < kHuge);
  const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format);
  return {buffer.data(), end};
}

std::string shortened(const Json& value, std::size_t most) {
  std::string text = to_text(value);
  if (text.size() <= most) return text;
  // Cuts only before the first byte of a character.
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  text.resize(end);
  return text + "...";
}

}  // namespace selvage::protocol::json
