#include "protocol/trade/esicup/esicup_numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/geometry/lattice.h"

namespace selvage::protocol::trade::esicup {
namespace {

constexpr double kTurn = 360;

double with_decimals(double value, int decimals) {
  std::array<char, 512> text{};  // the largest double has 309 digits before the point
  const int kept = std::min(decimals, -geometry::kFinestExponent);
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, kept).ptr;
  double nearest = value;
  std::from_chars(text.data(), end, nearest);
  return nearest == 0 ? 0.0 : nearest;  // no negative zero
}

}  // namespace

double difference(double a, double b) {
  return with_decimals(a - b, std::max(geometry::decimals_of(a), geometry::decimals_of(b)));
}

double reversed_angle(double degrees) {
  const double within_a_turn = with_decimals(std::fmod(degrees, kTurn), geometry::decimals_of(degrees));
  const double reversed = within_a_turn > 0 ? difference(kTurn, within_a_turn) : difference(0, within_a_turn);
  return reversed < kTurn ? reversed : 0;
}

}  // namespace selvage::protocol::trade::esicup
