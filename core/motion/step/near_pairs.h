// The near pairs of a round: those that are within the trust radius, that can move against each other, and of which at
// least one piece is active; with their obstacles, and the rows of these and of any other pair.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <boost/container/flat_set.hpp>

#include "core/model/active_set.h"
#include "core/model/pair_rows.h"
#include "core/motion/step/obstacles.h"
#include "core/motion/step/position_step.h"

namespace selvage::motion::step {

using PairSet = boost::container::flat_set<marker::PiecePair>;

class NearPairs {
 public:
  // None yet.  The referenced values must outlive this.
  NearPairs(const scene::Scene& scene, const Goal& goal, const StepSettings& settings);

  // All pairs within the trust radius, whichever pieces are active.
  [[nodiscard]] const std::vector<marker::PiecePair>& within_trust() const { return within_trust_; }
  [[nodiscard]] const std::vector<marker::PiecePair>& pairs() const { return pairs_; }

  // How far two near pieces are assumed to move against each other on an axis; lattice units.
  [[nodiscard]] double motion() const { return motion_; }
  // The same for one pair: one that hardly moved in the last round hardly moves in this one.
  [[nodiscard]] double motion(marker::PiecePair pair) const;

  // Adds the pairs that have become near because one of their pieces is active now, except those in `modelled`, and
  // finds their obstacles.  Returns the number of pairs before.  Adds only some of them when cancelled: where pieces
  // were turned, all sums are new, and a long marker has many.
  std::size_t extend(const model::ActiveSet& active, const PairSet& modelled, const scene::Run& run);

  // The rows of the pairs from the k-th on that their motion can break.
  [[nodiscard]] std::vector<model::PairRow> rows_from(std::size_t k, model::TightRows tight,
                                                      const Executor& executor) const;
  // Appends the rows of the k-th pair that a given motion can break.
  void append_rows(std::size_t k, double motion, model::TightRows tight, std::vector<model::PairRow>& rows) const;
  // Appends all rows of any pair.
  void append_all_rows(marker::PiecePair pair, model::TightRows tight, std::vector<model::PairRow>& rows) const;

 private:
  void append(marker::PiecePair pair, const minkowski::Obstacle& obstacle, double motion, model::TightRows tight,
              std::vector<model::PairRow>& rows) const;

  const scene::Scene& scene_;
  const Goal& goal_;
  const StepSettings& settings_;
  Obstacles obstacles_;
  double motion_;
  std::span<const Vec> last_moves_;  // empty when they say nothing about this round
  std::vector<marker::PiecePair> within_trust_;
  std::vector<marker::PiecePair> pairs_;
  std::vector<minkowski::Obstacle> obstacle_of_;  // each pair's
};

}  // namespace selvage::motion::step
