#include "core/nesting/fields/cells.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "core/nesting/depth/lanes.h"

namespace selvage::nesting::fields {
namespace {

constexpr float kHighest = std::numeric_limits<float>::max();

// REQUIRES: `count` is a multiple of kLanes, here and below.
SELVAGE_FOR_EACH_PROCESSOR float lowest_value(const float* values, std::size_t count) {
  depth::Lanes low{};
  low += kHighest;
  for (std::size_t k = 0; k < count; k += depth::kLanes) {
    depth::Lanes next;
    std::memcpy(&next, values + k, sizeof next);
    low = next < low ? next : low;
  }
  return depth::lowest_of(low);
}

// The first of the values from `first` on that equals `wanted`; `count` when none does.
SELVAGE_FOR_EACH_PROCESSOR std::size_t find_value(const float* values, std::size_t first, std::size_t count,
                                                  float wanted) {
  std::size_t k = first;
  for (; k % depth::kLanes != 0; ++k) {
    if (values[k] == wanted) return k;
  }
  for (; k < count; k += depth::kLanes) {
    depth::Lanes next;
    std::memcpy(&next, values + k, sizeof next);
    if (depth::any_of(next == wanted)) break;
  }
  while (k < count && values[k] != wanted) ++k;
  return k;
}

}  // namespace

void Cells::clear(std::size_t columns, std::size_t rows) {
  columns_ = columns;
  rows_ = rows;
  stride_ = (columns + depth::kLanes - 1) / depth::kLanes * depth::kLanes;
  // Blocks are added in vectors that may end up to a vector behind their last cell.
  values_.assign(stride_ * rows + depth::kLanes, 0);
  for (std::size_t k = 0; k < rows; ++k) std::fill(row(k) + columns, row(k) + stride_, kHighest);
}

void Cells::find_lowest_rows(std::size_t wanted, std::vector<LowRow>& lowest) const {
  lowest.clear();
  for (std::size_t k = 0; k < rows_; ++k) {
    const float value = lowest_value(row(k), stride_);
    if (lowest.size() == wanted && !(value < lowest.back().value)) continue;
    if (lowest.size() == wanted) lowest.pop_back();
    std::size_t at = lowest.size();
    lowest.push_back({value, k});
    for (; at > 0 && value < lowest[at - 1].value; --at) lowest[at] = lowest[at - 1];
    lowest[at] = {value, k};
  }
}

Cell Cells::any_with(float value, std::size_t row, layout::Dice& dice) const {
  std::size_t column = find_value(this->row(row), dice.below(columns_), stride_, value);
  if (column == stride_) column = find_value(this->row(row), 0, stride_, value);
  return {column, row};
}

}  // namespace selvage::nesting::fields
