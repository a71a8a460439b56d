#include "core/planning/orders/length_estimate.h"

#include <algorithm>
#include <cmath>

namespace selvage::planning::orders {
namespace {

// The first guess, and how sure it is: standard deviations.  Small nested markers of trousers, jeans and shirts use 80
// to 88 % of the cloth; the ends of a marker take 2 to 8 % of the width (docs/cut-planning.md).
constexpr double kSlope = 1.14, kSlopeDeviation = 0.06;
constexpr double kEnds = 0.05, kEndsDeviation = 0.08;  // parts of the width
// Markers of the same area differ by this part of their length; those of similar garments by more.
constexpr double kScatter = 0.01, kStoredScatter = 0.03;

// The normal equations of least squares: for the differences of the slope and of the ends from the guess.
struct Equations {
  double aa{}, ab{}, bb{}, ra{}, rb{};
};
void add(Equations& sums, std::span<const MadeLength> markers, double scatter, double width) {
  for (const MadeLength& one : markers) {
    const double x = one.area / width;
    const double weight = 1 / (scatter * one.length * scatter * one.length);
    const double residual = one.length - (kSlope * x + kEnds * width);
    sums.aa += weight * x * x;
    sums.ab += weight * x;
    sums.bb += weight;
    sums.ra += weight * x * residual;
    sums.rb += weight * residual;
  }
}

}  // namespace

LengthEstimate::LengthEstimate(double width) : LengthEstimate{width, {}} {}

// Each marker weighs by its scatter, the guess by its deviations, which make the equations regular.
LengthEstimate::LengthEstimate(double width, std::span<const MadeLength> made, std::span<const MadeLength> stored)
    : width_{width} {
  Equations sums{.aa = 1 / (kSlopeDeviation * kSlopeDeviation),
                 .bb = 1 / (kEndsDeviation * width * kEndsDeviation * width)};
  add(sums, made, kScatter, width);
  add(sums, stored, kStoredScatter, width);
  const double determinant = sums.aa * sums.bb - sums.ab * sums.ab;
  slope_ = std::max(1.0, kSlope + (sums.ra * sums.bb - sums.rb * sums.ab) / determinant);
  intercept_ = std::max(0.0, kEnds * width + (sums.rb * sums.aa - sums.ra * sums.ab) / determinant);
  slope_variance_ = sums.bb / determinant;
  covariance_ = -sums.ab / determinant;
  intercept_variance_ = sums.aa / determinant;
}

// That of the fitted line at this length, and the scatter of single markers around it.
double LengthEstimate::deviation_at(double length) const {
  const double x = std::max(0.0, (length - intercept_) / slope_);
  const double of_line = x * x * slope_variance_ + 2 * x * covariance_ + intercept_variance_;
  const double scatter = kScatter * length;
  return std::sqrt(std::max(0.0, of_line) + scatter * scatter);
}

}  // namespace selvage::planning::orders
