#include "core/planning/making/nested_markers.h"

#include <utility>

#include "core/marker/figures.h"
#include "core/nesting/nest.h"

namespace selvage::planning::making {

Arrange nest_from_nothing(const NestingEffort& effort) {
  return [effort](const Marker& unplaced, const scene::Run& run) -> Result<Marker> {
    nesting::NestSettings settings;
    settings.moves = effort.moves_per_piece * unplaced.unplaced.size();
    settings.seed = effort.seed;
    settings.from_scratch = true;
    auto nested = nesting::nest(unplaced, settings, run);
    if (!nested) return nested.error();
    return std::move(nested->marker);
  };
}

std::optional<double> MadeMarkers::make(const orders::Ratio& ratio) {
  const Marker unplaced = bundles_of(garments_, ratio);
  // The observer belongs to the plan, and several markers may be made at a time: each by one thread.
  auto marker = arrange_(unplaced, scene::Run{run_.sums, run_.stop});
  if (!marker || run_.stopped()) return std::nullopt;
  const marker::Figures figures = marker::figures_of(*marker);
  if (!marker->unplaced.empty() || !figures.valid) return std::nullopt;
  const std::scoped_lock lock{mutex_};
  made_.insert_or_assign(ratio, *std::move(marker));
  return to_decimal(figures.length, garments_.style.resolution);
}

const Marker* MadeMarkers::find(const orders::Ratio& ratio) const {
  const std::scoped_lock lock{mutex_};
  const auto found = made_.find(ratio);
  return found == made_.end() ? nullptr : &found->second;
}

}  // namespace selvage::planning::making
