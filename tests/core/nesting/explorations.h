// Explorations (core/nesting/exploration.h) of a few rectangles and triangles.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "core/nesting/exploration.h"
#include "core/nesting/layout/layout.h"
#include "core/nesting/nest.h"
#include "tests/core/nesting/unplaced_pieces.h"

namespace selvage::test {

inline Marker rectangles_and_triangles() {
  const Polygon triangle{{0, 0}, {3 * kSide, 0}, {0, 2 * kSide}};
  return unplaced_pieces({rectangle(2 * kSide, kSide), triangle, rectangle(kSide, 3 * kSide)}, 12, 7 * kSide);
}

class Explorations : public ::testing::Test {
 protected:
  std::unique_ptr<nesting::Exploration> begun(nesting::OnStall on_stall, const nesting::Budget& budget,
                                              const nesting::NestTuning& tuning,
                                              nesting::Exploration::Shorter shorter = {}) {
    auto exploration = std::make_unique<nesting::Exploration>(
        set_, first_, guided_, tuning, on_stall, budget, std::nullopt, run_,
        [this](const nesting::Improvement& better, const Marker&) { shortest_ = std::min(shortest_, better.length); },
        std::move(shorter));
    exploration->begin(to_layout(set_, first_), set_.fixed);
    return exploration;
  }

  // Attempts are given up at once, and there is no marker of half the length to walk to.
  [[nodiscard]] static nesting::NestTuning only_attempts_gain() {
    nesting::NestTuning tuning;
    tuning.first_step = tuning.least_step;
    tuning.search.patience = tuning.search.strikes = 1;
    tuning.walk_slack = -0.5;
    tuning.explored = 1;
    return tuning;
  }

  SumCache sums_;
  const scene::Run run_{sums_};
  const Marker first_ = nesting::nest(rectangles_and_triangles(), {}, {sums_})->marker;
  const nesting::layout::PieceSet set_ =
      *nesting::layout::piece_set_of(rectangles_and_triangles(), nesting::layout::PlacedPiecesMay::kMove, sums_);
  nesting::local_search::GuidedSearch guided_{set_, 1, std::size_t{1} << 24, {}, {}};
  Coord shortest_{kLatticeLimit};  // of all explorations
};

}  // namespace selvage::test
