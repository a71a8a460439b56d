// Options of the command line as plain values: their names, types and limits, and what --help prints about them.
// parse.h parses a command line according to such options; nothing here depends on the parsing library.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace selvage::cli::command_line {

enum class Kind {
  kFlag,     // present or absent, without a value
  kText,     // std::string
  kInteger,  // std::int64_t
  kNumber,   // double
  kNumbers,  // std::vector<double>: `count` numbers separated by commas
  kTexts,    // std::vector<std::string>: any number of texts, for a positional argument
};

// The option's kind determines the alternative; a flag is a bool.
using Value = std::variant<bool, std::string, std::int64_t, double, std::vector<double>, std::vector<std::string>>;

// Inclusive on both sides.
struct Range {
  double least{}, most{};
};

struct Option {
  std::string name;  // "--rounds", "-o,--out", or "IN" for a positional argument
  Kind kind{};
  std::string meaning;  // one line of --help
  bool required{};
  std::optional<Value> standard{};     // the default value, if there is one
  std::optional<Range> range{};        // for an integer or a number
  std::vector<std::string> choices{};  // for a text; empty: any text
  int count{1};                        // for kNumbers: how many numbers
  std::string placeholder{};           // stands for the value in --help; empty: INT, FLOAT or TEXT
};

// The name under which values.h keeps the value: "rounds", "out", "IN".
[[nodiscard]] std::string key_of(const Option& option);

}  // namespace selvage::cli::command_line
