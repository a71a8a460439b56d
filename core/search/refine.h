// Refinement: compaction when length matters more than time; what accuracy `fine` means for a whole marker.
//
// Standard compaction first; then from the same start with other region rules, trusts and weights of gravity, for where
// a descent ends depends on its way; then exchanges of pieces (core/motion/exchange.h), one after another, each kept
// when the marker is no longer for it; at last, where shapes allow tilts, tilting (core/motion/tilt.h).  Several hands
// try several exchanges at once, of which those count that one hand would have tried.
//
// Laws.  (1) The answer is valid, proved in integers.  (2) It is never longer than what standard compaction answers,
// unless asked to stop before that was done; nor than the input, but for healing.  (3) Locked pieces stay to the
// lattice unit, groups stay rigid, tilts and rotations are those that shapes allow.  (4) Same input and settings, same
// answer, whatever the cache holds and however many hands there are.  (5) Asked to stop, it answers with the best so
// far.
#pragma once

#include <cstdint>

#include "core/base/result.h"
#include "core/motion/compaction/compact.h"
#include "core/search/tuning.h"

namespace selvage::search {

struct RefineSettings {
  int other_ways{};        // so many other region rules, trusts and weights of gravity are tried, at most 4
  std::uint64_t effort{};  // exchanges go on until the pieces of all programs they solved are so many
  bool tilts{};            // where shapes allow them
  std::uint32_t seed{};    // of the exchanges
  std::size_t most_exchanged{marker::kMaxPieces};  // of markers with more pieces none are exchanged
  RefineTuning tuning{};
  friend bool operator==(const RefineSettings&, const RefineSettings&) = default;
};
// Figures behind these: docs/measurements-trade.md.
[[nodiscard]] RefineSettings refine_settings();

// The search has no end of its own: it stops with kWorkLimit, or kCancelled.  A round of the answer, and of the
// observer, is one attempt, whether it gained or not. Errors: those of heal.
[[nodiscard]] Result<motion::compaction::Compaction> refine(const Marker& start, const RefineSettings& settings,
                                                            const scene::Run& run);

}  // namespace selvage::search
