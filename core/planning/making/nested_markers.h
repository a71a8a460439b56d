// The markers of a plan, made as the plan asks for them.
//
// How the pieces are laid out is a function: nesting from nothing is the standard one; one that remakes a stored marker
// may take its place.
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>

#include "core/base/result.h"
#include "core/marker/marker.h"
#include "core/planning/making/garments.h"
#include "core/planning/orders/ratio.h"
#include "core/scene/run.h"

namespace selvage::planning::making {

// From unplaced pieces to a valid marker of all of them.  Must be deterministic, and may be called by several threads.
using Arrange = std::function<Result<Marker>(const Marker& unplaced, const scene::Run& run)>;

struct NestingEffort {
  std::uint64_t moves_per_piece{60};  // budget of a search
  std::uint64_t seed{1};
};
[[nodiscard]] Arrange nest_from_nothing(const NestingEffort& effort);

class MadeMarkers {
 public:
  // REQUIRES: what they refer to outlives the markers.
  MadeMarkers(const Garments& garments, Arrange arrange, const scene::Run& run)
      : garments_{garments}, arrange_{std::move(arrange)}, run_{run} {}

  // The length of the marker of this ratio, in millimetres; none when it cannot be made, or the run was stopped.  May
  // be called on any thread.
  [[nodiscard]] std::optional<double> make(const orders::Ratio& ratio);
  // The marker; null when it was not made.
  [[nodiscard]] const Marker* find(const orders::Ratio& ratio) const;

 private:
  const Garments& garments_;
  Arrange arrange_;
  const scene::Run& run_;
  mutable std::mutex mutex_;
  std::map<orders::Ratio, Marker> made_;
};

}  // namespace selvage::planning::making
