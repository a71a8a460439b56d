#include "protocol/messages.h"

#include "protocol/formats/decimal_marker.h"

namespace selvage {

std::string_view name_of(StopReason reason) {
  return kStopNames[static_cast<std::size_t>(reason)];
}

CompactionSettings settings_of(Accuracy accuracy, std::optional<int> rounds) {
  CompactionSettings settings = compaction_settings(accuracy);
  settings.rounds = rounds.value_or(settings.rounds);
  return settings;
}

CompactionFigures figures_of(const Compaction& compaction, const StageTimes& times,
                             const CacheCounts& cache) {
  const Marker& marker = compaction.marker;
  return {.name = marker.name,
          .pieces = marker.pieces.size(),
          .length_before = to_decimal(compaction.length_before, marker.resolution),
          .length_after = to_decimal(compaction.length_after, marker.resolution),
          .utilisation_before = compaction.utilisation_before,
          .utilisation_after = compaction.utilisation_after,
          .rounds = compaction.rounds,
          .stop = compaction.reason,
          .valid = is_valid(marker),
          .healed_pairs = compaction.healing.pairs,
          .healed_protruding = compaction.healing.protruding,
          .healed_deepest = in_unit(compaction.healing.deepest, marker.resolution),
          .healed_farthest_move = to_decimal(compaction.healing.farthest_move, marker.resolution),
          .healed_lengthened = to_decimal(compaction.healing.lengthened, marker.resolution),
          .times = times,
          .cache = cache};
}

}  // namespace selvage
