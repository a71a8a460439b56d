#include "tests/motions/motion_cases.h"

#include <algorithm>

namespace selvage::test {

// The motions, in the order in which the soak draws them; each is defined in a source of this folder.
#define SELVAGE_MOTION_CASES(X) \
  X(compact)                    \
  X(one_at_a_time)              \
  X(velocities)                 \
  X(refine)                     \
  X(swap)                       \
  X(nest)                       \
  X(pack)                       \
  X(contain)                    \
  X(fill)                       \
  X(exact_compaction)           \
  X(remake)                     \
  X(push)                       \
  X(gravity)                    \
  X(bump)                       \
  X(place)                      \
  X(turn_and_place)             \
  X(align)                      \
  X(drag)                       \
  X(separate)                   \
  X(float)                      \
  X(gap)                        \
  X(tilt)                       \
  X(relax)                      \
  X(critical_path)              \
  X(invalid_arguments)

#define SELVAGE_DECLARED(name) MotionCase name##_case();
SELVAGE_MOTION_CASES(SELVAGE_DECLARED)
#undef SELVAGE_DECLARED

const std::vector<MotionCase>& motion_cases() {
#define SELVAGE_LISTED(name) name##_case(),
  static const std::vector<MotionCase> cases{SELVAGE_MOTION_CASES(SELVAGE_LISTED)};
#undef SELVAGE_LISTED
  return cases;
}

const MotionCase& drawn_motion(Random& random) {
  std::size_t whole = 0;
  for (const MotionCase& motion : motion_cases()) whole += static_cast<std::size_t>(motion.weight);
  std::size_t drawn = random.below(whole);
  for (const MotionCase& motion : motion_cases()) {
    const auto weight = static_cast<std::size_t>(motion.weight);
    if (drawn < weight) return motion;
    drawn -= weight;
  }
  return motion_cases().back();
}

std::vector<OneRound> one_round_of_each() {
  std::vector<OneRound> rounds;
  for (const MotionCase& motion : motion_cases()) {
    rounds.insert(rounds.end(), motion.rounds.begin(), motion.rounds.end());
  }
  std::ranges::sort(rounds, {}, [](const OneRound& round) { return std::string_view{round.motion}; });
  return rounds;
}

Work work_of(const OneRound& round, const Marker& marker) {
  Work work;
  SumCache sums;
  scene::Run run{sums};
  run.observer.on_program = [&](const lp::LinearProgram& program) {
    const scene::ProgramSize size = scene::size_of(program);
    ++work.programs;
    work.largest.columns = std::max(work.largest.columns, size.columns);
    work.largest.rows = std::max(work.largest.rows, size.rows);
    work.largest.nonzeros = std::max(work.largest.nonzeros, size.nonzeros);
  };
  round.run(marker, run);
  work.sums = sums.counts().hits + sums.counts().misses;
  return work;
}

}  // namespace selvage::test
