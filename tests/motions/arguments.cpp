#include "tests/motions/arguments.h"

#include <array>

namespace selvage::test {

motion::compaction::CompactionSettings random_settings(Random& random) {
  auto settings = compaction_settings(random.chance(50) ? motion::compaction::Accuracy::kDraft
                                                        : motion::compaction::Accuracy::kStandard);
  settings.region = random.chance(20) ? model::RegionRule::kWalk : model::RegionRule::kGreedy;
  settings.solver = random.chance(20) ? lp::solver::SolverChoice::kSimplex : lp::solver::SolverChoice::kAutomatic;
  constexpr std::array kTrusts{0.02, 0.1, 1.0};
  settings.trust = kTrusts[random.below(kTrusts.size())];
  constexpr std::array kSimplifications{0.0, 1e-4, 1e-2};
  if (random.chance(30)) settings.simplification = kSimplifications[random.below(kSimplifications.size())];
  constexpr std::array kTolerances{0.0, 1e-3, 1e-1};
  settings.solver_tolerance = kTolerances[random.below(kTolerances.size())];
  return settings;
}

}  // namespace selvage::test
