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

constexpr int kExchangeRounds = 2;         // of compaction after an exchange: most of what can be gained
constexpr std::uint64_t kIdleTrials = 50;  // trials in a row that solve nothing: there is nothing to exchange

scene::Observer stages_of(const scene::Observer& observer) {
  scene::Observer stages;
  stages.on_stage = observer.on_stage;
  stages.on_program = observer.on_program;
  stages.executor = observer.executor;
  return stages;
}

// An exchange on trial.
struct Trial {
  std::optional<DrawnExchange> drawn;
  std::mt19937 random;  // as drawing it left it
  Exchanged exchanged{};
  Coord length{};           // of the marker that came of it, if any
  std::stop_source stop{};  // nobody asks for it any more
};

// Settings that differ from standard in one thing each.
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
  Refiner(const Marker& start, const RefineSettings& settings, SumCache& sums, const std::stop_token& stop,
          const scene::Observer& observer, motion::compaction::Compaction& best)
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
    best_.reason = stop_.stop_requested() ? scene::StopReason::kCancelled : scene::StopReason::kWorkLimit;
  }

 private:
  void attempted() { observer_.on_round({++best_.rounds, best_.length_after}); }
  void keep(Marker marker, Coord length) {
    best_.marker = std::move(marker);
    best_.length_after = length;
  }

  void try_other_ways() {
    const auto others = other_settings();
    const std::size_t wanted = std::min(static_cast<std::size_t>(std::max(0, settings_.other_ways)), others.size());
    for (std::size_t first = 0; first < wanted && !stop_.stop_requested();) {
      const std::size_t count = std::min(at_once(), wanted - first);
      std::array<std::optional<motion::compaction::Compaction>, std::tuple_size_v<decltype(others)>> found;
      observer_.executor->for_each(count, [&](std::size_t k) {
        auto compaction = compact(start_, others[first + k], sums_, stop_, count == 1 ? stages_ : scene::Observer{});
        if (compaction) found[k] = *std::move(compaction);
      });
      for (std::size_t k = 0; k < count && (k == 0 || !stop_.stop_requested()); ++k) {
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

  // Exchanges of the best marker so far, several at once; of them those count that one hand would have tried: up to the
  // first that is kept, for the next is one of the new marker.
  void try_exchanges() {
    std::mt19937 random{settings_.seed};
    std::uint64_t spent = 0;
    std::uint64_t idle = 0;
    const auto enough = [&] { return spent >= settings_.effort || idle >= kIdleTrials || stop_.stop_requested(); };
    while (!enough()) {
      std::vector<Trial> trials = drawn(at_once(), random);
      observer_.executor->for_each(trials.size(), [&](std::size_t k) { run(trials, k); });
      for (Trial& trial : trials) {
        random = trial.random;
        const int programs = trial.exchanged.programs;
        idle = programs == 0 ? idle + 1 : 0;
        spent += static_cast<std::uint64_t>(programs) * start_.pieces.size();
        best_.programs += programs;
        const bool kept = worth_keeping(trial);
        if (kept) keep(*std::move(trial.exchanged.marker), trial.length);
        attempted();
        if (kept || enough()) break;
      }
    }
  }
  [[nodiscard]] std::vector<Trial> drawn(std::size_t count, std::mt19937 random) const {
    std::vector<Trial> trials;
    while (trials.size() < count) {
      auto exchange = draw_exchange(best_.marker, random);
      trials.push_back({std::move(exchange), random});
    }
    return trials;
  }
  void run(std::vector<Trial>& trials, std::size_t k) const {
    Trial& trial = trials[k];
    if (!trial.drawn) return;
    const std::stop_callback with_all{stop_, [&trial] { trial.stop.request_stop(); }};
    motion::compaction::CompactionSettings quick = compaction_settings(motion::compaction::Accuracy::kStandard);
    quick.rounds = kExchangeRounds;
    quick.solver_tolerance = 0;  // what is only nearly as short is not taken for a way over a plateau
    trial.exchanged = exchange(*trial.drawn, quick, sums_, trial.stop.get_token());
    if (trial.exchanged.marker) trial.length = length_of(*trial.exchanged.marker);
    if (!worth_keeping(trial)) return;
    for (std::size_t later = k + 1; later < trials.size(); ++later) trials[later].stop.request_stop();
  }
  // Equal lengths are kept too: they are ways over a plateau.
  [[nodiscard]] bool worth_keeping(const Trial& trial) const {
    return trial.exchanged.marker && trial.length <= best_.length_after;
  }
  [[nodiscard]] std::size_t at_once() const { return observer_.executor->parallelism(); }

  void try_tilts() {
    const bool any = std::any_of(start_.shapes.begin(), start_.shapes.end(),
                                 [](const Shape& shape) { return shape.tilt_limit.degrees > 0; });
    if (!any || stop_.stop_requested()) return;
    const motion::tilting::TiltSettings tilt_settings_used =
        tilt_settings(motion::tilting::TiltMethod::kLinearisation, motion::compaction::Accuracy::kStandard);
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
  const scene::Observer& observer_;
  scene::Observer stages_;  // for the motions within an attempt, whose rounds are not ours
  motion::compaction::Compaction& best_;
};

}  // namespace

RefineSettings refine_settings() {
  return {.other_ways = 4, .effort = 120'000, .tilts = true, .seed = 1, .most_exchanged = 300};
}

Result<motion::compaction::Compaction> refine(const Marker& start, const RefineSettings& settings, SumCache& sums,
                                              std::stop_token stop, const scene::Observer& observer) {
  auto best =
      compact(start, compaction_settings(motion::compaction::Accuracy::kStandard), sums, stop, stages_of(observer));
  if (!best) return best.error();
  if (best->reason != scene::StopReason::kCancelled) Refiner{start, settings, sums, stop, observer, *best}.run();
  best->utilisation_after = utilisation_of(best->marker);
  return best;
}

}  // namespace selvage::search
