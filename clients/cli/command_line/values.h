// The values of the options of a command line, by the options' keys (option.h).
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clients/cli/command_line/option.h"

namespace selvage::cli::command_line {

class Values {
 public:
  void set(std::string key, Value value);

  // Null if the option was not given and has no default value.
  [[nodiscard]] const Value* find(std::string_view key) const;
  [[nodiscard]] bool flag(std::string_view key) const;  // false when absent
  // REQUIRES, for all functions below: the option is of that kind.
  [[nodiscard]] std::string text(std::string_view key) const;                // empty when absent
  [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;  // empty when absent
  [[nodiscard]] std::optional<std::int64_t> integer(std::string_view key) const;
  [[nodiscard]] std::optional<double> number(std::string_view key) const;

 private:
  std::map<std::string, Value, std::less<>> values_;
};

}  // namespace selvage::cli::command_line
