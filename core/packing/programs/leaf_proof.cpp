#include "core/packing/programs/leaf_proof.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace selvage::packing::programs {
namespace {

constexpr double kRounding = 0x1p-44;  // of the sizes of all terms

// The sum of multiples of rows: coefficients of the positions and of the length, and a constant.
class Combination {
 public:
  Combination(std::span<const Dictionary::Multiplier> multipliers, const Ranges& ranges)
      : ranges_{ranges}, factors_(ranges.bodies.size()), sizes_(ranges.bodies.size()) {
    for (const Dictionary::Multiplier& multiplier : multipliers) add(multiplier.row, multiplier.value);
  }

  // The largest value, and the same of the combination minus the length.
  [[nodiscard]] double most() const { return most_with(length_); }
  [[nodiscard]] double most_below_length() const { return most_with(length_ - 1); }
  // Why the largest value is below `limit`; the same of the combination minus the length.
  [[nodiscard]] Reasons why_below(double limit) const { return why_with(length_, limit); }
  [[nodiscard]] Reasons why_below_length(double limit) const { return why_with(length_ - 1, limit); }

 private:
  void add(const Row& row, double times) {
    rows_ |= row.why;
    constant_ -= times * row.plane.c;
    size_ += std::abs(times * row.plane.c);
    if (row.length) {
      length_ += times;
      length_size_ += times;
      add_body(row.second, -times * row.plane.nx, 0);
    } else {
      add_body(row.first, -times * row.plane.nx, -times * row.plane.ny);
      add_body(row.second, times * row.plane.nx, times * row.plane.ny);
    }
  }
  void add_body(std::uint32_t body, double x, double y) {
    if (body == factors_.size()) return;
    factors_[body].x += x;
    factors_[body].y += y;
    sizes_[body].x += std::abs(x);
    sizes_[body].y += std::abs(y);
  }
  // Ranges are widened to what holds unconditionally while the value stays below the limit, the cheapest first.
  [[nodiscard]] Reasons why_with(double length_factor, double limit) const {
    struct Side {
      double loss;
      Reasons why;
    };
    std::vector<Side> sides;
    double wide_size = 0;
    const auto add_side = [&](double factor, double factor_size, double side, double wide, Reasons why) {
      wide_size += (factor_size + std::abs(factor)) * std::abs(wide);
      if (factor != 0 && why != kUnconditional) sides.push_back({factor * (wide - side), why});
    };
    for (std::size_t k = 0; k < ranges_.why.size(); ++k) {
      const auto& [own, wide, why] = std::tie(ranges_.bodies[k], ranges_.wide[k], ranges_.why[k]);
      const bool right = factors_[k].x > 0;
      const bool up = factors_[k].y > 0;
      add_side(factors_[k].x, sizes_[k].x, right ? own.high_x : own.low_x, right ? wide.high_x : wide.low_x,
               right ? why.high_x : why.low_x);
      add_side(factors_[k].y, sizes_[k].y, up ? own.high_y : own.low_y, up ? wide.high_y : wide.low_y,
               up ? why.high_y : why.low_y);
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.loss < b.loss; });
    double spare = limit - most_with(length_factor) - kRounding * wide_size;
    Reasons all = rows_;
    for (const Side& side : sides) {
      spare -= side.loss;
      if (spare <= 0) all |= side.why;
    }
    return all;
  }
  [[nodiscard]] double most_with(double length_factor) const {
    double most = constant_;
    double size = size_;
    const auto include = [&](double factor, double factor_size, double low, double high) {
      most += std::max(factor * low, factor * high);
      size += (factor_size + std::abs(factor)) * std::max(std::abs(low), std::abs(high));
    };
    for (std::size_t k = 0; k < factors_.size(); ++k) {
      const RealBox& box = ranges_.bodies[k];
      include(factors_[k].x, sizes_[k].x, box.low_x, box.high_x);
      include(factors_[k].y, sizes_[k].y, box.low_y, box.high_y);
    }
    include(length_factor, length_size_ + 1, ranges_.low_length, ranges_.high_length);
    return most + kRounding * size;
  }

  const Ranges& ranges_;
  std::vector<RealVec> factors_, sizes_;  // of the bodies' positions; the sums of the sizes of their parts
  double length_{}, length_size_{};
  double constant_{}, size_{};
  Reasons rows_{};
};

}  // namespace

bool refutes(std::span<const Dictionary::Multiplier> multipliers, const Ranges& ranges) {
  return Combination{multipliers, ranges}.most() < 0;
}

double least_length(std::span<const Dictionary::Multiplier> multipliers, const Ranges& ranges) {
  return std::max(ranges.low_length, -Combination{multipliers, ranges}.most_below_length());
}

Reasons why_refuted(std::span<const Dictionary::Multiplier> multipliers, const Ranges& ranges) {
  return Combination{multipliers, ranges}.why_below(0);
}

Reasons why_longer(std::span<const Dictionary::Multiplier> multipliers, const Ranges& ranges, double ceiling) {
  return Combination{multipliers, ranges}.why_below_length(-ceiling);
}

}  // namespace selvage::packing::programs
