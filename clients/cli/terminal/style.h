// Text for people.  Colour: on a terminal, unless NO_COLOR is set (https://no-color.org) or the terminal is a dumb one.
// Numbers: rounded to what they mean; files and --json keep every digit.
#pragma once

#include <string>
#include <string_view>

namespace selvage::cli::terminal {

class Style {
 public:
  // Without colour.
  Style() = default;
  // As the file descriptor and the environment have it.
  explicit Style(int descriptor);

  [[nodiscard]] std::string good(std::string_view text) const { return in("\033[32m", text); }
  [[nodiscard]] std::string bad(std::string_view text) const { return in("\033[1;31m", text); }
  [[nodiscard]] std::string strong(std::string_view text) const { return in("\033[1m", text); }
  [[nodiscard]] std::string faint(std::string_view text) const { return in("\033[2m", text); }

 private:
  [[nodiscard]] std::string in(std::string_view colour, std::string_view text) const;

  bool coloured_{};
};

// With this number of decimals.
[[nodiscard]] std::string rounded(double value, int decimals);
// A length or a coordinate: seven digits, fewer when the rest are zeros.
[[nodiscard]] std::string length_text(double value);
// How much longer, as in "-0.873 %".  REQUIRES: before > 0.
[[nodiscard]] std::string change_text(double before, double after);

}  // namespace selvage::cli::terminal
