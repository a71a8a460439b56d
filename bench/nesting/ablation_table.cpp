// Nests markers from nothing with one part of the method switched off at a time, and prints a Markdown table of the
// mean densities: what each part contributes.  With --constants it halves and doubles one constant at a time instead,
// of those that only runs with a time limit use.
//
// usage: ablation_table [--constants] [--only TEXT] SECONDS SEEDS MARKER...
//
// SECONDS: processor time of each run, on one thread; the rows of two searches have two threads, which share it.  The
// seeds are 1 to SEEDS.  Layouts in the files are not used. TEXT: only the rows whose names contain it, so that
// sittings add up.  nest() proves every answer; the density of every run goes to the standard error.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "bench/measure/timing.h"
#include "bench/support/marker_file.h"
#include "core/marker/figures.h"
#include "core/nesting/nest.h"
#include "protocol/execution/thread_pool.h"

namespace selvage::bench {
namespace {

using nesting::NestSettings;

struct Ablation {
  std::string name;
  std::function<void(NestSettings&)> apply;
};

std::vector<Ablation> ablations() {
  return {
      {"all parts", [](NestSettings&) {}},
      {"overlaps cost their depth only, no charge", [](NestSettings& s) { s.tuning.search.charge = 0; }},
      {"weights of pairs do not grow",
       [](NestSettings& s) { s.tuning.search.weight_growth = 1, s.tuning.search.extra_growth = 0; }},
      {"a move descends from one place of the field instead of three",
       [](NestSettings& s) { s.tuning.search.best_places = 1; }},
      {"attempts are short from the beginning", [](NestSettings& s) { s.tuning.first_step = s.tuning.least_step; }},
      {"searches that have stalled only attempt", [](NestSettings& s) { s.tuning.walks = false; }},
      {"they only walk", [](NestSettings& s) { s.tuning.attempts = false; }},
      {"markers are repaired, but not compacted", [](NestSettings& s) { s.tuning.compaction_rounds = 0; }},
      {"one start", [](NestSettings& s) { s.tuning.raced = 0; }},
      {"no compression in the end", [](NestSettings& s) { s.tuning.explored = 1; }},
      {"no small rotations in the end", [](NestSettings& s) { s.tilts = false; }},
  };
}

std::vector<Ablation> constants() {
  const auto two_searches = [](double shared) {
    return [shared](NestSettings& s) { s.searches = 2, s.tuning.shared = shared; };
  };
  const auto shares = [](double factor) {
    return [factor](NestSettings& s) {
      for (std::uint64_t* moves : {&s.tuning.least_raced_in_time, &s.tuning.most_raced_in_time})
        *moves = static_cast<std::uint64_t>(factor * static_cast<double>(*moves));
    };
  };
  return {
      {"the usual constants", [](NestSettings&) {}},
      {"`raced` 0.125", [](NestSettings& s) { s.tuning.raced = 0.125; }},
      {"`raced` 0.5", [](NestSettings& s) { s.tuning.raced = 0.5; }},
      {"`raced_in_time` 10,000 to 30,000", shares(0.5)},
      {"`raced_in_time` 40,000 to 120,000", shares(2)},
      {"`raced_gain` 0.0005", [](NestSettings& s) { s.tuning.raced_gain = 0.0005; }},
      {"`raced_gain` 0.002", [](NestSettings& s) { s.tuning.raced_gain = 0.002; }},
      {"two searches, `shared` 0.25", two_searches(0.25)},
      {"two searches, `shared` 0.5 (usual)", two_searches(0.5)},
      {"two searches, never shared", two_searches(1)},
  };
}

// Per cent.
double density(const Marker& marker, const Ablation& ablation, double seconds, std::uint64_t seed) {
  NestSettings settings;
  settings.moves = std::numeric_limits<std::uint64_t>::max();
  settings.from_scratch = true;
  settings.seed = seed;
  const auto processor_time = [] { return measure::milliseconds(CLOCK_PROCESS_CPUTIME_ID) / 1000; };
  settings.elapsed = [=, start = processor_time()] { return (processor_time() - start) / seconds; };
  ablation.apply(settings);
  SumCache sums;
  const protocol::execution::ThreadPool two{1};  // and the caller's thread
  const Executor& executor = settings.searches > 1 ? static_cast<const Executor&>(two) : serial();
  const auto done = nest(marker, settings, {.sums = sums, .executor = &executor});
  if (!done) {
    std::fprintf(stderr, "%s\n", done.error().message.c_str());
    std::exit(EXIT_FAILURE);
  }
  return 100 * utilisation_at(done->marker, done->length_after);
}

int main_of(std::vector<std::string> arguments) {
  const bool halved_and_doubled = !arguments.empty() && arguments[0] == "--constants";
  if (halved_and_doubled) arguments.erase(arguments.begin());
  std::string only;
  if (arguments.size() >= 2 && arguments[0] == "--only") {
    only = arguments[1];
    arguments.erase(arguments.begin(), arguments.begin() + 2);
  }
  if (arguments.size() < 3) {
    std::fprintf(stderr, "usage: ablation_table [--constants] [--only TEXT] SECONDS SEEDS MARKER...\n");
    return 2;
  }
  const double seconds = std::stod(arguments[0]);
  const std::uint64_t seeds = std::stoull(arguments[1]);
  const std::vector<std::string> files{arguments.begin() + 2, arguments.end()};
  std::string rule = "|---|";
  std::printf("| density %% |");
  for (const std::string& file : files) {
    std::printf(" %s |", name_of(file).c_str());
    rule += "---|";
  }
  std::printf("\n%s\n", rule.c_str());
  for (const Ablation& ablation : halved_and_doubled ? constants() : ablations()) {
    if (ablation.name.find(only) == std::string::npos) continue;
    std::printf("| %s |", ablation.name.c_str());
    for (const std::string& file : files) {
      const Marker marker = marker_in(file);
      double sum = 0;
      for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const double dense = density(marker, ablation, seconds, seed);
        std::fprintf(stderr, "%s, %s, seed %d: %.2f\n", ablation.name.c_str(), name_of(file).c_str(),
                     static_cast<int>(seed), dense);
        sum += dense;
      }
      std::printf(" %.2f |", sum / static_cast<double>(seeds));
      std::fflush(stdout);
    }
    std::printf("\n");
  }
  return 0;
}

}  // namespace
}  // namespace selvage::bench

int main(int argc, char** argv) {
  return selvage::bench::main_of(std::vector<std::string>(argv + 1, argv + argc));
}
