#include "core/search/refine.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "core/marker/figures.h"
#include "core/marker/placed_pieces.h"
#include "core/model/ties.h"
#include "core/motion/tilting/tilt.h"
#include "core/search/effort.h"
#include "core/search/renesting.h"
#include "core/search/swap_search.h"

namespace selvage::search {
namespace {

// Settings that differ from the standard ones in one value each.
std::array<motion::compaction::CompactionSettings, 4> other_settings() {
  std::array<motion::compaction::CompactionSettings, 4> others;
  others.fill(compaction_settings(motion::compaction::Accuracy::kStandard));
  others[0].region = model::RegionRule::kWalk;
  others[1].trust = 0.3;
  others[2].trust = 1;
  others[3].gravity = 0.03;
  return others;
}

class Refiner {
 public:
  Refiner(const Marker& start, const RefineSettings& settings, const scene::Run& run,
          motion::compaction::Compaction& best)
      : start_{start}, settings_{settings}, run_{run}, quiet_{run.quiet()}, best_{best} {
    tilts_ = settings.tilts && std::any_of(start.shapes.begin(), start.shapes.end(),
                                           [](const Shape& shape) { return shape.tilt_limit.degrees > 0; });
  }

  void run() {
    best_.rounds = 0;
    attempted();
    const Coord standard = best_.length_after;
    try_variants();
    Found straight{best_.marker, best_.length_after};
    Effort effort{settings_.least_effort, settings_.effort, standard};
    if (settings_.nests && may_gain()) nest(straight, effort);
    // Of the marker refined so far, and of the start: tilts may find their way from the one and not from the other.
    if (tilts_) tilt_and_keep(straight.marker);
    if (tilts_) tilt_and_keep(start_);
    effort.spend(0, best_.length_after);
    if (start_.pieces.size() <= settings_.most_pieces_swapped && may_gain()) try_swaps(std::move(straight), effort);
    best_.reason = run_.stopped() ? scene::StopReason::kCancelled : scene::StopReason::kWorkLimit;
  }

 private:
  void attempted() { run_.observer.on_round({++best_.rounds, best_.length_after}); }
  void keep(Marker marker, Coord length) {
    best_.marker = std::move(marker);
    best_.length_after = length;
  }

  void try_variants() {
    const auto others = other_settings();
    const std::size_t wanted = std::min(static_cast<std::size_t>(std::max(0, settings_.variants)), others.size());
    for (std::size_t first = 0; first < wanted && !run_.stopped();) {
      const std::size_t count = std::min(at_once(), wanted - first);
      std::array<std::optional<motion::compaction::Compaction>, std::tuple_size_v<decltype(others)>> found;
      run_.executor->for_each(count, [&](std::size_t k) {
        auto compaction = compact(start_, others[first + k], count == 1 ? quiet_ : scene::Run{run_.sums, run_.stop});
        if (compaction) found[k] = *std::move(compaction);
      });
      for (std::size_t k = 0; k < count && (k == 0 || !run_.stopped()); ++k) {
        if (found[k]) judge(*std::move(found[k]));
      }
      first += count;
    }
  }
  void judge(motion::compaction::Compaction compaction) {
    best_.programs += compaction.programs;
    if (compaction.length_after < best_.length_after) {
      best_.repair = compaction.repair;
      keep(std::move(compaction.marker), compaction.length_after);
    }
    attempted();
  }

  // Nesting from where the pieces lie in the best marker without new tilts.
  void nest(Found& straight, Effort& effort) {
    if (run_.stopped()) return;
    const RenestingTuning& tuning = settings_.tuning.renesting;
    const std::uint64_t moves = tuning.moves * start_.pieces.size();
    RenestingSettings nesting{
        .moves = moves, .moves_in_vain = moves, .least_gain = tuning.least_gain, .seed = settings_.seed};
    if (settings_.elapsed) {
      nesting.moves = std::numeric_limits<std::uint64_t>::max();
      nesting.elapsed = [&, begin = settings_.elapsed()] {
        return begin < tuning.until ? (settings_.elapsed() - begin) / (tuning.until - begin) : 1;
      };
    } else {
      const double affordable = static_cast<double>(settings_.effort) / tuning.work_of_move;
      nesting.moves = std::min(nesting.moves, static_cast<std::uint64_t>(affordable));
    }
    const Renesting done = renest(straight, nesting, quiet_);
    best_.programs += done.programs;
    if (straight.length < best_.length_after) keep(straight.marker, straight.length);
    const double work = tuning.work_of_move * static_cast<double>(done.moves);
    effort.spend(static_cast<std::uint64_t>(work) + static_cast<std::uint64_t>(done.programs) * start_.pieces.size(),
                 best_.length_after);
    attempted();
  }

  // Swaps in the best marker without new tilts and, where tilts are allowed, in the best marker of all, in turn.
  void try_swaps(Found straight, Effort& effort) {
    Found* swapped = &straight;
    SwapSearch swaps{settings_.seed, settings_.tuning, run_, [&](int programs, bool kept) {
                       best_.programs += programs;
                       if (kept && swapped->length < best_.length_after) keep(swapped->marker, swapped->length);
                       attempted();
                     }};
    Found tilted{best_.marker, best_.length_after};
    Coord tilted_from = straight.length;
    while (!effort.enough() && !swaps.exhausted() && !run_.stopped()) {
      swapped = &straight;
      swaps.search(straight, false, effort.spent() + settings_.tuning.turn, effort);
      if (!tilts_) continue;
      if (straight.length < tilted_from) {
        tilted_from = straight.length;
        effort.spend(tilt_and_keep(straight.marker) * start_.pieces.size(), best_.length_after);
      }
      if (best_.length_after < tilted.length) tilted = {best_.marker, best_.length_after};
      swapped = &tilted;
      swaps.search(tilted, true, effort.spent() + settings_.tuning.turn, effort);
    }
  }

  // False when no search can shorten the marker: a locked piece ends it, or the pieces fill it.
  [[nodiscard]] bool may_gain() const {
    const marker::PlacedPieces pieces{best_.marker};
    const model::Ties ties = model::ties_of(best_.marker);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (ties.x[i] == model::Ties::kFixed && pieces.end_of(i) == best_.length_after) return false;
    }
    return utilisation_of(best_.marker) < 1 - settings_.tuning.least_room;
  }

  // Returns the number of programs solved.
  std::uint64_t tilt_and_keep(const Marker& marker) {
    if (run_.stopped()) return 0;
    const motion::tilting::TiltSettings tilt_settings_used =
        tilt_settings(motion::tilting::TiltMethod::kLinearisation, motion::compaction::Accuracy::kStandard);
    auto tilting = tilt(marker, tilt_settings_used, quiet_);
    if (!tilting) return 0;
    best_.programs += tilting->programs;
    if (tilting->length_after < best_.length_after) keep(std::move(tilting->marker), tilting->length_after);
    attempted();
    return static_cast<std::uint64_t>(tilting->programs);
  }
  [[nodiscard]] std::size_t at_once() const { return run_.executor->parallelism(); }

  const Marker& start_;
  const RefineSettings& settings_;
  const scene::Run& run_;
  const scene::Run quiet_;  // for the motions within an attempt, whose own rounds are not reported
  motion::compaction::Compaction& best_;
  bool tilts_{};  // tilts are wanted, and some shape allows them
};

}  // namespace

RefineSettings refine_settings() {
  return {.variants = 4,
          .effort = 150'000,
          .least_effort = 100'000,
          .tilts = true,
          .nests = true,
          .seed = 1,
          .most_pieces_swapped = 300};
}

Result<motion::compaction::Compaction> refine(const Marker& start, const RefineSettings& settings,
                                              const scene::Run& run) {
  auto best = compact(start, compaction_settings(motion::compaction::Accuracy::kStandard), run.quiet());
  if (!best) return best.error();
  if (best->reason != scene::StopReason::kCancelled) Refiner{start, settings, run, *best}.run();
  best->utilisation_after = utilisation_of(best->marker);
  return best;
}

}  // namespace selvage::search
