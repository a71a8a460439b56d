// What a round's program says about the marker's length, and which rows it leaves out until a solution breaks them.
//
// At fixed length every piece is bounded by the marker's present end.  Forces are right only about the present
// positions, so no two near pieces may move against each other by more than NearPairs::motion: those limits are the
// rows that enter late.  Where the marker is shortened, the length is a column, bounded by right walls; near pairs may
// move any distance, and what enters late are the half-planes and walls that are farther away.
#pragma once

#include <memory>
#include <vector>

#include "core/model/position_model.h"
#include "core/motion/step/near_pairs.h"

namespace selvage::motion::step {

// What a solution asks for, before rounding; lattice units.
struct Moves {
  std::vector<RealVec> displacements;  // one per piece
  double length_change{};
};
// How far the second piece of a pair moves against the first.
[[nodiscard]] RealVec relative(marker::PiecePair pair, const std::vector<RealVec>& displacements);
// This fraction of each displacement.
[[nodiscard]] std::vector<RealVec> scaled(const std::vector<RealVec>& displacements, double fraction);
// The most that two of these pairs move against each other on an axis.
[[nodiscard]] double farthest_relative(const std::vector<marker::PiecePair>& pairs,
                                       const std::vector<RealVec>& displacements);

// The rows that a program left out and that moves break.
struct BrokenRows {
  std::vector<model::PairRow> rows;
  std::vector<std::size_t> right_walls;  // of these pieces
  [[nodiscard]] bool empty() const { return rows.empty() && right_walls.empty(); }
};
// The largest fraction of the moves that keeps these rows.  All other rows allow any fraction, because they allow both
// the whole moves and none.
[[nodiscard]] double feasible_fraction(const marker::PlacedPieces& pieces, const BrokenRows& broken,
                                       const Moves& moves);

class LengthMode {
 public:
  virtual ~LengthMode() = default;
  // The columns, their bounds, and what the length needs.
  [[nodiscard]] virtual model::PositionModel model(const model::Ties& ties) const = 0;
  // Appends what a first program needs beside `rows`, the rows of its near pairs.
  virtual void append_first_rows(std::vector<model::PairRow>& rows) const = 0;
  // What the moves, a solution of `model`, break.
  [[nodiscard]] virtual BrokenRows broken_by(const Moves& moves, const model::PositionModel& model,
                                             model::TightRows tight) const = 0;
  // Rows that end flights, which are moves of near pairs against each other by more than `limit` on an axis: programs
  // that shorten the marker do not limit them.
  [[nodiscard]] virtual std::vector<model::PairRow> limits_of_flights(const Moves& moves, double limit) const = 0;
};

// The mode that the goal asks for.  The referenced values must outlive it.
[[nodiscard]] std::unique_ptr<const LengthMode> length_mode(const scene::Scene& scene, const Goal& goal,
                                                            const StepSettings& settings, const NearPairs& near);

}  // namespace selvage::motion::step
