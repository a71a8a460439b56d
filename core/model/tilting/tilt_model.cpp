#include "core/model/tilting/tilt_model.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace selvage::model::tilting {

TiltModel::TiltModel(const marker::PlacedPieces& pieces, const Strip& strip, const Ties& ties,
                     std::span<const TurnRange> turns, double farthest)
    : pieces_{pieces},
      turns_{turns.begin(), turns.end()},
      farthest_{farthest},
      positions_{pieces, strip, ties},
      column_(pieces.size(), -1),
      radius_(pieces.size(), 0) {
  lp::LinearProgram& program = positions_.program();
  const double limit = positions_.unit().to_columns(farthest);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool tilts = !turns_[i].empty();
    for (const auto position : {positions_.x_column(i), positions_.y_column(i)}) {
      if (!position) continue;
      const auto c = static_cast<std::size_t>(*position);
      // A piece that is outside the strip, by rounding, must be able to come back.
      program.lower[c] = tilts ? -limit : std::max(program.lower[c], std::min(-limit, program.upper[c]));
      program.upper[c] = tilts ? limit : std::min(program.upper[c], std::max(limit, program.lower[c]));
    }
    if (!tilts) continue;
    radius_[i] = radius_of(pieces[i]);
    const double arc = positions_.unit().to_columns(radius_[i]);
    column_[i] = program.add_column(0, turns_[i].least * arc, turns_[i].most * arc);
    const double turn = std::max(-turns_[i].least, turns_[i].most);
    const Box room = pieces.room(i, strip, kLatticeLimit);
    for (const auto& [nx, ny, edge] :
         {std::tuple{1, 0, room.low.x}, {0, 1, room.low.y}, {0, -1, -room.high.y}, {-1, 0, -room.high.x}}) {
      if (edge == -kLatticeLimit) continue;  // no rule, and the cloth has no end
      for (const WallRow& wall : wall_rows(pieces[i], nx, ny, edge, turn)) {
        if (-wall.bound <= farthest + 2 * turn * radius_[i]) add_wall(i, wall, std::nullopt);
      }
    }
  }
}

std::optional<int> TiltModel::turn_column(std::size_t piece) const {
  return column_[piece] < 0 ? std::nullopt : std::optional{column_[piece]};
}

void TiltModel::add(const TiltRow& tilt_row, std::optional<int> give) {
  const PairRow& row = tilt_row.row;
  std::array<lp::LinearProgram::Entry, 7> entries{};
  std::size_t count = 0;
  const auto put = [&](int column, double value) {
    if (value != 0) entries[count++] = {column, value};
  };
  const Terms terms = positions_.terms(row.pair.second, row.pair.first, row.nx, row.ny);
  for (const auto& [column, value] : terms.all()) put(column, value);
  for (const auto& [piece, turn] :
       {std::pair{row.pair.first, tilt_row.first_turn}, std::pair{row.pair.second, tilt_row.second_turn}}) {
    if (column_[piece] >= 0) put(column_[piece], turn / radius_[piece]);
  }
  if (count == 0) return;
  if (give) put(*give, 1);
  positions_.program().add_row(std::span{entries}.first(count), positions_.unit().to_columns(row.bound));
}

void TiltModel::add_wall(std::size_t piece, const WallRow& wall, std::optional<int> length_column) {
  std::array<lp::LinearProgram::Entry, 3> entries{};
  std::size_t count = 0;
  const auto position = wall.nx != 0 ? positions_.x_column(piece) : positions_.y_column(piece);
  entries[count++] = {*position, static_cast<double>(wall.nx + wall.ny)};
  if (wall.turn != 0) entries[count++] = {column_[piece], wall.turn / radius_[piece]};
  if (length_column) entries[count++] = {*length_column, 1};
  // A vertex that is outside already, by rounding, need not come back: every program must be feasible.
  const double bound = std::min(wall.bound, 0.0);
  positions_.program().add_row(std::span{entries}.first(count), positions_.unit().to_columns(bound));
}

void TiltModel::add_right_walls(std::optional<int> length_column) {
  const Coord length = pieces_.length();
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const auto room = static_cast<double>(length - pieces_.end_of(i));
    if (column_[i] < 0) {
      if (length_column && room <= 2 * farthest_) positions_.add_right_wall(i);
      if (const auto position = positions_.x_column(i); position && !length_column) {
        double& upper = positions_.program().upper[static_cast<std::size_t>(*position)];
        upper = std::min(upper, positions_.unit().to_columns(room));
      }
      continue;
    }
    const double turn = std::max(-turns_[i].least, turns_[i].most);
    if (room > 2 * farthest_ + 2 * turn * radius_[i]) continue;
    for (const WallRow& wall : wall_rows(pieces_[i], -1, 0, -length, turn)) add_wall(i, wall, length_column);
  }
}

void TiltModel::add_length(double cost, double shorten, double lengthen) {
  positions_.add_length(cost, shorten, lengthen);
  add_right_walls(positions_.program().columns() - 1);
}

void TiltModel::fix_length() {
  add_right_walls(std::nullopt);
}

std::vector<double> TiltModel::turns(std::span<const double> x) const {
  std::vector<double> turns(column_.size(), 0);
  for (std::size_t i = 0; i < column_.size(); ++i) {
    if (column_[i] < 0) continue;
    const double turn = positions_.unit().to_lattice(x[static_cast<std::size_t>(column_[i])]) / radius_[i];
    turns[i] = std::clamp(turn, turns_[i].least, turns_[i].most);
  }
  return turns;
}

}  // namespace selvage::model::tilting
