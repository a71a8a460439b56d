#include "protocol/trade/rules/rule_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "protocol/json/json_text.h"
#include "protocol/trade/text.h"
#include "protocol/trade/unicode/utf8_text.h"

namespace selvage::protocol::trade::rules {
namespace {

constexpr double kFarthestMovement = 1e5;  // of the table's unit
constexpr std::size_t kMostSizes = 200;

Error bad_rule(std::size_t line, const std::string& what) {
  return {ErrorCode::kSyntax, "line " + std::to_string(line) + " of the rule table: " + what, line_field(line)};
}

constexpr std::string_view kBetweenWords = " \t;()\"";  // "S" and (0.5 0.25) are written, too
constexpr std::string_view kBetweenWordsAndCommas = " \t,;()\"";

// The words of a line, between the separators.
std::vector<std::string_view> words_of(std::string_view line, std::string_view separators = kBetweenWordsAndCommas) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t from = line.find_first_not_of(separators);
    if (from == std::string_view::npos) return words;
    line.remove_prefix(from);
    const std::size_t length = std::min(line.find_first_of(separators), line.size());
    words.push_back(line.substr(0, length));
    line.remove_prefix(length);
  }
}

bool is_comment(std::string_view line) {
  return line.starts_with(';') || line.starts_with('#') || line.starts_with('*') || line.starts_with("//");
}

// A rule as it is written: whether its commas separate numbers is not known before the last one.
struct WrittenRule {
  int number{};
  std::size_t line{};
  std::vector<std::pair<std::string_view, std::size_t>> texts;  // of its numbers, and their lines
};

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
    if (const auto error = read_rules()) return *error;
    if (table_.sizes.empty()) {
      if (lines_.number() == 0) return Error{ErrorCode::kUnknownFormat, "the rule table is empty", ""};
      return Error{ErrorCode::kUnknownFormat, "no grade rule table: there is no SIZE LIST", ""};
    }
    return std::move(table_);
  }

 private:
  using Movements = Result<std::map<int, std::vector<Spot>>>;

  std::optional<Error> read_line(std::string_view text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) {
      if (!rules_.empty()) rules_.back().texts.emplace_back(text, lines_.number());
      return std::nullopt;
    }
    const std::string key = in_capitals(trimmed(text.substr(0, colon)));
    const std::string_view value = trimmed(text.substr(colon + 1));
    if (key == "RULE") return begin_rule(value);
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
    const std::string_view rest = value.substr(static_cast<std::size_t>(words[1].end() - value.begin()));
    rules_.push_back({*number, lines_.number(), {{rest, lines_.number()}}});
    return std::nullopt;
  }

  std::optional<Error> read_rules() {
    std::size_t good = 0, good_with_decimal_commas = 0;
    Movements read = movements(false, good);
    if (!read) {
      Movements with_decimal_commas = movements(true, good_with_decimal_commas);
      if (!with_decimal_commas) return good_with_decimal_commas > good ? with_decimal_commas.error() : read.error();
      read = std::move(with_decimal_commas);
      table_.notes.push_back({"", "the rule table has decimal commas"});
    }
    table_.movements = *std::move(read);
    return std::nullopt;
  }

  // `good` becomes the number of rules before the first mistake.
  [[nodiscard]] Movements movements(bool decimal_commas, std::size_t& good) const {
    std::map<int, std::vector<Spot>> all;
    for (const WrittenRule& rule : rules_) {
      const auto numbers = numbers_of(rule, decimal_commas);
      if (!numbers) return numbers.error();
      if (numbers->size() != 2 * table_.sizes.size()) {
        return bad_rule(rule.line, "rule " + std::to_string(rule.number) + " has " + std::to_string(numbers->size()) +
                                       " numbers; for " + std::to_string(table_.sizes.size()) + " sizes " +
                                       std::to_string(2 * table_.sizes.size()) + " are required");
      }
      std::vector<Spot>& spots = all[rule.number];
      spots.clear();  // of several rules with a number, the last counts
      for (std::size_t k = 0; k < numbers->size(); k += 2) spots.push_back({(*numbers)[k], (*numbers)[k + 1]});
      ++good;
    }
    return all;
  }

  [[nodiscard]] static Result<std::vector<double>> numbers_of(const WrittenRule& rule, bool decimal_commas) {
    std::vector<double> numbers;
    for (const auto& [text, line] : rule.texts) {
      for (const std::string_view word : words_of(text, decimal_commas ? kBetweenWords : kBetweenWordsAndCommas)) {
        std::string written{word};
        if (decimal_commas) std::replace(written.begin(), written.end(), ',', '.');
        const auto number = number_in(written);
        if (!number || std::abs(*number) > kFarthestMovement) {
          return bad_rule(
              line, json::shortened(Json(printable(word))) + " where a movement is required, a number of at most 1e5");
        }
        numbers.push_back(*number);
      }
    }
    return numbers;
  }

  Lines lines_;
  Encoding encoding_;
  RuleTable table_;
  std::vector<WrittenRule> rules_;
};

}  // namespace

Result<RuleTable> read_rule_table(std::string_view text) {
  const auto utf8 = unicode::Utf8Text::of(text);
  if (!utf8) return utf8.error();
  auto table = TableReader{utf8->text()}.read();
  if (table && !utf8->encoding().empty()) {
    table->notes.push_back({"", "the rule table is read as " + std::string{utf8->encoding()}});
  }
  return table;
}

}  // namespace selvage::protocol::trade::rules
