// Multiplies every tuning constant by a half and by two, one at a time, and prints Markdown tables of the effect
// on the answer and the processor time of its motion.  "Failed" is the number of additional markers without an
// answer.
//
// usage: sensitivity_table FAMILY MARKER...        FAMILY: compaction, separation, tilting, floating, search, nesting,
// walks or turns
//
// Sums are in the cache, so that only the motion itself is timed.  A run of all markers with the usual constants comes
// first and is repeated at the end: the difference of the two times is the machine's noise.
#include <cstdio>
#include <ctime>
#include <span>
#include <string>
#include <vector>

#include "bench/sensitivity/family.h"
#include "bench/support/marker_file.h"

namespace selvage::bench::sensitivity {
namespace {

struct Subject {
  Marker marker;
  SumCache sums;
};

// The runs of all markers with one value of one constant.
struct Runs {
  std::vector<Outcome> outcomes;
  double seconds{};
};

double own_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) / 1e9;
}

Runs run_all(const Constant& constant, double factor, std::span<Subject> subjects) {
  Runs runs;
  const double start = own_seconds();
  for (Subject& subject : subjects) runs.outcomes.push_back(constant.run(subject.marker, factor, subject.sums));
  runs.seconds = own_seconds() - start;
  return runs;
}

void print_cells(const Runs& runs, const Runs& usual) {
  double sum = 0;
  double worst = -1;
  int compared = 0;
  int lost = 0;
  for (std::size_t k = 0; k < runs.outcomes.size(); ++k) {
    lost += static_cast<int>(runs.outcomes[k].failed) - static_cast<int>(usual.outcomes[k].failed);
    if (runs.outcomes[k].failed || usual.outcomes[k].failed) continue;
    const double change = 100 * (runs.outcomes[k].result / usual.outcomes[k].result - 1);
    sum += change;
    worst = compared == 0 ? change : std::max(worst, change);
    ++compared;
  }
  std::printf(" %+.4f | %+.4f | %+d | %.2f |", compared > 0 ? sum / compared : 0.0, worst, lost,
              runs.seconds / usual.seconds);
}

void print_table(const Family& family, std::span<Subject> subjects) {
  (void)run_all(family.constants.front(), 1, subjects);  // fills the caches
  const Runs usual = run_all(family.constants.front(), 1, subjects);
  std::printf("The table compares %s, on %zu markers; %.2f s with the usual constants.\n\n", family.result.c_str(),
              subjects.size(), usual.seconds);
  std::printf("| constant | value | half: mean, %% | worst, %% | failed | time ");
  std::printf("| double: mean, %% | worst, %% | failed | time |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Constant& constant : family.constants) {
    std::printf("| `%s` | %s |", constant.name.c_str(), constant.value.c_str());
    for (const double factor : {0.5, 2.0}) print_cells(run_all(constant, factor, subjects), usual);
    std::printf("\n");
    std::fflush(stdout);
  }
  const Runs again = run_all(family.constants.front(), 1, subjects);
  std::printf("\nRepeated with the usual constants: time %.2f.\n", again.seconds / usual.seconds);
}

int main_of(std::span<const std::string> arguments) {
  const std::vector<Family> all = families();
  for (const Family& family : all) {
    if (arguments.size() < 2 || family.name != arguments[0]) continue;
    std::vector<Subject> subjects(arguments.size() - 1);
    for (std::size_t k = 1; k < arguments.size(); ++k) {
      Subject& subject = subjects[k - 1];
      subject.marker = family.prepared(marker_in(arguments[k]), subject.sums);
    }
    print_table(family, subjects);
    return 0;
  }
  std::fprintf(stderr, "usage: sensitivity_table FAMILY MARKER...\nthe families are:");
  for (const Family& family : all) std::fprintf(stderr, " %s", family.name.c_str());
  std::fprintf(stderr, "\n");
  return 2;
}

}  // namespace
}  // namespace selvage::bench::sensitivity

int main(int argc, char** argv) {
  return selvage::bench::sensitivity::main_of(std::vector<std::string>(argv + 1, argv + argc));
}
