#include "clients/cli/command_line/values.h"

#include <utility>

namespace selvage::cli::command_line {

std::string key_of(const Option& option) {
  const std::size_t dashes = option.name.rfind("--");
  return dashes == std::string::npos ? option.name : option.name.substr(dashes + 2);
}

void Values::set(std::string key, Value value) {
  values_.insert_or_assign(std::move(key), std::move(value));
}

const Value* Values::find(std::string_view key) const {
  const auto found = values_.find(key);
  return found == values_.end() ? nullptr : &found->second;
}

bool Values::flag(std::string_view key) const {
  const Value* const value = find(key);
  return value != nullptr && std::get<bool>(*value);
}

std::string Values::text(std::string_view key) const {
  const Value* const value = find(key);
  return value == nullptr ? std::string{} : std::get<std::string>(*value);
}

std::vector<std::string> Values::texts(std::string_view key) const {
  const Value* const value = find(key);
  return value == nullptr ? std::vector<std::string>{} : std::get<std::vector<std::string>>(*value);
}

std::optional<std::int64_t> Values::integer(std::string_view key) const {
  const Value* const value = find(key);
  if (value == nullptr) return std::nullopt;
  return std::get<std::int64_t>(*value);
}

std::optional<double> Values::number(std::string_view key) const {
  const Value* const value = find(key);
  if (value == nullptr) return std::nullopt;
  return std::get<double>(*value);
}

}  // namespace selvage::cli::command_line
