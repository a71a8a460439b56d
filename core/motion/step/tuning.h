// The tuning constants of one round (position_step.h).  No answer becomes wrong with other values: a round only takes
// longer, or gains less.  The defaults were chosen on the markers in examples/markers; docs/measurements/README.md has
// the figures.
#pragma once

#include <array>
#include <cstddef>

namespace selvage::motion::step {

struct StepTuning {
  // Linear programs that one round solves at most, as rows, pairs and pieces enter.  Few rounds need more than four.
  int programs{24};
  // From this program on, pieces that collide get the rows of all pieces that they would be near to after their moves.
  // Otherwise each program may make loose pieces collide with others, and the round never ends.
  int foresight_after{5};
  // Where the marker is shortened, a program with more than this multiple of the first one's rows is the round's last:
  // its moves are scaled down until they keep the rows that are left out.  Rows of pieces that are far apart make a
  // factor dense, and a round of a loose marker could take minutes.
  double most_growth{1.5};
  std::size_t spare_rows{200};  // by which a program may grow in any case
  // Near, for foresight_after, means within this fraction of the trust radius.
  double foresight{0.3};
  // A marker of at least this many pieces is large.  Where it is shortened, flights are limited, and a program whose
  // solution breaks rows that were left out is solved again only around these rows (core/lp/solver/solve_locally.h).
  // Smaller markers take no less time with it.
  std::size_t large_marker{500};
  // From this program on, when pieces of a large marker collide, near pieces move against each other by at most this
  // multiple of NearPairs::motion.
  int flights_after{2};
  double flight{4};
  // The whole program is solved again after this many local solutions,
  int local_solutions{20};
  // and when one gains less than this fraction of what the solution before it gained.
  double local_gain{0.9};
  // The moves of the last program are halved up to this many times, until no two pieces collide.
  int halvings{16};
  // With at most this many free pieces, a round at fixed length models all of them at once: one program of so few
  // pieces is faster than several of a growing active set.
  std::size_t small_marker{64};
  // The factor by which the active set grows at least when pieces are added (core/model/active_set.h).
  std::size_t active_set_growth{8};
  // Column units of the goal.  A program that gains less is not worth a proof.
  double least_gain{1e-5};
  // Lattice units by which a row must be broken before it enters a program.
  double broken{1e-2};
  // Two near pieces are assumed to move against each other by at most this many trust radii on an axis: each of them
  // by one.  Rows that are farther away are left out until a solution breaks them.
  double motion_per_trust{2};
  // Edges of a sum are looked at up to this multiple of that motion: half-planes of farther edges cannot be reached.
  double region_reach{1.5};
  // A pair is assumed to move against each other by at most this many times what it moved in the last round,
  double motion_ahead{8};
  // but never by less than this fraction of the motion of all pairs.
  double least_motion{0.2};
  // Length per unit of room: rows on which the length depends by more than this count as pressed on.
  double pressed{1e-2};
  // Column units by which the length may grow in a program that shortens it, so that rows can have their margins.
  double spare_length{1e-2};
  // The fractions of a step that are tried in turn when rounding makes pieces collide.
  std::array<double, 4> fractions{1.0, 1 - 1e-6, 1 - 1e-3, 0.5};

  friend bool operator==(const StepTuning&, const StepTuning&) = default;
};

}  // namespace selvage::motion::step
