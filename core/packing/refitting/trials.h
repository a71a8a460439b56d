// A local search over valid markers: trials one after another, each of which changes the present marker.  A change is
// kept when the marker is no longer than before: changes of equal length lead across plateaus.
//
// Trials are numbered, and a trial depends on its number and on the present marker only.  Threads run several at once,
// all from the same marker; of these, only those count that a sequential run would have tried: up to the first that is
// kept.  So the answer does not depend on the number of threads.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "core/marker/marker.h"
#include "core/motion/repair/motion_result.h"
#include "core/packing/branching/search.h"

namespace selvage::packing::refitting {

// What a trial came to.
struct Tried {
  std::optional<Marker> marker{};  // valid; or none
  branching::Work work{};
};
using Trial = std::function<Tried(const Marker& present, std::uint64_t number, const scene::Run& run)>;
// Called with the marker that the next trials begin with; not concurrently.
using OnPresent = std::function<void(const Marker& present)>;

struct TrialCounts {
  std::uint64_t trials{}, shortened{};  // shortened: those that made the marker shorter
  branching::Work work;
};

// Runs trials from `best.marker` until there were `most`, or `fruitless` in a row that gained nothing, or it is
// stopped.  A marker that is no longer than the present one becomes the present one, and `best` is the shortest of
// them.  Every trial is a round.  Sets the reason of `best`.
[[nodiscard]] TrialCounts run_trials(motion::repair::MotionResult& best, std::uint64_t most, std::uint64_t fruitless,
                                     const Trial& trial, const OnPresent& on_present, const scene::Run& run);

}  // namespace selvage::packing::refitting
