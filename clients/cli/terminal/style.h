// Formats text for people.  It is coloured on a terminal, unless NO_COLOR is set (https://no-color.org) or the terminal
// cannot show colours.  Numbers are rounded to their significant digits; files and --json keep every digit.
#pragma once

#include <string>
#include <string_view>

namespace selvage::cli::terminal {

class Style {
 public:
  // Without colour.
  Style() = default;
  // Decides by the file descriptor and the environment.
  explicit Style(int descriptor);

  [[nodiscard]] std::string good(std::string_view text) const { return in("\033[32m", text); }
  [[nodiscard]] std::string bad(std::string_view text) const { return in("\033[1;31m", text); }
  [[nodiscard]] std::string strong(std::string_view text) const { return in("\033[1m", text); }
  [[nodiscard]] std::string faint(std::string_view text) const { return in("\033[2m", text); }

 private:
  [[nodiscard]] std::string in(std::string_view colour, std::string_view text) const;

  bool coloured_{};
};

// The number with this many decimals.
[[nodiscard]] std::string rounded(double value, int decimals);
// A length or a coordinate with seven digits, without trailing zeros.
[[nodiscard]] std::string length_text(double value);
// The relative change, as in "-0.873 %".  REQUIRES: before > 0.
[[nodiscard]] std::string change_text(double before, double after);

}  // namespace selvage::cli::terminal
