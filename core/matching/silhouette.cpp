#include "core/matching/silhouette.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "core/outline/outline.h"

namespace selvage::matching {
namespace {

constexpr double kLeast = 1;  // square lattice units: the difference of outlines that are not equal

// The bits of the cells whose middles lie between the crossings of a horizontal line with the outline.
std::uint32_t row_of(const Polygon& outline, const Box& box, double y) {
  std::vector<double> crossings;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec a = outline[k];
    const Vec b = outline[(k + 1) % outline.size()];
    const auto ay = static_cast<double>(a.y);
    const auto by = static_cast<double>(b.y);
    if ((ay <= y) == (by <= y)) continue;
    crossings.push_back(static_cast<double>(a.x) + static_cast<double>(b.x - a.x) * (y - ay) / (by - ay));
  }
  std::sort(crossings.begin(), crossings.end());
  const double cell = static_cast<double>(box.width()) / Silhouette::kSide;
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
    const auto cell_from = [&](double x) {
      const double column = std::ceil((x - static_cast<double>(box.low.x)) / cell - 0.5);
      return static_cast<int>(std::clamp(column, 0.0, double{Silhouette::kSide}));
    };
    for (int column = cell_from(crossings[k]); column < cell_from(crossings[k + 1]); ++column) {
      bits |= std::uint32_t{1} << column;
    }
  }
  return bits;
}

}  // namespace

Silhouette silhouette_of(const Polygon& outline) {
  const Box box = box_of(outline);
  Silhouette silhouette;
  silhouette.width = static_cast<double>(box.width());
  silhouette.height = static_cast<double>(box.height());
  silhouette.area = geometry::area_of(outline);
  for (int row = 0; row < Silhouette::kSide; ++row) {
    const double y = static_cast<double>(box.low.y) + (row + 0.5) * silhouette.height / Silhouette::kSide;
    silhouette.rows[static_cast<std::size_t>(row)] = row_of(outline, box, y);
  }
  silhouette.hash = outline::hash_of(geometry::normal_form(outline, -box.low));
  return silhouette;
}

double estimated_difference(const Silhouette& first, const Silhouette& second) {
  if (first.hash == second.hash) return 0;
  int bits = 0;
  for (std::size_t row = 0; row < first.rows.size(); ++row) {
    bits += std::popcount(first.rows[row] ^ second.rows[row]);
  }
  const double width = (first.width + second.width) / 2;
  const double height = (first.height + second.height) / 2;
  const double within = width * height * bits / (Silhouette::kSide * Silhouette::kSide);
  // The boxes' frame, as far as the outlines fill their boxes.
  const double filled = (first.area + second.area) / (first.width * first.height + second.width * second.height);
  const double frame = std::abs(first.width - second.width) * height + std::abs(first.height - second.height) * width;
  return std::max(kLeast, within + filled * frame);
}

}  // namespace selvage::matching
