#include "core/matching/signature.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace selvage::matching {
namespace {

constexpr double kCountWeight = 0.2;   // of a number of pieces that is off, relative to the spreads' differences
constexpr double kHalfPenalty = 0.02;  // of a marker that is a part: whole ones come first

void add_quantiles(std::vector<double> values, std::size_t slot, Signature& signature) {
  std::sort(values.begin(), values.end());
  for (std::size_t k = 0; k < Signature::kQuantiles; ++k) {
    const double at = static_cast<double>(k) / (Signature::kQuantiles - 1) * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    const double part = at - static_cast<double>(below);
    const double value = values[below] + part * (values[above] - values[below]);
    signature.spread[slot * Signature::kQuantiles + k] = static_cast<float>(value);
  }
}

}  // namespace

Signature signature_of(const Marker& marker) {
  Signature signature;
  signature.unit = marker.unit;
  signature.width = to_decimal(marker.strip.width, marker.resolution);
  signature.spacing = to_decimal(marker.spacing, marker.resolution);
  const auto width = static_cast<double>(marker.strip.width);
  std::vector<double> areas;
  std::vector<double> longer;
  std::vector<double> shorter;
  const auto add = [&](const Piece& piece) {
    const Polygon& outline = marker.shapes[piece.shape.value].outline;
    const Box box = box_of(outline);
    const double area = geometry::area_of(outline) / width / width;
    signature.area += area;
    areas.push_back(std::sqrt(area));
    longer.push_back(static_cast<double>(std::max(box.width(), box.height())) / width);
    shorter.push_back(static_cast<double>(std::min(box.width(), box.height())) / width);
  };
  for (const Piece& piece : marker.pieces) add(piece);
  for (const Piece& piece : marker.unplaced) add(piece);
  signature.pieces = static_cast<double>(areas.size());
  add_quantiles(std::move(areas), 0, signature);
  add_quantiles(std::move(longer), 1, signature);
  add_quantiles(std::move(shorter), 2, signature);
  return signature;
}

double distance_between(const Signature& order, const Signature& stored) {
  if (order.unit != stored.unit || std::abs(order.width - stored.width) > kWidthSlack * order.width ||
      std::abs(order.spacing - stored.spacing) > kSpacingSlack * order.width) {
    return std::numeric_limits<double>::infinity();
  }
  const auto off = [&](double times) {
    return std::abs(1 - times * stored.pieces / order.pieces) + std::abs(1 - times * stored.area / order.area);
  };
  return spread_between(order, stored) + kCountWeight * std::min(off(1), kHalfPenalty + off(2));
}

double spread_between(const Signature& a, const Signature& b) {
  double spread = 0;
  for (std::size_t k = 0; k < a.spread.size(); ++k)
    spread += std::abs(static_cast<double>(a.spread[k]) - static_cast<double>(b.spread[k]));
  return spread;
}

std::vector<std::size_t> nearest(const Signature& order, std::span<const Signature> stored, std::size_t count) {
  std::vector<std::pair<double, std::size_t>> found;
  for (std::size_t k = 0; k < stored.size(); ++k) {
    const double distance = distance_between(order, stored[k]);
    if (std::isfinite(distance)) found.emplace_back(distance, k);
  }
  const std::size_t kept = std::min(count, found.size());
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(kept), found.end());
  std::vector<std::size_t> indices;
  for (std::size_t k = 0; k < kept; ++k) indices.push_back(found[k].second);
  return indices;
}

}  // namespace selvage::matching
