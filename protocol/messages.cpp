#include "protocol/messages.h"

namespace selvage {

std::string_view name_of(StopReason reason) {
  return kStopNames[static_cast<std::size_t>(reason)];
}

CompactionSettings settings_of(const Effort& effort) {
  CompactionSettings settings = compaction_settings(effort.accuracy);
  settings.rounds = effort.rounds.value_or(settings.rounds);
  return settings;
}

}  // namespace selvage
