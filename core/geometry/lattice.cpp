#include "core/geometry/lattice.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace selvage::geometry {
namespace {

constexpr double kFinestWidth =
    1 << 28;  // the least width of a strip in lattice units, where the lattice limit allows it

double power_of_ten(int exponent) {
  static constexpr std::array<double, 23> kPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                  1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                  1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  return kPowers[static_cast<std::size_t>(exponent)];
}

// value / 10^exponent, correctly rounded.
double in_units(double value, Resolution resolution) {
  return resolution.exponent <= 0 ? value * power_of_ten(-resolution.exponent)
                                  : value / power_of_ten(resolution.exponent);
}

}  // namespace

Box box_of(std::span<const Vec> points) {
  Box box{points.front(), points.front()};
  for (const Vec p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

bool segments_meet(Vec a, Vec b, Vec c, Vec d) {
  if (!box_of(std::array{a, b}).touches(box_of(std::array{c, d}))) return false;
  return side_of(a, b, c) * side_of(a, b, d) <= 0 && side_of(c, d, a) * side_of(c, d, b) <= 0;
}

int decimals_of(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific).ptr;
  const std::string_view shortest{text.data(), static_cast<std::size_t>(end - text.data())};
  const std::size_t e = shortest.find('e');
  const std::size_t dot = shortest.find('.');
  const int digits = dot == std::string_view::npos ? 0 : static_cast<int>(e - dot) - 1;
  int exponent = 0;
  const std::size_t sign = shortest[e + 1] == '+' ? 2 : 1;
  std::from_chars(shortest.data() + e + sign, shortest.data() + shortest.size(), exponent);
  return std::max(0, digits - exponent);
}

Resolution choose_resolution(int decimals, double extent, double width) {
  const auto first_that_fits = [](int exponent, double far) {
    Resolution resolution{std::clamp(exponent, kFinestExponent, kCoarsestExponent)};
    while (resolution.exponent < kCoarsestExponent && !fits_lattice(far, resolution)) ++resolution.exponent;
    return resolution;
  };
  int wanted = decimals;
  if (width > 0) wanted = std::max(wanted, static_cast<int>(std::ceil(std::log10(kFinestWidth / width))));
  const Resolution roomy = first_that_fits(-wanted, kHeadroom * extent);
  const Resolution exact = first_that_fits(-decimals, extent);
  const bool is_exact = exact.exponent <= -decimals;
  return is_exact || !fits_lattice(kHeadroom * extent, roomy) ? std::min(roomy, exact) : roomy;
}

Coord to_lattice(double value, Resolution resolution) {
  return static_cast<Coord>(std::llround(in_units(value, resolution)));
}

bool fits_lattice(double value, Resolution resolution) {
  return std::abs(in_units(value, resolution)) < static_cast<double>(kLatticeLimit);
}

double to_decimal(Coord coord, Resolution resolution) {
  const auto exact = static_cast<double>(coord);
  return resolution.exponent <= 0 ? exact / power_of_ten(-resolution.exponent)
                                  : exact * power_of_ten(resolution.exponent);
}

}  // namespace selvage::geometry
