// The tuning constants of nesting as a whole.  Lengths are parts of the marker's length.  The constants of the local
// search are in local_search/tuning.h; docs/measurements/sensitivity.md shows what halving and doubling them does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/nesting/batches/batches.h"
#include "core/nesting/filling/tuning.h"
#include "core/nesting/local_search/tuning.h"

namespace selvage::nesting {

struct NestTuning {
  double first_step{0.02};        // the first attempts shorten the layout by this part,
  double step_factor{0.4};        // after each failure by the last part times this,
  double least_step{0.001};       // down to this part; when that fails, too, the search has stalled (exploration.h)
  std::size_t bold_patience{60};  // iterations without progress that end an attempt while steps are larger than that
  // A walk visits markers that are longer than the best one by no more than this part, and gives a step up after so
  // many moves: nine tenths of the steps that succeed take fewer, and those that fail would take about a thousand.
  double walk_slack{0.0015};
  std::uint64_t walk_moves{60};
  double same_place{0.005};  // of the width: within this distance a piece has returned to its place
  // A turn of walking or of attempts takes so many moves.  The layouts of failed attempts that overlap least are kept.
  std::uint64_t turn_moves{200'000};
  std::size_t pool{50};
  double pool_skew{3};
  double explored{0.8};        // part of the budget; the rest is for compression:
  double first_squeeze{5e-4};  // attempts that shorten the best layout by this part,
  double last_squeeze{1e-5};   // at the end by this one,
  std::size_t squeeze_patience{100}, squeeze_strikes{5};
  // A search ends after this many moves if they have shortened the marker by no more than this part.
  std::uint64_t moves_in_vain{std::numeric_limits<std::uint64_t>::max()};
  double least_gain{0};
  std::uint64_t first_epoch{2'000};  // moves of the first exploration with its compression; later ones double it
  // A start makes this many moves before it is compared with another one (race.h).
  std::uint64_t raced_moves{200'000};
  // With a time limit it makes as many as several starts can make in this part of it, within these bounds.  Later, new
  // starts are made when the best one, while it made as many moves again, gained no more than this part of its length.
  double raced{0.25};
  std::uint64_t least_raced_in_time{20'000}, most_raced_in_time{60'000};
  double raced_gain{0.001};
  double shared{0.5};  // part of a time limit after which searches go on from the best marker of all
  // Part of the budget after which a search no longer tries to fit all pieces before the cloth's end, but chooses which
  // of them lie on it: when their area is less than the cloth's, and when it is not.
  double end_patience{0.5}, hopeless_patience{0.1};
  double searched{0.9};       // part of a time limit that the search has when small rotations may follow it
  int separation_rounds{12};  // when repair cannot remove what the search has left
  // Parts that may be left out to see what they bring; not both of the first two.
  bool walks{true}, attempts{true};        // of searches that have stalled
  std::optional<int> compaction_rounds{};  // of every marker that is found; nothing: as accuracy `standard`
  std::size_t most_pieces{2'000};          // larger sets are nested in batches
  // Of the sampled maps of a search, and of all searches that run at the same time; fields that are kept take up to an
  // eighth more.  Besides, a search has 8 bytes for each pair of pieces, and 20 MB at most for the field of a piece
  // that is inserted (local_search/mover.cpp).
  std::size_t map_bytes{std::size_t{192} << 20}, all_map_bytes{std::size_t{768} << 20};
  local_search::SearchTuning search{};
  filling::FillTuning fill{};
  batches::BatchTuning batches{};
  friend bool operator==(const NestTuning&, const NestTuning&) = default;
};

}  // namespace selvage::nesting
