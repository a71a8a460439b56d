// The instructions of an HP-GL or HP-GL/2 file: two letters, then numbers or a text.
//
// Numbers may be separated by commas, blanks or nothing but a sign, and instructions by semicolons, blanks or nothing,
// since letters begin the next one.  Escape sequences for the plotter and PJL commands for the printer are skipped.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace selvage::protocol::trade::hpgl {

struct Instruction {
  std::string name;             // two capitals
  std::vector<double> numbers;  // at most 1e9 in either direction
  std::string_view text;        // of a label, a comment or an encoded polyline
  bool ended{true};             // the text has the mark that ends it
  std::size_t line{};           // 1 is the first
};

class Instructions {
 public:
  explicit Instructions(std::string_view text) : text_{text} {}
  [[nodiscard]] std::optional<Instruction> next();

 private:
  void skip_escape();
  void read_parameters(Instruction& read);
  void read_label(Instruction& read);
  void read_up_to(char end, Instruction& read);
  void read_numbers(std::vector<double>& numbers);
  [[nodiscard]] std::size_t line();

  static constexpr char kEndOfText = '\x03';

  std::string_view text_;
  std::size_t at_{}, counted_{}, line_{1};  // lines are counted up to `counted_`
  char end_of_label_{kEndOfText};
  bool labels_end_{true};  // false: no end of a label follows in the rest of the file
};

// Whether the text begins like a plot: with an instruction that sets one up, after escape sequences for the plotter.
[[nodiscard]] bool looks_like_hpgl(std::string_view text);

}  // namespace selvage::protocol::trade::hpgl
