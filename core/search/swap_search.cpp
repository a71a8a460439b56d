#include "core/search/swap_search.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/marker/figures.h"
#include "core/motion/compaction/critical_path.h"
#include "core/motion/tilting/tilt.h"

namespace selvage::search {
namespace {

motion::compaction::CompactionSettings quick_compaction(const RefineTuning& tuning) {
  motion::compaction::CompactionSettings quick = compaction_settings(motion::compaction::Accuracy::kStandard);
  quick.rounds = tuning.compaction_rounds;
  quick.sweeps = false;        // they take longer than the rounds, and hardly ever gain here
  quick.solver_tolerance = 0;  // a marker that is only nearly as short must not count as one on the plateau
  return quick;
}

// A trial that solves no program takes about as long as an eighth of one.
std::uint64_t work_of(int programs, std::size_t pieces) {
  return programs == 0 ? pieces / 8 + 1 : static_cast<std::uint64_t>(programs) * pieces;
}

}  // namespace

struct SwapSearch::Trial {
  std::optional<DrawnSwap> drawn;
  std::mt19937 random;  // the generator's state after drawing the swap
  SwapOutcome outcome{};
  Coord length{};           // of the marker after the swap, if there is one
  std::stop_source stop{};  // its result is no longer needed
  // Markers of equal length are kept, too: they lead across plateaus.
  [[nodiscard]] bool is_worth_keeping(Coord best) const { return outcome.marker && length <= best; }
};

void SwapSearch::search(Found& found, bool tilted, std::uint64_t until, Effort& effort) {
  const auto over = [&] { return effort.enough() || effort.spent() >= until || exhausted() || run_.stopped(); };
  find_critical(found.marker);
  while (!over()) {
    std::vector<Trial> trials = drawn(run_.executor->parallelism(), found.marker);
    run_.executor->for_each(trials.size(), [&](std::size_t k) { make(trials, k, found.length, tilted); });
    for (Trial& trial : trials) {
      random_ = trial.random;
      const int programs = trial.outcome.programs;
      idle_ = programs == 0 ? idle_ + 1 : 0;
      const bool kept = trial.is_worth_keeping(found.length);
      if (kept) {
        found = {*std::move(trial.outcome.marker), trial.length};
        find_critical(found.marker);
      }
      effort.spend(work_of(programs, found.marker.pieces.size()), found.length);
      report_(programs, kept);
      if (kept || over()) break;
    }
  }
}

std::vector<SwapSearch::Trial> SwapSearch::drawn(std::size_t count, const Marker& marker) const {
  std::mt19937 random = random_;
  std::vector<Trial> trials;
  while (trials.size() < count) {
    auto swap = draw_swap(marker, random, critical_, tuning_.swap);
    trials.push_back({std::move(swap), random});
  }
  return trials;
}

void SwapSearch::make(std::vector<Trial>& trials, std::size_t k, Coord best, bool tilted) const {
  Trial& trial = trials[k];
  if (!trial.drawn) return;
  const std::stop_callback with_all{run_.stop, [&trial] { trial.stop.request_stop(); }};
  const scene::Run run{run_.sums, trial.stop.get_token()};
  trial.outcome = complete_swap(*trial.drawn, quick_compaction(tuning_), run, tuning_.swap);
  if (!trial.outcome.marker) return;
  trial.length = length_of(*trial.outcome.marker);
  const auto close = static_cast<Coord>((1 + tuning_.tilt_within) * static_cast<double>(best));
  if (tilted && trial.length <= close) tilt(trial, best, run);
  if (!trial.is_worth_keeping(best)) return;
  for (std::size_t later = k + 1; later < trials.size(); ++later) trials[later].stop.request_stop();
}

// Ends when the next rounds together would have to gain a multiple of what the last round has gained.
void SwapSearch::tilt(Trial& trial, Coord best, const scene::Run& run) const {
  using motion::tilting::TiltMethod;
  motion::tilting::TiltSettings settings =
      tilt_settings(TiltMethod::kLinearisation, motion::compaction::Accuracy::kStandard);
  settings.rounds = tuning_.tilt_rounds;
  settings.compaction = quick_compaction(tuning_);
  std::stop_source hopeless;
  const std::stop_callback with_trial{run.stop, [&hopeless] { hopeless.request_stop(); }};
  scene::Observer observer;
  observer.on_round = [&, before = trial.length](const scene::Round& round) mutable {
    const auto gain = static_cast<double>(before - round.length);
    before = round.length;
    if (static_cast<double>(round.length - best) > tuning_.hope * gain) hopeless.request_stop();
  };
  auto tilting = motion::tilting::tilt(*trial.outcome.marker, settings, {run.sums, hopeless.get_token(), observer});
  if (!tilting) return;
  trial.outcome.programs += tilting->programs;
  if (tilting->length_after >= trial.length) return;
  trial.length = tilting->length_after;
  trial.outcome.marker = std::move(tilting->marker);
}

void SwapSearch::find_critical(const Marker& marker) {
  critical_.clear();
  const auto path = motion::compaction::critical_path(marker, {run_.sums, run_.stop});
  if (!path) return;
  for (const motion::compaction::LoadedContact& contact : path->contacts) {
    critical_.push_back(contact.first);
    if (contact.second) critical_.push_back(*contact.second);
  }
  std::sort(critical_.begin(), critical_.end());
  critical_.erase(std::unique(critical_.begin(), critical_.end()), critical_.end());
}

}  // namespace selvage::search
