#include "core/nesting/local_search/field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/nesting/depth/lanes.h"

namespace selvage::nesting::local_search {
namespace {

constexpr float kRuledOut = std::numeric_limits<float>::max();  // of cells without an allowed position

SELVAGE_FOR_EACH_PROCESSOR float lowest_value(const float* values, std::size_t count) {
  depth::Lanes low{};
  low += std::numeric_limits<float>::max();
  std::size_t k = 0;
  for (; k + depth::kLanes <= count; k += depth::kLanes) {
    depth::Lanes next;
    std::memcpy(&next, values + k, sizeof next);
    low = next < low ? next : low;
  }
  float lowest = depth::lowest_of(low);
  for (; k < count; ++k) lowest = std::min(lowest, values[k]);
  return lowest;
}

// The first of the values from `first` on that equals `wanted`; `count` when none does.
SELVAGE_FOR_EACH_PROCESSOR std::size_t find_value(const float* values, std::size_t first, std::size_t count,
                                                  float wanted) {
  std::size_t k = first;
  for (; k + depth::kLanes <= count; k += depth::kLanes) {
    depth::Lanes next;
    std::memcpy(&next, values + k, sizeof next);
    if (depth::any_of(next == wanted)) break;
  }
  while (k < count && values[k] != wanted) ++k;
  return k;
}

// std::lround without a call.
int nearest_integer(double value) {
  return static_cast<int>(value + (value < 0 ? -0.5 : 0.5));
}

// How one axis of the field runs through an axis of the grid: field cell k reads grid cell first + sign * k.
struct Overlap1D {
  int begin{}, end{};  // field cells that lie within the grid
  int grid{};          // the grid cell that `begin` reads
};
Overlap1D overlap_of(double offset, float sign, int grid_first, int grid_cells, int field_cells) {
  const int first = nearest_integer(sign * offset) - grid_first;
  if (sign > 0) {
    const int begin = std::max(0, -first);
    return {begin, std::min(field_cells, grid_cells - first), first + begin};
  }
  const int begin = std::max(0, first - grid_cells + 1);
  return {begin, std::min(field_cells, first + 1), first - begin};
}

}  // namespace

bool Field::compute(const layout::Layout& layout, std::size_t piece, std::uint32_t turn,
                    const std::vector<std::uint32_t>& others, const Losses& losses, FieldWeights weights,
                    double reach) {
  room_ = inner_fit(*set_, layout, piece, turn);
  if (room_.high_x < room_.low_x || room_.high_y < room_.low_y) return false;
  const double x = std::max(room_.low_x, std::min(layout.places[piece].x, room_.high_x));
  room_.low_x = std::max(room_.low_x, x - reach);
  room_.high_x = std::min(room_.high_x, x + reach);
  turn_ = turn;
  // The last column and the last row lie on the edge of the room.
  const float pixel = maps_->scale().pixel;
  columns_ = static_cast<std::size_t>(room_.width() / pixel) + 2;
  rows_ = static_cast<std::size_t>(room_.height() / pixel) + 2;
  values_.assign(columns_ * rows_ + depth::kLanes, 0);
  find_readings(layout, piece, others, losses, weights);
  blocks_.clear();
  for (const Reading& reading : readings_) append_block(reading);
  depth::add_blocks(blocks_);
  piece_ = piece;
  if (set_->kind(piece).matched) leave_out_unmatched();
  return true;
}

bool Field::reaches(const layout::Turned& own, const layout::Turned& theirs, const layout::Place& at) const {
  const double apart =
      std::max(0.0, set_->clearance(own.outline, theirs.outline)) + 2.0 * static_cast<double>(maps_->scale().pixel);
  return room_.low_x + own.box.low_x < at.x + theirs.box.high_x + apart &&
         room_.high_x + own.box.high_x > at.x + theirs.box.low_x - apart;
}

void Field::leave_out_unmatched() {
  const double pixel = maps_->scale().pixel;
  const auto x_at = [&](std::size_t column) { return room_.low_x + static_cast<double>(column) * pixel; };
  const auto y_at = [&](std::size_t row) { return room_.low_y + static_cast<double>(row) * pixel; };
  const auto holds = [pixel](double low, double high, double at) {
    return low < high || (low == high && std::abs(low - at) <= pixel / 2);
  };
  std::vector<bool> matched(columns_);  // by column
  for (std::size_t column = 0; column < columns_; ++column) {
    const layout::RealBox fit = matched_fit(*set_, piece_, turn_, room_, x_at(column), room_.low_y);
    matched[column] = holds(fit.low_x, fit.high_x, x_at(column));
  }
  for (std::size_t row = 0; row < rows_; ++row) {
    const layout::RealBox fit = matched_fit(*set_, piece_, turn_, room_, room_.low_x, y_at(row));
    const bool in_row = holds(fit.low_y, fit.high_y, y_at(row));
    for (std::size_t column = 0; column < columns_; ++column) {
      if (!in_row || !matched[column]) values_[row * columns_ + column] = kRuledOut;
    }
  }
}

// Maps are looked up together, and read after that, because each look-up waits for memory.
void Field::find_readings(const layout::Layout& layout, std::size_t piece, const std::vector<std::uint32_t>& others,
                          const Losses& losses, FieldWeights weights) {
  readings_.clear();
  const layout::Turned& own = set_->kind(piece).turned[turn_];
  for (const std::uint32_t other : others) {
    if (other == piece) continue;
    const layout::Place& place = layout.places[other];
    const layout::Turned& theirs = set_->kind(other).turned[place.turn];
    if (!reaches(own, theirs, place)) continue;
    const float weight =
        weights == FieldWeights::kEqual ? 1 : losses.weight(piece, other) * losses.importance(piece, other);
    readings_.push_back({maps_->view(theirs, own), place.x, place.y, weight});
    __builtin_prefetch(readings_.back().view.map);
  }
}

void Field::append_block(const Reading& reading) {
  const depth::MapFrame& frame = reading.view.frame;
  depth::DepthMap& map = *reading.view.map;
  const depth::DepthMap::Overlaps& grid = frame.exchanged ? map.transposed_overlaps() : map.overlaps();
  const float sign_x = frame.exchanged ? frame.sign_y : frame.sign_x;
  const float sign_y = frame.exchanged ? frame.sign_x : frame.sign_y;
  const double pixels = 1 / static_cast<double>(maps_->scale().pixel);
  const Overlap1D across = overlap_of((room_.low_x - reading.x) * pixels, sign_x, grid.first_column, grid.columns,
                                      static_cast<int>(columns_));
  const Overlap1D up =
      overlap_of((room_.low_y - reading.y) * pixels, sign_y, grid.first_row, grid.rows, static_cast<int>(rows_));
  if (across.begin >= across.end || up.begin >= up.end) return;
  blocks_.push_back(
      {.to = values_.data() + static_cast<std::size_t>(up.begin) * columns_ + static_cast<std::size_t>(across.begin),
       .from = grid.samples + static_cast<std::ptrdiff_t>(up.grid) * grid.columns + across.grid,
       .to_stride = static_cast<std::ptrdiff_t>(columns_),
       .from_stride = sign_y > 0 ? grid.columns : -grid.columns,
       .columns = across.end - across.begin,
       .rows = up.end - up.begin,
       .backwards = sign_x < 0,
       .weight = reading.weight * grid.unit});
}

layout::Place Field::place_at(std::size_t column, std::size_t row) const {
  const double pixel = maps_->scale().pixel;
  const double x = std::min(room_.low_x + static_cast<double>(column) * pixel, room_.high_x);
  const double y = std::min(room_.low_y + static_cast<double>(row) * pixel, room_.high_y);
  const layout::RealBox at = matched_fit(*set_, piece_, turn_, room_, x, y);
  return {std::max(at.low_x, std::min(x, at.high_x)), std::max(at.low_y, std::min(y, at.high_y)), turn_};
}

void Field::append_lowest(std::size_t rows, layout::Dice& dice, std::vector<Candidate>& candidates) const {
  std::vector<std::pair<float, std::size_t>> lowest(rows_);
  for (std::size_t row = 0; row < rows_; ++row) lowest[row] = {lowest_value(&values_[row * columns_], columns_), row};
  const std::size_t wanted = std::min(rows, lowest.size());
  std::partial_sort(lowest.begin(), lowest.begin() + static_cast<std::ptrdiff_t>(wanted), lowest.end());
  for (std::size_t k = 0; k < wanted; ++k) {
    const auto [value, row] = lowest[k];
    if (value == kRuledOut) break;
    const float* const values = &values_[row * columns_];
    std::size_t column = find_value(values, dice.below(columns_), columns_, value);  // of several, a random one
    if (column == columns_) column = find_value(values, 0, columns_, value);
    candidates.push_back({value, place_at(column, row)});
  }
}

std::optional<layout::Place> Field::leftmost_free() const {
  for (std::size_t column = 0; column < columns_; ++column) {
    for (std::size_t row = 0; row < rows_; ++row) {
      if (values_[row * columns_ + column] == 0) return place_at(column, row);
    }
  }
  return std::nullopt;
}

}  // namespace selvage::nesting::local_search
