// Compaction beyond the optimum of its programs.
//
// A round's program keeps each pair in one convex part of the free space around it.  Where the pieces touch at corners,
// or a half-plane's line holds them beyond the edge it belongs to, another part would let them pass; to choose the best
// is NP-hard [Li94 8.1].  Sweeps of single-piece moves (core/motion/piece/sweep.h) choose a part for every piece and
// every step.  They are used in three ways:
// (1) In a loose marker, or when the rounds gain next to nothing and end at contacts that may not be real
//     (core/model/contacts/contact.h), sweeps and rounds alternate while both together still gain.
// (2) In a loose marker, where pieces travel far and the way decides where they end, the sweeps also start from where
//     the rounds started, rounds follow, and the shorter answer is kept.
// (3) In a tight marker of few pieces, sweeps alone start from there, too.  Rounds follow only when the sweeps leave it
//     shorter than the rounds did, which is rare.
// A tight marker of more pieces that the rounds shorten, or that they leave at firm contacts only, needs none of them.
// A turn of sweeps counts as one round, except where (3) gains nothing.
//
// All of this starts from where the pieces were given.  From where they end up, programs with the full trust radius and
// new sweeps may find another way.  So a marker of few pieces, and a loose one of not too many (CompactionTuning), is
// compacted again from there, until several times in a row nothing is gained or no piece moves.  Compactions that gain
// nothing are undone: they count as programs, but not as rounds.
#pragma once

#include <cstddef>

#include "core/motion/compaction/compact.h"

namespace selvage::motion::compaction {

inline constexpr std::size_t kFewPieces = 24;  // whose sweeps take milliseconds

// Closes large gaps (core/motion/closing); then rounds towards the goal (improve_divided.h), and sweeps as above where
// the settings allow them.  Law: the answer is never longer than that of sweeps alone, unless cancelled, in a marker of
// few pieces and in a loose one of not too many (CompactionTuning).
// REQUIRES: the goal shortens the marker; the scene's pieces are valid.
[[nodiscard]] Progress shorten(scene::Scene& scene, const step::Goal& goal, const CompactionSettings& settings,
                               const scene::Run& run);

}  // namespace selvage::motion::compaction
