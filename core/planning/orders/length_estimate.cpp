#include "core/planning/orders/length_estimate.h"

#include <algorithm>

namespace selvage::planning::orders {
namespace {

// The first guess, and how sure it is: standard deviations.  Small nested markers of trousers, jeans and shirts use 80
// to 88 % of the cloth; the ends of a marker take 2 to 8 % of the width (docs/cut-planning.md).
constexpr double kSlope = 1.14, kSlopeDeviation = 0.06;
constexpr double kEnds = 0.05, kEndsDeviation = 0.08;  // parts of the width
// Markers of the same area differ by this part of their length.
constexpr double kScatter = 0.01;

}  // namespace

LengthEstimate::LengthEstimate(double width) : LengthEstimate{width, {}} {}

// Least squares: each made marker weighs by its scatter, the guess by its deviations.  The normal equations have two
// unknowns; the guess makes them regular.
LengthEstimate::LengthEstimate(double width, std::span<const MadeLength> made)
    : width_{width}, slope_{kSlope}, intercept_{kEnds * width} {
  double aa = 1 / (kSlopeDeviation * kSlopeDeviation), ab = 0;
  double bb = 1 / (kEndsDeviation * width * kEndsDeviation * width);
  double ra = 0, rb = 0;  // of the differences from the guess
  for (const MadeLength& one : made) {
    const double x = one.area / width;
    const double weight = 1 / (kScatter * one.length * kScatter * one.length);
    const double residual = one.length - (kSlope * x + kEnds * width);
    aa += weight * x * x;
    ab += weight * x;
    bb += weight;
    ra += weight * x * residual;
    rb += weight * residual;
  }
  const double determinant = aa * bb - ab * ab;
  slope_ = std::max(1.0, kSlope + (ra * bb - rb * ab) / determinant);
  intercept_ = std::max(0.0, kEnds * width + (rb * aa - ra * ab) / determinant);
}

}  // namespace selvage::planning::orders
