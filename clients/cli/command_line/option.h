// Options of the command line as plain values: what may be given, what it means and what --help prints about it.
// parse.h reads a command line according to such options; nothing here depends on the parsing library.
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
  kTexts,    // std::vector<std::string>: any number of them, of a positional argument
};

// The alternative follows from the option's kind; a flag is a bool.
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
  std::optional<Value> standard{};     // the value of an option that is not given; none: it has no value
  std::optional<Range> range{};        // of an integer or a number
  std::vector<std::string> choices{};  // of a text; empty: any text
  int count{1};                        // how many numbers kNumbers takes
  std::string placeholder{};           // stands for the value in --help; empty: INT, FLOAT or TEXT
};

// The name under which values.h keeps the value: "rounds", "out", "IN".
[[nodiscard]] std::string key_of(const Option& option);

}  // namespace selvage::cli::command_line
