#include "core/motion/refine.h"

#include <algorithm>
#include <array>
#include <random>
#include <utility>

#include "core/marker/validity.h"
#include "core/motion/exchange.h"
#include "core/motion/tilt.h"

namespace selvage {
namespace {

constexpr int kExchangeRounds = 2;         // of compaction after an exchange: most of what can be gained
constexpr std::uint64_t kIdleTrials = 50;  // trials in a row that solve nothing: there is nothing to exchange

Observer stages_of(const Observer& observer) {
  Observer stages;
  stages.on_stage = observer.on_stage;
  stages.on_program = observer.on_program;
  return stages;
}

// Settings that differ from standard in one thing each.
std::array<CompactionSettings, 4> other_settings() {
  std::array<CompactionSettings, 4> others;
  others.fill(compaction_settings(Accuracy::kStandard));
  others[0].region = RegionRule::kWalk;
  others[1].trust = 0.3;
  others[2].trust = 1;
  others[3].gravity = 0.03;
  return others;
}

class Refiner {
 public:
  Refiner(const Marker& start, const RefineSettings& settings, SumCache& sums, const std::stop_token& stop,
          const Observer& observer, Compaction& best)
      : start_{start},
        settings_{settings},
        sums_{sums},
        stop_{stop},
        observer_{observer},
        stages_{stages_of(observer)},
        best_{best} {}

  void run() {
    best_.rounds = 0;
    attempted();
    try_other_ways();
    if (start_.pieces.size() <= settings_.most_exchanged) try_exchanges();
    if (settings_.tilts) try_tilts();
    best_.reason = stop_.stop_requested() ? StopReason::kCancelled : StopReason::kWorkLimit;
  }

 private:
  void attempted() { observer_.on_round({++best_.rounds, best_.length_after}); }
  void keep(Marker marker, Coord length) {
    best_.marker = std::move(marker);
    best_.length_after = length;
  }

  void try_other_ways() {
    const auto others = other_settings();
    const int count = std::clamp(settings_.other_ways, 0, static_cast<int>(others.size()));
    for (int k = 0; k < count; ++k) {
      if (stop_.stop_requested()) return;
      auto compaction = compact(start_, others[static_cast<std::size_t>(k)], sums_, stop_, stages_);
      if (!compaction) continue;
      best_.programs += compaction->programs;
      if (compaction->length_after < best_.length_after) {
        best_.healing = compaction->healing;
        keep(std::move(compaction->marker), compaction->length_after);
      }
      attempted();
    }
  }

  void try_exchanges() {
    std::mt19937 random{settings_.seed};
    CompactionSettings quick = compaction_settings(Accuracy::kStandard);
    quick.rounds = kExchangeRounds;
    std::uint64_t spent = 0;
    for (std::uint64_t idle = 0; spent < settings_.effort && idle < kIdleTrials && !stop_.stop_requested();) {
      auto exchanged = exchange(best_.marker, quick, random, sums_, stop_);
      idle = exchanged.programs == 0 ? idle + 1 : 0;
      spent += static_cast<std::uint64_t>(exchanged.programs) * start_.pieces.size();
      best_.programs += exchanged.programs;
      if (exchanged.marker) {
        // Equal lengths are kept too: they are ways over a plateau.
        if (const Coord length = length_of(*exchanged.marker); length <= best_.length_after) {
          keep(std::move(*exchanged.marker), length);
        }
      }
      attempted();
    }
  }

  void try_tilts() {
    const bool any = std::any_of(start_.shapes.begin(), start_.shapes.end(),
                                 [](const Shape& shape) { return shape.tilt_limit.degrees > 0; });
    if (!any || stop_.stop_requested()) return;
    const TiltSettings tilt_settings_used = tilt_settings(TiltMethod::kLinearisation, Accuracy::kStandard);
    auto tilting = tilt(best_.marker, tilt_settings_used, sums_, stop_, stages_);
    if (!tilting) return;
    best_.programs += tilting->programs;
    if (tilting->length_after < best_.length_after) keep(std::move(tilting->marker), tilting->length_after);
    attempted();
  }

  const Marker& start_;
  const RefineSettings& settings_;
  SumCache& sums_;
  const std::stop_token& stop_;
  const Observer& observer_;
  Observer stages_;  // for the motions within an attempt, whose rounds are not ours
  Compaction& best_;
};

}  // namespace

RefineSettings refine_settings() {
  return {.other_ways = 4, .effort = 120'000, .tilts = true, .seed = 1, .most_exchanged = 300};
}

Result<Compaction> refine(const Marker& start, const RefineSettings& settings, SumCache& sums, std::stop_token stop,
                          const Observer& observer) {
  auto best = compact(start, compaction_settings(Accuracy::kStandard), sums, stop, stages_of(observer));
  if (!best) return best.error();
  if (best->reason != StopReason::kCancelled) Refiner{start, settings, sums, stop, observer, *best}.run();
  best->utilisation_after = utilisation_of(best->marker);
  return best;
}

}  // namespace selvage
