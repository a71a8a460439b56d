#include "clients/cli/terminal/style.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace selvage::cli::terminal {

Style::Style(int descriptor) {
  const char* const refused = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  const bool dumb = terminal == nullptr || std::string_view{terminal} == "dumb";
  coloured_ = isatty(descriptor) != 0 && !dumb && (refused == nullptr || *refused == '\0');
}

std::string Style::in(std::string_view colour, std::string_view text) const {
  if (!coloured_) return std::string{text};
  return std::string{colour} + std::string{text} + "\033[0m";
}

std::string rounded(double value, int decimals) {
  char text[400];  // a double has up to 309 digits before the point
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string length_text(double value) {
  constexpr int kDigits = 7;
  const int before_point = value == 0 ? 1 : static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  std::string text = rounded(value, std::clamp(kDigits - before_point, 0, kDigits - 1));
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string change_text(double before, double after) {
  return rounded(100 * (after / before - 1), 3) + " %";
}

}  // namespace selvage::cli::terminal
