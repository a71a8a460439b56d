#include "protocol/trade/rules/rule_table.h"

#include <algorithm>
#include <cmath>

#include "protocol/json/json_text.h"
#include "protocol/trade/dxf/tags.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::rules {
namespace {

constexpr double kFarthestMovement = 1e5;  // of the table's unit
constexpr std::size_t kMostSizes = 200;

Error bad_rule(std::size_t line, const std::string& what) {
  return {ErrorCode::kSyntax, "line " + std::to_string(line) + " of the rule table: " + what, line_field(line)};
}

// The words of a line, separated by blanks, commas and the like; "S" and (0.5 0.25) are written, too.
std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view kSeparators = " \t,;()\"";
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t from = line.find_first_not_of(kSeparators);
    if (from == std::string_view::npos) return words;
    line.remove_prefix(from);
    const std::size_t length = std::min(line.find_first_of(kSeparators), line.size());
    words.push_back(line.substr(0, length));
    line.remove_prefix(length);
  }
}

bool is_comment(std::string_view line) {
  return line.starts_with(';') || line.starts_with('#') || line.starts_with('*') || line.starts_with("//");
}

class TableReader {
 public:
  explicit TableReader(std::string_view text) : lines_{text}, encoding_{encoding_of(text)} {}

  Result<RuleTable> read() {
    while (const auto line = lines_.next()) {
      const std::string_view text = trimmed(*line);
      if (in_capitals(text) == "END") break;
      if (is_comment(text)) continue;
      if (const auto error = read_line(text)) return *error;
    }
    if (const auto error = finish_rule()) return *error;
    if (table_.sizes.empty()) {
      return Error{ErrorCode::kUnknownFormat, "no grade rule table: there is no SIZE LIST", ""};
    }
    return std::move(table_);
  }

 private:
  std::optional<Error> read_line(std::string_view text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) return rule_ ? read_numbers(text) : std::nullopt;
    const std::string key = in_capitals(trimmed(text.substr(0, colon)));
    const std::string_view value = trimmed(text.substr(colon + 1));
    if (key == "RULE") {
      if (auto error = finish_rule()) return error;
      return begin_rule(value);
    }
    if (key == "UNITS") table_.units = in_capitals(value);
    if (key == "GRADE RULE TABLE") table_.name = decoded(value, encoding_);
    if (key == "SAMPLE SIZE") table_.sample_size = decoded(value, encoding_);
    if (key == "SIZE LIST") {
      for (const std::string_view size : words_of(value)) table_.sizes.push_back(decoded(size, encoding_));
      if (table_.sizes.size() > kMostSizes) {
        return bad_rule(lines_.number(), std::to_string(table_.sizes.size()) + " sizes; at most " +
                                             std::to_string(kMostSizes) + " are allowed");
      }
    }
    return std::nullopt;
  }

  // "DELTA 12", and perhaps the first numbers.
  std::optional<Error> begin_rule(std::string_view value) {
    const auto words = words_of(value);
    const auto number =
        words.size() > 1 && in_capitals(words[0]) == "DELTA" ? whole_number_in(words[1]) : std::optional<int>{};
    if (!number) {
      return bad_rule(lines_.number(),
                      json::shortened(Json(printable(value))) + " where DELTA and a number are required");
    }
    rule_ = *number;
    rule_line_ = lines_.number();
    const std::string_view rest = value.substr(static_cast<std::size_t>(words[1].end() - value.begin()));
    return read_numbers(rest);
  }

  std::optional<Error> read_numbers(std::string_view text) {
    for (const std::string_view word : words_of(text)) {
      const auto number = number_in(word);
      if (!number || std::abs(*number) > kFarthestMovement) {
        return bad_rule(lines_.number(), json::shortened(Json(printable(word))) +
                                             " where a movement is required, a number of at most 1e5");
      }
      numbers_.push_back(*number);
    }
    return std::nullopt;
  }

  std::optional<Error> finish_rule() {
    if (!rule_) return std::nullopt;
    if (numbers_.size() != 2 * table_.sizes.size()) {
      return bad_rule(rule_line_, "rule " + std::to_string(*rule_) + " has " + std::to_string(numbers_.size()) +
                                      " numbers; for " + std::to_string(table_.sizes.size()) + " sizes " +
                                      std::to_string(2 * table_.sizes.size()) + " are required");
    }
    std::vector<Spot>& movements = table_.movements[*rule_];
    movements.clear();
    for (std::size_t k = 0; k < numbers_.size(); k += 2) movements.push_back({numbers_[k], numbers_[k + 1]});
    numbers_.clear();
    rule_.reset();
    return std::nullopt;
  }

  Lines lines_;
  Encoding encoding_;
  RuleTable table_;
  std::optional<int> rule_;  // the one whose numbers are being read
  std::size_t rule_line_{};
  std::vector<double> numbers_;
};

}  // namespace

Result<RuleTable> read_rule_table(std::string_view text) {
  return TableReader{text}.read();
}

}  // namespace selvage::protocol::trade::rules
