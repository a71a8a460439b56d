// The growing model of one round: a linear program in the displacements of the active pieces, with rows for near pairs,
// and further rows and pieces as solutions turn out to need them [Li94 4.1.4].
//
// Its optimum is that of the program with all pieces, pairs and rows once nothing is added any more: rows that a
// solution keeps change nothing, and neither do pieces that nothing presses on harder than moving them costs
// (core/model/active_set.h).
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/model/active_set.h"
#include "core/model/position_model.h"
#include "core/motion/step/length_mode.h"
#include "core/motion/step/near_pairs.h"

namespace selvage::motion::step {

class RoundModel {
 public:
  // The referenced values must outlive this.
  RoundModel(const scene::Scene& scene, const Goal& goal, const StepSettings& settings, const scene::Run& run);

  RoundModel(const RoundModel&) = delete;
  RoundModel& operator=(const RoundModel&) = delete;

  // Solves the program, unless solve_locally() has left a solution that was not returned yet.
  [[nodiscard]] lp::LpSolution solve();
  // How often the whole program was solved.
  [[nodiscard]] int programs() const { return programs_; }
  // Solves the program again only around the rows that were added since and that the solution breaks
  // (core/lp/solver/solve_locally.h); the next solve() returns the result, without dual values of those rows.  Does
  // nothing in small markers (StepTuning), and where no solution is found or too much of the gain would be lost.
  void solve_locally(const lp::LpSolution& solution);
  // What an optimal solution asks for.
  [[nodiscard]] Moves moves(const lp::LpSolution& solution) const;

  // The program is infeasible, or no solver could solve it: activates the neighbours of the active pieces or, when none
  // of them could move, lets pairs without room for their rows' margins keep the room they have.  False when that has
  // been tried already.
  bool make_feasible();
  // Adds the rows that were left out and that the moves break.  True when there were any.  Moves that gain less than
  // StepSettings::worth do not deserve another program: they are scaled down until they keep these rows.
  bool add_broken_rows(Moves& moves, double gain);
  // Scales the moves down until they keep the rows that were left out.
  void shorten(Moves& moves) const;
  // Activates the pieces that the solution's rows press on harder than moving them costs.  True when there were any.
  bool add_pressed_pieces(const lp::LpSolution& solution);
  // The rows that the solution presses on, other than a little.
  [[nodiscard]] std::vector<model::PairRow> pressed_rows(const lp::LpSolution& solution) const;
  // Models those of the pairs that are not modelled yet.  True when there were any.
  bool add_pairs(const std::vector<marker::PiecePair>& pairs);
  // The pairs that are near each other after the moves and contain one of the colliding pieces.
  [[nodiscard]] std::vector<marker::PiecePair> ahead_of(const Moves& moves,
                                                        const std::vector<marker::PiecePair>& colliding) const;
  // In a large marker, limits how far near pieces move against each other, where these moves take them far
  // (StepTuning).  Pieces that nothing holds would otherwise fly over many others, and each further program would learn
  // of a few of these only.  True when any moves were limited.
  bool limit_flights(const Moves& moves);
  // Pieces that collide after rounding although their pairs are modelled move as one from now on: their relative
  // position, which is valid now, stays.
  void tie(const std::vector<marker::PiecePair>& pairs);

  // True when the program has so many more rows than the first one that it has to be the round's last (StepTuning).
  [[nodiscard]] bool has_outgrown() const;

  // The pairs that the model has rows for.
  [[nodiscard]] const PairSet& modelled() const { return modelled_; }
  [[nodiscard]] const std::vector<marker::PiecePair>& near_pairs() const { return near_.pairs(); }

 private:
  // Adds the pairs that have become near; returns how many there were.
  std::size_t extend_near();
  // Makes all rows anew and builds the program.
  void restart();
  // Builds the program for a larger active set.
  void grow(std::vector<std::uint32_t> pieces);
  void build();
  void add_row(std::size_t k);
  void shorten_to(const BrokenRows& broken, Moves& moves) const;

  const scene::Scene& scene_;
  const Goal& goal_;
  const StepSettings& settings_;
  const scene::Run& run_;
  model::ActiveSet active_;
  NearPairs near_;
  std::unique_ptr<const LengthMode> length_;
  model::TightRows tight_{model::TightRows::kRestore};
  PairSet modelled_;
  std::vector<model::PairRow> rows_;
  std::size_t first_rows_{};  // of the first program
  std::optional<model::PositionModel> model_;
  std::vector<std::pair<int, std::size_t>> row_of_;  // rows of the program, each with its index in rows_
  std::optional<lp::LpSolution> local_;              // for solve() to return
  int programs_{};
  int local_solutions_{};  // since the whole program was solved
};

}  // namespace selvage::motion::step
