#include "clients/cli/command_line/wording.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace selvage::cli::command_line {
namespace {

std::string choices_of(const Option& option, const std::string& between) {
  std::string choices;
  for (const std::string& choice : option.choices) choices += (choices.empty() ? "" : between) + choice;
  return choices;
}

// Whether there are too many choices to be listed beside the option's name.
bool has_many_choices(const Option& option) {
  constexpr std::size_t kMost = 5;
  return option.choices.size() > kMost;
}

std::string text_of(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
  const auto* const number = std::get_if<double>(&value);
  if (number == nullptr) return {};
  std::array<char, 32> digits{};
  const auto written = std::to_chars(digits.begin(), digits.end(), *number);
  return {digits.begin(), written.ptr};
}

// The default as a text.  It is left out for the number of threads, which depends on the machine.
std::string standard_of(const Option& option) {
  const bool stated = option.meaning.find("when absent") != std::string::npos;
  if (!option.standard || stated || option.name == "--threads") return {};
  const std::string text = text_of(*option.standard);
  return text.empty() ? text : ".  Default: " + text;
}

}  // namespace

bool is_positional(const Option& option) {
  return !option.name.starts_with('-');
}

std::vector<std::string> names_of(const Option& option) {
  std::vector<std::string> names;
  for (std::size_t at = 0; at <= option.name.size();) {
    const std::size_t end = std::min(option.name.find(',', at), option.name.size());
    names.push_back(option.name.substr(at, end - at));
    at = end + 1;
  }
  return names;
}

std::string value_of(const Option& option) {
  if (!option.placeholder.empty()) return option.placeholder;
  if (!option.choices.empty()) return has_many_choices(option) ? "WORD" : choices_of(option, "|");
  switch (option.kind) {
    case Kind::kFlag: return "";
    case Kind::kText: return "TEXT";
    case Kind::kInteger: return "INTEGER";
    case Kind::kNumber: return "NUMBER";
    case Kind::kNumbers: return "NUMBER,...";
    case Kind::kTexts: return "TEXT...";
  }
  return "";
}

std::string meaning_of(const Option& option) {
  const bool listed = has_many_choices(option) || (is_positional(option) && !option.choices.empty());
  return option.meaning + (listed ? ".  One of " + choices_of(option, ", ") : "") + standard_of(option);
}

}  // namespace selvage::cli::command_line
