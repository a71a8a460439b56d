#include "tests/laws/random_settings.h"

#include <array>

namespace selvage::test {

CompactionSettings random_settings(Random& random) {
  auto settings = compaction_settings(random.chance(50) ? Accuracy::kDraft : Accuracy::kStandard);
  settings.region = random.chance(20) ? RegionRule::kWalk : RegionRule::kGreedy;
  settings.solver = random.chance(20) ? SolverChoice::kSimplex : SolverChoice::kAutomatic;
  constexpr std::array kTrusts{0.02, 0.1, 1.0};
  settings.trust = kTrusts[random.below(kTrusts.size())];
  constexpr std::array kSimplifications{0.0, 1e-4, 1e-2};
  if (random.chance(30)) settings.simplification = kSimplifications[random.below(kSimplifications.size())];
  constexpr std::array kTolerances{0.0, 1e-3, 1e-1};
  settings.solver_tolerance = kTolerances[random.below(kTolerances.size())];
  return settings;
}

}  // namespace selvage::test
