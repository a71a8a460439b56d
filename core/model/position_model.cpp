#include "core/model/position_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace selvage::model {

PositionModel::PositionModel(const marker::PlacedPieces& pieces, const Strip& strip, const Ties& given)
    : pieces_{pieces},
      unit_{strip},
      length_{pieces.length()},
      x_(pieces.size(), kNone),
      y_(pieces.size(), kNone),
      wall_row_(pieces.size(), kNoWall) {
  const std::optional<Ties> with_sets =
      pieces.match_sets().empty() ? std::nullopt : std::optional{with_match_sets(given, pieces, strip)};
  const Ties& ties = with_sets ? *with_sets : given;
  std::vector<int> x_of(pieces.size(), kNone);  // by tie
  std::vector<int> y_of(pieces.size(), kNone);
  const Coord end = strip.last().value_or(kLatticeLimit);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Box box = pieces.box(i);
    const Box room = pieces.room(i, strip, end);
    const auto way = [&](Coord from, Coord to) { return unit_.to_columns(static_cast<double>(to - from)); };
    if (ties.x[i] != Ties::kFixed) {
      bound(x_of[ties.x[i]], way(box.low.x, room.low.x),
            strip.longest || room.high.x < end ? way(box.high.x, room.high.x) : lp::kInfinity);
      x_[i] = x_of[ties.x[i]];
    }
    if (ties.y[i] != Ties::kFixed) {
      bound(y_of[ties.y[i]], way(box.low.y, room.low.y), way(box.high.y, room.high.y));
      y_[i] = y_of[ties.y[i]];
    }
  }
  for (const marker::Shade& shade : pieces.shades()) add_shade(shade);
}

// With l the motion of the left end of the shade's cloth, which is now the left end of its leftmost piece:
// d_i - l >= left - low_i and l - d_i >= high_i - left - length.  Whole numbers, so rounding keeps them (snap.h).
void PositionModel::add_shade(const marker::Shade& shade) {
  const auto may_move = [this](std::uint32_t piece) { return x_[piece] != kNone; };
  if (std::none_of(shade.pieces.begin(), shade.pieces.end(), may_move)) return;
  Coord left = kLatticeLimit;
  for (const std::uint32_t piece : shade.pieces) left = std::min(left, pieces_.box(piece).low.x);
  const int cloth = program_.add_column(0, -lp::kInfinity, lp::kInfinity);
  for (const std::uint32_t piece : shade.pieces) {
    const Box box = pieces_.box(piece);
    for (const auto& [nx, bound] : {std::pair{1.0, left - box.low.x}, {-1.0, box.high.x - left - shade.length}}) {
      Terms entries = terms(piece, {}, nx, 0);
      entries.add(cloth, -nx);
      shade_rows_.push_back({piece, nx, program_.add_row(entries.all(), unit_.to_columns(static_cast<double>(bound)))});
    }
  }
}

// Adds the column if there is none yet; otherwise narrows its bounds.
void PositionModel::bound(int& column, double low, double high) {
  if (column == kNone) {
    column = program_.add_column(0, low, high);
    return;
  }
  const auto c = static_cast<std::size_t>(column);
  program_.lower[c] = std::max(program_.lower[c], low);
  program_.upper[c] = std::min(program_.upper[c], high);
}

Terms PositionModel::terms(std::size_t q, std::optional<std::size_t> p, double nx, double ny) const {
  Terms terms;
  const auto put = [&](const std::vector<int>& columns, double n) {
    const int second = columns[q];
    const int first = p ? columns[*p] : kNone;
    if (n == 0 || first == second) return;  // they share one displacement
    if (second != kNone) terms.add(second, n);
    if (first != kNone) terms.add(first, -n);
  };
  put(x_, nx);
  put(y_, ny);
  return terms;
}

double PositionModel::reach() const {
  constexpr double kSeveral = 10;
  return kSeveral * (unit_.to_columns(static_cast<double>(length_)) + ModelUnit::kAcross);
}

std::optional<int> PositionModel::add(const PairRow& row, std::optional<int> give) {
  const auto [p, q] = row.pair;
  if (x_[p] == x_[q] && y_[p] == y_[q]) return std::nullopt;
  Terms entries = terms(q, p, row.nx, row.ny);
  if (give) entries.add(*give, 1);
  return program_.add_row(entries.all(), unit_.to_columns(row.bound));
}

void PositionModel::add_length(double cost, double shorten, double lengthen) {
  length_column_ = program_.add_column(cost, unit_.to_columns(-shorten), unit_.to_columns(lengthen));
}

void PositionModel::add_right_wall(std::size_t piece) {
  const double room = unit_.to_columns(static_cast<double>(length_ - pieces_.end_of(piece)));
  if (x_[piece] != kNone) {
    const std::array<lp::LinearProgram::Entry, 2> entries{{{length_column_, 1}, {x_[piece], -1}}};
    wall_row_[piece] = program_.add_row(entries, -room);
  } else {
    wall_row_[piece] = kWallIsBound;
    const auto c = static_cast<std::size_t>(length_column_);
    program_.lower[c] = std::max(program_.lower[c], -room);
  }
}

std::optional<int> PositionModel::right_wall_row(std::size_t piece) const {
  return wall_row_[piece] >= 0 ? std::optional{wall_row_[piece]} : std::nullopt;
}

void PositionModel::add_cost(std::size_t piece, double x, double y) {
  if (x_[piece] != kNone) program_.cost[static_cast<std::size_t>(x_[piece])] += x;
  if (y_[piece] != kNone) program_.cost[static_cast<std::size_t>(y_[piece])] += y;
}

void PositionModel::add_displacement_penalty(double cost, std::span<const Vec> home) {
  std::vector<char> counted(program_.cost.size());  // tied pieces once
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Vec away = home.empty() ? Vec{} : pieces_.at(i) - home[i];
    for (const auto& [column, offset] : {std::pair{x_[i], away.x}, std::pair{y_[i], away.y}}) {
      if (column == kNone || counted[static_cast<std::size_t>(column)] != 0) continue;
      counted[static_cast<std::size_t>(column)] = 1;
      // |away + d| is the least t with t >= away + d and t >= -(away + d).
      const double bound = unit_.to_columns(static_cast<double>(offset));
      const int magnitude = program_.add_column(cost, 0, lp::kInfinity);
      program_.add_row(std::array<lp::LinearProgram::Entry, 2>{{{magnitude, 1}, {column, -1}}}, bound);
      program_.add_row(std::array<lp::LinearProgram::Entry, 2>{{{magnitude, 1}, {column, 1}}}, -bound);
    }
  }
}

std::vector<RealVec> PositionModel::displacements(std::span<const double> x) const {
  std::vector<RealVec> moves(pieces_.size());
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (x_[i] != kNone) moves[i].x = unit_.to_lattice(x[static_cast<std::size_t>(x_[i])]);
    if (y_[i] != kNone) moves[i].y = unit_.to_lattice(x[static_cast<std::size_t>(y_[i])]);
  }
  return moves;
}

double PositionModel::length_change(std::span<const double> x) const {
  return length_column_ < 0 ? 0 : unit_.to_lattice(x[static_cast<std::size_t>(length_column_)]);
}

}  // namespace selvage::model
