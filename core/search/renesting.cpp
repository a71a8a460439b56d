#include "core/search/renesting.h"

#include <utility>

#include "core/nesting/nest.h"

namespace selvage::search {

Renesting renest(Found& found, const RenestingSettings& settings, const scene::Run& run) {
  nesting::NestSettings nest_settings;
  nest_settings.moves = settings.moves;
  nest_settings.seed = settings.seed;
  nest_settings.elapsed = settings.elapsed;
  nest_settings.tuning.moves_in_vain = settings.moves_in_vain;
  nest_settings.tuning.least_gain = settings.least_gain;
  nest_settings.tilts = false;  // refinement tilts by itself
  Marker start = found.marker;
  start.unplaced.clear();
  auto nested = nest(start, nest_settings, run.quiet());
  if (!nested) return {};
  if (nested->length_after < found.length && nested->marker.unplaced.empty()) {
    nested->marker.unplaced = std::move(found.marker.unplaced);
    found = {std::move(nested->marker), nested->length_after};
  }
  return {nested->moves, nested->programs};
}

}  // namespace selvage::search
