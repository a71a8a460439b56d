#include "core/nesting/fields/field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace selvage::nesting::fields {
namespace {

constexpr float kRuledOut = std::numeric_limits<float>::max();  // of cells without an allowed position
constexpr double kWholeNumbers = 1 << 24;                       // up to which a float holds every one
constexpr double kReserve = 4;       // a new unit lets the sums of cells grow by at least this factor
constexpr double kMostReserve = 64;  // a unit that lets them grow by more than this factor is replaced
constexpr double kSteps = 0.4;       // from one middle of a room to the next, in reaches
constexpr float kMostOfSample = 255;

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

bool same(const layout::Place& one, const layout::Place& other) {
  return one.x == other.x && one.y == other.y && one.turn == other.turn;
}

bool same(const RealBox& one, const RealBox& other) {
  return one.low_x == other.low_x && one.low_y == other.low_y && one.high_x == other.high_x &&
         one.high_y == other.high_y;
}

const depth::DepthMap::Overlaps& grid_of(const depth::MapView& view) {
  return view.frame.exchanged ? view.map->transposed_overlaps() : view.map->overlaps();
}

}  // namespace

bool Field::compute(const layout::Layout& layout, std::size_t piece, std::uint32_t turn, std::span<const float> weights,
                    double reach) {
  const RealBox room = room_within(layout, piece, turn, reach);
  if (room.high_x < room.low_x || room.high_y < room.low_y) return false;
  bool kept = !counted_.empty() && piece == piece_ && turn == turn_ && same(room, room_);
  piece_ = piece;
  turn_ = turn;
  room_ = room;
  if (!kept) clear();
  std::vector<Change> changes = find_changes(layout, weights);
  if (kept && !unit_suits()) {
    kept = false;
    clear();
    changes = find_changes(layout, weights);
  }
  if (!kept) choose_unit();
  add(changes);
  if (set_->kind(piece).matched) {
    leave_out_unmatched();
    counted_.clear();
  }
  return true;
}

RealBox Field::room_within(const layout::Layout& layout, std::size_t piece, std::uint32_t turn, double reach) const {
  RealBox room = inner_fit(*set_, layout, piece, turn);
  if (std::isinf(reach)) return room;
  // The room stays the same while the piece moves a little.
  const double x = std::max(room.low_x, std::min(layout.places[piece].x, room.high_x));
  const double middle = std::nearbyint(x / (kSteps * reach)) * kSteps * reach;
  room.low_x = std::max(room.low_x, middle - (1 - kSteps / 2) * reach);
  room.high_x = std::min(room.high_x, middle + (1 - kSteps / 2) * reach);
  return room;
}

void Field::clear() {
  // The last column and the last row lie on the edge of the room.
  const float pixel = maps_->scale().pixel;
  cells_.clear(static_cast<std::size_t>(room_.width() / pixel) + 2,
               static_cast<std::size_t>(room_.height() / pixel) + 2);
  counted_.assign(set_->size(), {});
}

// Maps are looked up together, and read after that, because each look-up waits for memory.
std::vector<Field::Change> Field::find_changes(const layout::Layout& layout, std::span<const float> weights) {
  std::vector<Change> changes;
  for (std::uint32_t other = 0; other < counted_.size(); ++other) {
    const Counted& counted = counted_[other];
    const layout::Place& at = layout.places[other];
    if (other != piece_ && (counted.weight != weights[other] || !same(counted.place, at))) {
      find_change(other, at, weights[other], changes);
    }
  }
  return changes;
}

void Field::find_change(std::uint32_t other, const layout::Place& at, float weight, std::vector<Change>& changes) {
  const layout::Turned& own = set_->kind(piece_).turned[turn_];
  Counted& counted = counted_[other];
  const auto view_at = [&](const layout::Place& place) {
    const depth::MapView view = maps_->view(set_->kind(other).turned[place.turn], own);
    __builtin_prefetch(view.map);
    return view;
  };
  const bool moved = !same(counted.place, at);
  if (moved && counted.most > 0) {
    changes.push_back({view_at(counted.place), counted.place.x, counted.place.y, counted.weight, 0});
  }
  const bool reached = weight > 0 && reaches(set_->kind(other).turned[at.turn], at);
  if (reached || (!moved && counted.most > 0)) {
    changes.push_back({view_at(at), at.x, at.y, moved || counted.most <= 0 ? 0 : counted.weight, reached ? weight : 0});
  }
  counted = {at, weight, reached ? weight * kMostOfSample * grid_of(changes.back().view).unit : 0};
}

bool Field::reaches(const layout::Turned& theirs, const layout::Place& at) const {
  const layout::Turned& own = set_->kind(piece_).turned[turn_];
  const double apart =
      std::max(0.0, set_->clearance(own.outline, theirs.outline)) + 2.0 * static_cast<double>(maps_->scale().pixel);
  return room_.low_x + own.box.low_x < at.x + theirs.box.high_x + apart &&
         room_.high_x + own.box.high_x > at.x + theirs.box.low_x - apart;
}

double Field::most_in_a_cell() const {
  double most = 0;
  for (const Counted& counted : counted_) most += static_cast<double>(counted.most);
  return most;
}

bool Field::unit_suits() const {
  const double limit = kWholeNumbers * static_cast<double>(unit_);
  const double most = most_in_a_cell();
  // Weights of less than a unit count as one.
  const double rounded = static_cast<double>(kMostOfSample * unit_) * static_cast<double>(counted_.size());
  return most + rounded <= limit && most * kMostReserve >= limit;
}

void Field::choose_unit() {
  int exponent = 0;
  (void)std::frexp(kReserve * most_in_a_cell() / kWholeNumbers, &exponent);
  unit_ = std::ldexp(1.0F, exponent);
}

void Field::add(const std::vector<Change>& changes) {
  std::vector<depth::GridBlock> blocks;
  blocks.reserve(changes.size());
  for (const Change& change : changes) append_block(change, blocks);
  depth::add_blocks(blocks);
}

float Field::in_units(float weight, float sample) const {
  return weight > 0 ? std::max(1.0F, std::nearbyint(weight * sample / unit_)) : 0;
}

void Field::append_block(const Change& change, std::vector<depth::GridBlock>& blocks) {
  const depth::MapFrame& frame = change.view.frame;
  const depth::DepthMap::Overlaps& grid = grid_of(change.view);
  const float weight = in_units(change.now, grid.unit) - in_units(change.before, grid.unit);
  if (weight == 0) return;
  const float sign_x = frame.exchanged ? frame.sign_y : frame.sign_x;
  const float sign_y = frame.exchanged ? frame.sign_x : frame.sign_y;
  const double pixels = 1 / static_cast<double>(maps_->scale().pixel);
  const Overlap1D across = overlap_of((room_.low_x - change.x) * pixels, sign_x, grid.first_column, grid.columns,
                                      static_cast<int>(cells_.columns()));
  const Overlap1D up =
      overlap_of((room_.low_y - change.y) * pixels, sign_y, grid.first_row, grid.rows, static_cast<int>(cells_.rows()));
  if (across.begin >= across.end || up.begin >= up.end) return;
  blocks.push_back({.to = cells_.row(static_cast<std::size_t>(up.begin)) + across.begin,
                    .from = grid.samples + static_cast<std::ptrdiff_t>(up.grid) * grid.columns + across.grid,
                    .to_stride = static_cast<std::ptrdiff_t>(cells_.stride()),
                    .from_stride = sign_y > 0 ? grid.columns : -grid.columns,
                    .columns = across.end - across.begin,
                    .rows = up.end - up.begin,
                    .backwards = sign_x < 0,
                    .weight = weight});
}

void Field::leave_out_unmatched() {
  const double pixel = maps_->scale().pixel;
  const auto x_at = [&](std::size_t column) { return room_.low_x + static_cast<double>(column) * pixel; };
  const auto y_at = [&](std::size_t row) { return room_.low_y + static_cast<double>(row) * pixel; };
  const auto holds = [pixel](double low, double high, double at) {
    return low < high || (low == high && std::abs(low - at) <= pixel / 2);
  };
  std::vector<bool> matched(cells_.columns());  // by column
  for (std::size_t column = 0; column < matched.size(); ++column) {
    const RealBox fit = matched_fit(*set_, piece_, turn_, room_, x_at(column), room_.low_y);
    matched[column] = holds(fit.low_x, fit.high_x, x_at(column));
  }
  for (std::size_t row = 0; row < cells_.rows(); ++row) {
    const RealBox fit = matched_fit(*set_, piece_, turn_, room_, room_.low_x, y_at(row));
    const bool in_row = holds(fit.low_y, fit.high_y, y_at(row));
    for (std::size_t column = 0; column < matched.size(); ++column) {
      if (!in_row || !matched[column]) cells_.row(row)[column] = kRuledOut;
    }
  }
}

layout::Place Field::place_at(Cell cell) const {
  const double pixel = maps_->scale().pixel;
  const double x = std::min(room_.low_x + static_cast<double>(cell.column) * pixel, room_.high_x);
  const double y = std::min(room_.low_y + static_cast<double>(cell.row) * pixel, room_.high_y);
  const RealBox at = matched_fit(*set_, piece_, turn_, room_, x, y);
  return {std::max(at.low_x, std::min(x, at.high_x)), std::max(at.low_y, std::min(y, at.high_y)), turn_};
}

void Field::append_lowest(std::size_t rows, layout::Dice& dice, std::vector<Candidate>& candidates) const {
  std::vector<LowRow> lowest;
  lowest.reserve(rows);
  cells_.find_lowest_rows(rows, lowest);
  for (const auto& [value, row] : lowest) {
    if (value == kRuledOut) break;
    candidates.push_back({value * unit_, place_at(cells_.any_with(value, row, dice))});
  }
}

std::optional<layout::Place> Field::leftmost_free() const {
  for (std::size_t column = 0; column < cells_.columns(); ++column) {
    for (std::size_t row = 0; row < cells_.rows(); ++row) {
      if (cells_.row(row)[column] == 0) return place_at({column, row});
    }
  }
  return std::nullopt;
}

std::size_t Field::bytes() const {
  return sizeof *this + cells_.bytes() + counted_.capacity() * sizeof(Counted);
}

}  // namespace selvage::nesting::fields
