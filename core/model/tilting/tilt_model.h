// The position model with one more column for every piece that may tilt [Li94 6.2.4]: its turn, measured by the arc
// that its farthest vertex describes, so that all columns have the same unit.
//
// The strip's edges are bounds of columns in the position model.  For a piece that may tilt they become rows, because
// the vertex that comes first changes as the piece turns.  Pieces that may not tilt have neither the column nor the
// rows.
#pragma once

#include <span>
#include <vector>

#include "core/model/position_model.h"
#include "core/model/tilting/tilt_rows.h"

namespace selvage::model::tilting {

// How far a piece may turn from where it is, radians; least <= 0 <= most.
struct TurnRange {
  double least{}, most{};
  [[nodiscard]] bool empty() const { return least == 0 && most == 0; }
};

class TiltModel {
 public:
  // `turns[i]`: the range of piece i; not empty only when the piece is free.  `farthest`: the most that a pivot moves
  // on an axis; lattice units.
  TiltModel(const marker::PlacedPieces& pieces, const Strip& strip, const Ties& ties, std::span<const TurnRange> turns,
            double farthest);

  [[nodiscard]] PositionModel& positions() { return positions_; }
  [[nodiscard]] const PositionModel& positions() const { return positions_; }
  [[nodiscard]] const lp::LinearProgram& program() const { return positions_.program(); }
  // The turn column of a piece, or nothing when it may not tilt.
  [[nodiscard]] std::optional<int> turn_column(std::size_t piece) const;

  // With a column `give`, the row may be broken by that column's value.
  void add(const TiltRow& row, std::optional<int> give = {});
  // The length column of the position model, and the right walls of all pieces that can reach the marker's end.
  void add_length(double cost, double shorten, double lengthen);
  // Keeps every piece left of the marker's present end.  Used instead of add_length.
  void fix_length();

  // Radians, one per piece.
  [[nodiscard]] std::vector<double> turns(std::span<const double> x) const;

 private:
  void add_wall(std::size_t piece, const WallRow& wall, std::optional<int> length_column);
  void add_right_walls(std::optional<int> length_column);

  const marker::PlacedPieces& pieces_;
  std::vector<TurnRange> turns_;
  double farthest_;
  PositionModel positions_;
  std::vector<int> column_;     // of each piece; -1 when it may not tilt
  std::vector<double> radius_;  // of each piece that may tilt
};

}  // namespace selvage::model::tilting
