#include "core/model/position_model.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/minkowski/inner_fit.h"

namespace selvage {
namespace {

constexpr double kUnitsAcross = 1000;     // column units in a strip's width
constexpr double kSolverResidual = 1e-9;  // column units by which a solver may break a row

}  // namespace

PairRow row_of(PiecePair pair, const HalfPlane& side, Vec r, Coord spacing, double unit, TightRows tight) {
  const auto dx = static_cast<double>(side.direction.x);
  const auto dy = static_cast<double>(side.direction.y);
  const double length = std::sqrt(dx * dx + dy * dy);
  PairRow row{pair, dy / length, -dx / length, 0};
  const double slack = slack_of(side, r) - static_cast<double>(spacing);
  const bool slanted = side.direction.x != 0 && side.direction.y != 0;
  const double margin = slanted ? std::abs(row.nx) + std::abs(row.ny) + 2 * kSolverResidual * unit : 0;
  row.bound = margin - slack;
  if (tight == TightRows::kKeep && slack >= 0 && slack < margin) row.bound = 0;
  return row;
}

PositionModel::PositionModel(const PlacedPieces& pieces, const Strip& strip, std::span<const std::uint32_t> group)
    : pieces_{pieces},
      unit_{static_cast<double>(strip.width) / kUnitsAcross},
      length_{pieces.length()},
      column_(pieces.size(), -1),
      wall_row_(pieces.size(), kNoWall) {
  std::vector<int> column_of_group(pieces.size(), -1);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (group[i] == kFixed) continue;
    const Box fit = inner_fit(pieces[i].box, 0, strip.width);
    const Vec at = pieces.at(i);
    const double left = static_cast<double>(fit.low.x - at.x) / unit_;
    const double low = static_cast<double>(fit.low.y - at.y) / unit_;
    const double high = static_cast<double>(fit.high.y - at.y) / unit_;
    const double right = strip.longest ? static_cast<double>(*strip.longest - pieces.box(i).high.x) / unit_ : kInfinity;
    int& column = column_of_group[group[i]];
    if (column < 0) {
      column = program_.add_column(0, left, right);
      program_.add_column(0, low, high);
    } else {
      const auto c = static_cast<std::size_t>(column);
      program_.lower[c] = std::max(program_.lower[c], left);
      program_.upper[c] = std::min(program_.upper[c], right);
      program_.lower[c + 1] = std::max(program_.lower[c + 1], low);
      program_.upper[c + 1] = std::min(program_.upper[c + 1], high);
    }
    column_[i] = column;
  }
}

void PositionModel::add(const PairRow& row, std::optional<int> give) {
  std::array<LinearProgram::Entry, 5> entries{};
  std::size_t count = 0;
  const int p = column_[row.pair.first];
  const int q = column_[row.pair.second];
  if (p == q) return;  // both fixed, or of one group: nothing to say
  const auto put = [&](int column, double value) {
    if (value != 0) entries[count++] = {column, value};
  };
  if (q >= 0) {
    put(q, row.nx);
    put(q + 1, row.ny);
  }
  if (p >= 0) {
    put(p, -row.nx);
    put(p + 1, -row.ny);
  }
  if (give) put(*give, 1);
  program_.add_row(std::span{entries}.first(count), row.bound / unit_);
}

void PositionModel::add_length(double cost, double shorten, double lengthen) {
  length_column_ = program_.add_column(cost, -shorten / unit_, lengthen / unit_);
}

void PositionModel::add_right_wall(std::size_t piece) {
  const double room = static_cast<double>(length_ - pieces_.box(piece).high.x) / unit_;
  if (column_[piece] >= 0) {
    const std::array<LinearProgram::Entry, 2> entries{{{length_column_, 1}, {column_[piece], -1}}};
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
  if (column_[piece] < 0) return;
  const auto c = static_cast<std::size_t>(column_[piece]);
  program_.cost[c] += x;
  program_.cost[c + 1] += y;
}

void PositionModel::add_stillness(double cost, std::span<const Vec> home) {
  std::vector<char> counted(program_.cost.size());  // each group once
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (column_[i] < 0 || counted[static_cast<std::size_t>(column_[i])] != 0) continue;
    counted[static_cast<std::size_t>(column_[i])] = 1;
    const Vec away = home.empty() ? Vec{} : pieces_.at(i) - home[i];
    for (const auto& [column, offset] : {std::pair{column_[i], away.x}, std::pair{column_[i] + 1, away.y}}) {
      // |away + d| is the least t with t >= away + d and t >= -(away + d).
      const double bound = static_cast<double>(offset) / unit_;
      const int magnitude = program_.add_column(cost, 0, kInfinity);
      program_.add_row(std::array<LinearProgram::Entry, 2>{{{magnitude, 1}, {column, -1}}}, bound);
      program_.add_row(std::array<LinearProgram::Entry, 2>{{{magnitude, 1}, {column, 1}}}, -bound);
    }
  }
}

std::optional<int> PositionModel::column(std::size_t piece) const {
  return column_[piece] < 0 ? std::nullopt : std::optional{column_[piece]};
}

std::vector<Displacement> PositionModel::displacements(std::span<const double> x) const {
  std::vector<Displacement> moves(pieces_.size());
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (column_[i] < 0) continue;
    const auto c = static_cast<std::size_t>(column_[i]);
    moves[i] = {x[c] * unit_, x[c + 1] * unit_};
  }
  return moves;
}

double PositionModel::length_change(std::span<const double> x) const {
  return length_column_ < 0 ? 0 : x[static_cast<std::size_t>(length_column_)] * unit_;
}

}  // namespace selvage
