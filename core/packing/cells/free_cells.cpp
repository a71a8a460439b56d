#include "core/packing/cells/free_cells.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

namespace selvage::packing::cells {
namespace {

constexpr double kAround = 8;  // lattice units around an excluded cell that lie in the ring, too

std::uint64_t bits(std::size_t first, std::size_t last) {
  return (~std::uint64_t{0} << first) & (~std::uint64_t{0} >> (63 - last));
}

// What the border of a ring does in a row of cells.
struct Row {
  std::uint64_t touched{};        // the cells that it comes near
  std::vector<double> crossings;  // with the row's middle
};

// Where an edge, from its lower to its upper end, lies between two heights; nothing when it does not.
struct Span {
  double least{}, most{};
};
std::optional<Span> span_between(RealVec low, RealVec high, double from, double to) {
  if (to < low.y || from > high.y) return std::nullopt;
  if (low.y == high.y) return Span{std::min(low.x, high.x), std::max(low.x, high.x)};
  const double slope = (high.x - low.x) / (high.y - low.y);
  const double a = low.x + (std::max(from, low.y) - low.y) * slope;
  const double b = low.x + (std::min(to, high.y) - low.y) * slope;
  return Span{std::min(a, b), std::max(a, b)};
}

}  // namespace

FreeCells::FreeCells(const RealBox& range)
    : range_{range}, width_{std::max(range.width(), 1.0) / kCount}, height_{std::max(range.height(), 1.0) / kCount} {
  rows_.fill(~std::uint64_t{0});
}

std::size_t FreeCells::at(double value, double low, double size) {
  return static_cast<std::size_t>(std::clamp((value - low) / size, 0.0, static_cast<double>(kCount - 1)));
}

void FreeCells::exclude(const WedgeRing& ring) {
  std::array<Row, kCount> rows;
  for (std::uint32_t k = 0; k < ring.size(); ++k) {
    const auto [low, high] =
        std::minmax({ring.corner(k), ring.corner(ring.next(k))}, [](RealVec a, RealVec b) { return a.y < b.y; });
    const std::size_t last = row_of(high.y + 2 * kAround);
    for (std::size_t row = row_of(low.y - 2 * kAround); row <= last; ++row) {
      const double from = range_.low_y + static_cast<double>(row) * height_;
      const double middle = from + height_ / 2;
      if (low.y <= middle && middle < high.y) {
        rows[row].crossings.push_back(span_between(low, high, middle, middle)->least);
      }
      const auto near = span_between(low, high, from - kAround, from + height_ + kAround);
      if (!near || near->most + kAround < range_.low_x || near->least - kAround > range_.high_x) continue;
      rows[row].touched |= bits(column_of(near->least - kAround), column_of(near->most + kAround));
    }
  }
  for (std::size_t row = 0; row < kCount; ++row) {
    std::vector<double>& crossings = rows[row].crossings;
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      if (crossings[k + 1] < range_.low_x || crossings[k] > range_.high_x) continue;
      rows_[row] &= ~bits(column_of(crossings[k]), column_of(crossings[k + 1])) | rows[row].touched;
    }
  }
}

std::optional<RealBox> FreeCells::within(const RealBox& box) const {
  constexpr double kUnit = 1;  // more than the borders of cells are rounded by
  const std::uint64_t columns = bits(column_of(box.low_x - kUnit), column_of(box.high_x + kUnit));
  std::size_t first = row_of(box.low_y - kUnit);
  std::size_t last = row_of(box.high_y + kUnit);
  while (first <= last && (rows_[first] & columns) == 0) ++first;
  if (first > last) return std::nullopt;
  while ((rows_[last] & columns) == 0) --last;
  std::uint64_t all = 0;
  for (std::size_t row = first; row <= last; ++row) all |= rows_[row] & columns;
  const auto left = static_cast<double>(std::countr_zero(all));
  const auto right = static_cast<double>(static_cast<int>(kCount) - std::countl_zero(all));
  const auto bottom = static_cast<double>(first);
  const auto top = static_cast<double>(last + 1);
  return RealBox{std::max(box.low_x, std::ceil(range_.low_x + left * width_ - kUnit)),
                 std::max(box.low_y, std::ceil(range_.low_y + bottom * height_ - kUnit)),
                 std::min(box.high_x, std::floor(range_.low_x + right * width_ + kUnit)),
                 std::min(box.high_y, std::floor(range_.low_y + top * height_ + kUnit))};
}

}  // namespace selvage::packing::cells
