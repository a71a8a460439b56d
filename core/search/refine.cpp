#include "core/search/refine.h"

#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include "core/marker/validity.h"
#include "core/motion/tilting/tilt.h"
#include "core/search/swap.h"

namespace selvage::search {
namespace {

// A swap on trial.
struct Trial {
  std::optional<DrawnSwap> drawn;
  std::mt19937 random;  // the generator's state after drawing the swap
  SwapOutcome outcome{};
  Coord length{};           // of the marker after the swap, if there is one
  std::stop_source stop{};  // its result is no longer needed
};

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
      : start_{start}, settings_{settings}, run_{run}, quiet_{run.quiet()}, best_{best} {}

  void run() {
    best_.rounds = 0;
    attempted();
    try_variants();
    if (start_.pieces.size() <= settings_.most_pieces_swapped) try_swaps();
    if (settings_.tilts) try_tilts();
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

  // Swaps in the best marker so far, several in parallel.  Only those count that a sequential run would have tried: up
  // to the first one that is kept, because the next one starts from the new marker.
  void try_swaps() {
    std::mt19937 random{settings_.seed};
    std::uint64_t spent = 0;
    std::uint64_t idle = 0;
    const auto enough = [&] {
      return spent >= settings_.effort || idle >= settings_.tuning.idle_trials || run_.stopped();
    };
    while (!enough()) {
      std::vector<Trial> trials = drawn(at_once(), random);
      run_.executor->for_each(trials.size(), [&](std::size_t k) { run(trials, k); });
      for (Trial& trial : trials) {
        random = trial.random;
        const int programs = trial.outcome.programs;
        idle = programs == 0 ? idle + 1 : 0;
        spent += static_cast<std::uint64_t>(programs) * start_.pieces.size();
        best_.programs += programs;
        const bool kept = worth_keeping(trial);
        if (kept) keep(*std::move(trial.outcome.marker), trial.length);
        attempted();
        if (kept || enough()) break;
      }
    }
  }
  [[nodiscard]] std::vector<Trial> drawn(std::size_t count, std::mt19937 random) const {
    std::vector<Trial> trials;
    while (trials.size() < count) {
      auto swap = draw_swap(best_.marker, random, settings_.tuning.swap);
      trials.push_back({std::move(swap), random});
    }
    return trials;
  }
  void run(std::vector<Trial>& trials, std::size_t k) const {
    Trial& trial = trials[k];
    if (!trial.drawn) return;
    const std::stop_callback with_all{run_.stop, [&trial] { trial.stop.request_stop(); }};
    motion::compaction::CompactionSettings quick = compaction_settings(motion::compaction::Accuracy::kStandard);
    quick.rounds = settings_.tuning.compaction_rounds;
    quick.solver_tolerance = 0;  // a marker that is only nearly as short must not count as one on the plateau
    trial.outcome = complete_swap(*trial.drawn, quick, {run_.sums, trial.stop.get_token()}, settings_.tuning.swap);
    if (trial.outcome.marker) trial.length = length_of(*trial.outcome.marker);
    if (!worth_keeping(trial)) return;
    for (std::size_t later = k + 1; later < trials.size(); ++later) trials[later].stop.request_stop();
  }
  // Markers of equal length are kept, too: they lead across plateaus.
  [[nodiscard]] bool worth_keeping(const Trial& trial) const {
    return trial.outcome.marker && trial.length <= best_.length_after;
  }
  [[nodiscard]] std::size_t at_once() const { return run_.executor->parallelism(); }

  void try_tilts() {
    const bool any = std::any_of(start_.shapes.begin(), start_.shapes.end(),
                                 [](const Shape& shape) { return shape.tilt_limit.degrees > 0; });
    if (!any || run_.stopped()) return;
    // Of the marker refined so far, and of the start: tilts may find their way from the one and not from the other.
    tilt_and_keep(best_.marker);
    if (!run_.stopped()) tilt_and_keep(start_);
  }
  void tilt_and_keep(const Marker& marker) {
    const motion::tilting::TiltSettings tilt_settings_used =
        tilt_settings(motion::tilting::TiltMethod::kLinearisation, motion::compaction::Accuracy::kStandard);
    auto tilting = tilt(marker, tilt_settings_used, quiet_);
    if (!tilting) return;
    best_.programs += tilting->programs;
    if (tilting->length_after < best_.length_after) keep(std::move(tilting->marker), tilting->length_after);
    attempted();
  }

  const Marker& start_;
  const RefineSettings& settings_;
  const scene::Run& run_;
  const scene::Run quiet_;  // for the motions within an attempt, whose own rounds are not reported
  motion::compaction::Compaction& best_;
};

}  // namespace

RefineSettings refine_settings() {
  return {.variants = 4, .effort = 120'000, .tilts = true, .seed = 1, .most_pieces_swapped = 300};
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
