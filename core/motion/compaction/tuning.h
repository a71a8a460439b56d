// The tuning constants of compaction, of opening a gap and of the critical path.  Where no other source is named, the
// values were tuned on the example markers (docs/measurements/trade.md).
#pragma once

#include <cstddef>

#include "core/motion/sections/tuning.h"
#include "core/motion/step/tuning.h"

namespace selvage::motion::compaction {

struct CompactionTuning {
  double trust_ahead{2};       // the next round's trust radius, as a multiple of the last round's farthest move
  double least_trust{0.05};    // the trust radius never shrinks below this part of the first round's
  double most_near_pairs{12};  // for each piece, on average: the first round's trust radius is halved until there are
                               // no more, because the fill of a program's factor grows with the square of their number
  double long_from{10};        // widths: in markers longer than this, the least gain grows with the length
  double little{2e-5};         // part of the width: a program that gains less is not solved again for rows left out
                               // (position_step.h); only the last round of a standard compaction gains so little
  double touching{1e-5};       // part of the width: pieces this close count as touching
  double loose_below{0.75};    // utilisation below which a marker counts as loose (escape.h)
  double worth_a_sweep{5e-5};  // part of the length: sweeps and rounds that gain less together are the last
  std::size_t many_loose{64};  // gaps that at least this many pieces lie behind are closed first (core/motion/closing)
  int sweeps{200};             // single-piece sweeps at a time, at most
  std::size_t most_pieces_repeated{400};  // loose markers with more pieces are compacted once (escape.h)
  int repeated_in_vain{3};                // a marker is compacted again until this many times in a row gain nothing
  std::size_t most_pieces_swept{5000};    // markers with more pieces are not swept, because it would take too long
  sections::SectionTuning sections{};
  int hard_round{3};  // a round that solves this many programs is hard: sections take less time than more of them
  double section_gain{1.5e-3};  // part of the width: the rounds of a section end with the first one that gains less
  double later_gain{4};     // rounds after sections end with the first one that gains less than this multiple of the
                            // least gain
  step::StepTuning step{};  // of each round
  friend bool operator==(const CompactionTuning&, const CompactionTuning&) = default;
};

struct GapTuning {
  int tries{4};       // steps without gain, each shorter than the one before, until the gap counts as largest
  double shorter{4};  // by which a step without gain divides the trust radius
  friend bool operator==(const GapTuning&, const GapTuning&) = default;
};

struct CriticalPathTuning {
  double reach{0.005};       // part of the width: contacts are looked for this near
  double contact{1e-4};      // part of the width: only pieces and edges this near are in contact, and reported
  double touching{1e-5};     // part of the width: a contact lies along an edge that is this near or, off its line,
  double beside{1.5};        // farther by up to this multiple of the distance from that line
  double least_worth{1e-6};  // smaller loads are rounding of the solver; all loads on the right edge add up to 1
  double spare{1e-2};        // model units by which the length may grow, so that rows' margins leave a feasible point
  friend bool operator==(const CriticalPathTuning&, const CriticalPathTuning&) = default;
};

// The displacement penalty of a push, relative to the largest force: small, so that only pieces that are in the way
// move.
inline constexpr double kPushPenalty = 1e-4;

}  // namespace selvage::motion::compaction
