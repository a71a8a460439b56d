#include "core/nesting/filling/proved_layout.h"

#include <utility>

#include "core/motion/separation/separate.h"

namespace selvage::nesting::filling {

std::optional<motion::compaction::Compaction> proved(const Marker& marker, const ProvingLimits& limits,
                                                     const scene::Run& run) {
  namespace compaction = motion::compaction;
  auto settings = compaction_settings(compaction::Accuracy::kStandard);
  settings.rounds = limits.compaction_rounds.value_or(settings.rounds);
  settings.tuning.repeated_in_vain = 0;  // the search goes on from here anyway
  const scene::Run quiet = run.quiet();
  auto compacted = compact(marker, settings, quiet);
  if (compacted) return *std::move(compacted);
  motion::separation::SeparationSettings separation;
  separation.rounds = limits.separation_rounds;
  const auto separated = motion::separation::separate(marker, separation, quiet);
  if (!separated || !separated->apart) return std::nullopt;
  compacted = compact(separated->marker, settings, quiet);
  if (!compacted) return std::nullopt;
  compacted->programs += separated->programs;
  return *std::move(compacted);
}

}  // namespace selvage::nesting::filling
