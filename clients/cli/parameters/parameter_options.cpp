#include "clients/cli/parameters/parameter_options.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "protocol/json/fields.h"
#include "protocol/json/json_text.h"

namespace selvage::cli::parameters {
namespace {

using command_line::Kind;
using command_line::Option;
using command_line::Value;
using protocol::schema::FieldDescription;
using protocol::schema::Type;

// Options that differ from their parameters in name, unit or meaning.
struct Exception {
  std::string_view method, parameter, option;
  double divisor{1};
  std::string_view meaning{};  // empty: the meaning of the parameter
};
constexpr Exception kExceptions[] = {
    {"motion.separate", "grow", "--grow", 100, "How much longer the marker may become, in per cent"},
    {"marker.nest", "seconds", "--time"},
    {"marker.nest", "accuracy", "--accuracy", 1,
     "A budget in seconds by name: draft is 2 seconds, standard 20, fine 120; not together with --time"},
    {"plan.cut", "overCut", "--over-cut", 100,
     "How many garments of a colour and size may be cut beyond those ordered, in per cent of these"},
    {"plan.cut", "underCut", "--under-cut", 100, "How many garments fewer than ordered may be cut, in per cent"},
    {"plan.cut", "gap", "--gap", 100, "The search ends when the cost exceeds the bound by at most this many per cent"},
};

const Exception* exception_of(std::string_view method, std::string_view parameter) {
  const auto* const found = std::find_if(std::begin(kExceptions), std::end(kExceptions), [&](const Exception& one) {
    return one.method == method && one.parameter == parameter;
  });
  return found == std::end(kExceptions) ? nullptr : found;
}

// Resolves a type that is only another name for a type.
Type resolved(const Type& type) {
  if (type.kind != Type::Kind::kNamed || !type.component().same_as) return type;
  return resolved(*type.component().same_as);
}

bool may_be_text(const Type& type) {
  if (type.kind == Type::Kind::kEither) return std::any_of(type.parts.begin(), type.parts.end(), &may_be_text);
  return type.kind == Type::Kind::kString || !words_of(type).empty();
}

// The kind of an option of this type; none if the option takes JSON.
std::optional<Kind> kind_of(const Type& type) {
  switch (type.kind) {
    case Type::Kind::kBoolean: return Kind::kFlag;
    case Type::Kind::kInteger: return Kind::kInteger;
    case Type::Kind::kNumber: return Kind::kNumber;
    case Type::Kind::kPair:
      if (type.parts[0].kind == Type::Kind::kNumber) return Kind::kNumbers;
      return std::nullopt;
    default: break;
  }
  if (may_be_text(type)) return Kind::kText;
  return std::nullopt;
}

// The value that the option has when the parameter is absent.
std::optional<Value> standard_value(const Json& fallback, Kind kind, double divisor) {
  if (kind == Kind::kText && fallback.is_string()) return fallback.get<std::string>();
  if (kind == Kind::kInteger && fallback.is_number()) return fallback.get<std::int64_t>();
  if (kind == Kind::kNumber && fallback.is_number()) return fallback.get<double>() * divisor;
  return std::nullopt;
}

// Flags switch a parameter from its default to the other value.
bool is_switched_off(const FieldDescription& parameter) {
  return parameter.fallback == Json(true);
}

bool is_capital(char c) {
  return c >= 'A' && c <= 'Z';
}
bool is_letter(char c) {
  return is_capital(c) || (c >= 'a' && c <= 'z');
}

// Replaces the names of parameters in the text, such as overCut, by those of their options.
std::string with_option_names(std::string_view text) {
  std::string named;
  while (!text.empty()) {
    const auto end = std::find_if_not(text.begin(), text.end(), &is_letter);
    const std::string_view word = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    const bool parameter =
        !word.empty() && !is_capital(word.front()) && std::any_of(word.begin(), word.end(), &is_capital);
    named += parameter ? option_name(word) : std::string{word};
    text.remove_prefix(word.size());
    if (text.empty()) break;
    named += text.front();
    text.remove_prefix(1);
  }
  return named;
}

// The meaning of a parameter, worded for its option: for a flag, what giving it does; other parameters are called by
// the names of their options.
std::string meaning_on_command_line(const FieldDescription& parameter, bool flag) {
  std::string text = without_full_stop(parameter.meaning);
  const bool off = is_switched_off(parameter);
  for (const std::string_view beginning : {off ? "False: " : "True: ", "Whether "}) {
    if (!flag || !text.starts_with(beginning) || (off && beginning == "Whether ")) continue;
    text.erase(0, beginning.size());
    for (const std::string_view otherwise : {"; false: ", ". False: "}) {
      text.erase(std::min(text.find(otherwise), text.size()));
    }
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    break;
  }
  return with_option_names(text);
}

ParameterOption option_of(std::string_view method, const FieldDescription& parameter) {
  const Exception* const exception = exception_of(method, parameter.name);
  const Type type = resolved(parameter.type);
  const std::optional<Kind> kind = kind_of(type);
  const double divisor = exception != nullptr ? exception->divisor : 1;
  Option option;
  const bool flag = kind == Kind::kFlag;
  option.name = exception != nullptr ? std::string{exception->option} : option_name(parameter.name);
  if (flag && is_switched_off(parameter)) option.name.insert(2, "no-");
  option.kind = kind.value_or(Kind::kText);
  const bool own_meaning = exception != nullptr && !exception->meaning.empty();
  option.meaning = own_meaning ? std::string{exception->meaning} : meaning_on_command_line(parameter, flag);
  option.required = parameter.required;
  if (!kind) option.placeholder = "JSON";
  if (kind) option.standard = standard_value(parameter.fallback, *kind, divisor);
  if (const auto& range = parameter.limits.range; range && (kind == Kind::kInteger || kind == Kind::kNumber))
    option.range = command_line::Range{range->least * divisor, range->most * divisor};
  for (const std::string_view word : words_of(type)) option.choices.emplace_back(word);
  if (kind == Kind::kNumbers) {
    option.count = 2;
    option.placeholder = "X,Y";
  }
  if (option.name == "--time") option.placeholder = "SECONDS";
  return {parameter, std::move(option), divisor};
}

Result<Json> parameter_value(const ParameterOption& option, const Value& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return Json(*flag != is_switched_off(option.parameter));
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return Json(*integer);
  if (const auto* number = std::get_if<double>(&value)) return Json(*number / option.divisor);
  if (const auto* text = std::get_if<std::string>(&value)) {
    if (kind_of(resolved(option.parameter.type))) return Json(*text);
    auto parsed = protocol::json::parse(*text);
    return parsed ? parsed : protocol::json::within("/" + std::string{option.parameter.name}, parsed.error());
  }
  Json list = Json::array();
  for (const double number : std::get<std::vector<double>>(value)) list.push_back(number);
  return list;
}

}  // namespace

std::string option_name(std::string_view parameter) {
  std::string name = "--";
  for (const char c : parameter) {
    if (is_capital(c)) name += '-';
    name += is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return name;
}

std::string without_full_stop(std::string_view text) {
  if (text.ends_with('.')) text.remove_suffix(1);
  return std::string{text};
}

std::vector<ParameterOption> parameter_options(const protocol::calls::Method& method) {
  std::vector<ParameterOption> options;
  for (const FieldDescription& parameter : method.params()) {
    if (parameter.group != protocol::calls::CommonParams::kGroup) options.push_back(option_of(method.name, parameter));
  }
  return options;
}

std::vector<ParameterOption> field_options(const std::vector<FieldDescription>& fields) {
  std::vector<ParameterOption> options;
  for (const FieldDescription& field : fields) options.push_back(option_of("", field));
  return options;
}

Result<Json> params_from(const std::vector<ParameterOption>& options, const command_line::Values& values) {
  Json params = Json::object();
  for (const ParameterOption& option : options) {
    const Value* const value = values.find(key_of(option.option));
    if (value == nullptr) continue;
    auto read = parameter_value(option, *value);
    if (!read) return read.error();
    params[std::string{option.parameter.name}] = *std::move(read);
  }
  return params;
}

}  // namespace selvage::cli::parameters
