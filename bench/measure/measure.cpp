// Measures time against length for every setting, simplification of digitised outlines, the best length at a deadline,
// the size of each motion's programs, and how time grows with the number of pieces.  Prints comma-separated lines, from
// which bench/measure/measure.py makes tables and pictures.  Times are processor times in milliseconds with an empty
// cache of sums, unless marked as warm.
//
// `cores` measures the gain from a second thread and prints a Markdown table of wall times.
//
// usage: measure settings|digitised|anytime|scene|growth|cores MARKER...
#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/marker/validity.h"
#include "core/motion/tilting/tilt.h"
#include "core/search/refine.h"
#include "protocol/execution/thread_pool.h"
#include "protocol/formats/format.h"
#include "tests/motions/motion_cases.h"
#include "tests/support/digitised.h"
#include "tests/support/tiled_marker.h"

namespace selvage::bench {
namespace {

constexpr int kRepetitions = 3;  // the median is reported
constexpr double kLong = 500;    // milliseconds: a run that takes longer is not repeated

Marker marker_in(const std::string& path) {
  std::ifstream in{path};
  std::stringstream text;
  text << in.rdbuf();
  const auto read = protocol::formats::read_marker(text.str());
  if (!read) throw std::runtime_error{path + ": " + read.error().message};
  return read->marker;
}
std::string name_of(const std::string& path) {
  return std::filesystem::path{path}.stem().string();
}

double milliseconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}
double own_time() {
  return milliseconds(CLOCK_THREAD_CPUTIME_ID);
}

// The median processor time of several runs.
template <class Run>
double median_time(const Run& run) {
  std::vector<double> times;
  while (times.size() < kRepetitions && (times.empty() || times.back() < kLong)) {
    const double start = own_time();
    run();
    times.push_back(own_time() - start);
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

// Tolerances of simplified outlines, as fractions of the strip's width.
constexpr std::array kSimplifications{"0", "0.0001", "0.0002", "0.0005", "0.001", "0.002", "0.005"};

struct Variant {
  std::string setting, value;
  motion::compaction::CompactionSettings settings;
};

std::vector<Variant> variants() {
  const motion::compaction::CompactionSettings standard = compaction_settings(motion::compaction::Accuracy::kStandard);
  std::vector<Variant> all;
  const auto vary = [&](const std::string& setting, const std::string& value, auto change) {
    motion::compaction::CompactionSettings settings = standard;
    change(settings);
    all.push_back({setting, value, settings});
  };
  for (const char* trust : {"0.02", "0.05", "0.1", "0.15", "0.2", "0.3", "1"}) {
    vary("trust radius", trust, [&](auto& s) { s.trust = std::stod(trust); });
  }
  for (const char* rounds : {"1", "2", "3", "4", "8"}) {
    vary("rounds", rounds, [&](auto& s) { s.rounds = std::stoi(rounds); });
  }
  for (const char* gain : {"0.05", "0.001", "2e-5", "1e-8"}) {
    vary("least_gain", gain, [&](auto& s) { s.least_gain = std::stod(gain); });
  }
  for (const char* gravity : {"0", "0.0003", "0.003", "0.03", "0.3"}) {
    vary("gravity", gravity, [&](auto& s) { s.gravity = std::stod(gravity); });
  }
  for (const char* part : kSimplifications) {
    vary("simplification", part, [&](auto& s) { s.simplification = std::stod(part); });
  }
  vary("region", "greedy", [](auto& s) { s.region = model::RegionRule::kGreedy; });
  vary("region", "walk", [](auto& s) { s.region = model::RegionRule::kWalk; });
  vary("solver", "automatic", [](auto& s) { s.solver = lp::solver::SolverChoice::kAutomatic; });
  vary("solver", "simplex", [](auto& s) { s.solver = lp::solver::SolverChoice::kSimplex; });
  vary("solver", "interior_point", [](auto& s) { s.solver = lp::solver::SolverChoice::kInteriorPoint; });
  for (const char* tolerance : {"0", "1e-6", "1e-4", "1e-3", "3e-3", "1e-2", "1e-1"}) {
    vary("solver_tolerance", tolerance, [&](auto& s) { s.solver_tolerance = std::stod(tolerance); });
  }
  all.push_back({"accuracy", "draft", compaction_settings(motion::compaction::Accuracy::kDraft)});
  all.push_back({"accuracy", "standard", standard});
  return all;
}

template <class Done>
double ratio_of(const Done& done) {
  return static_cast<double>(done.length_after) / static_cast<double>(done.length_before);
}
void print_line(const std::string& name, const std::string& setting, const std::string& value, double time,
                double ratio, int programs, bool valid) {
  std::cout << name << ',' << setting << ',' << value << ',' << time << ',' << ratio << ',' << programs << ','
            << (valid ? "valid" : "INVALID") << std::endl;
}
// Measures run(sums) and prints a line for every setting that this run represents.
template <class Run>
void measured(const std::string& name, const std::vector<std::pair<std::string, std::string>>& same, const Run& run) {
  decltype(run(std::declval<SumCache&>())) done;
  const double time = median_time([&] {
    SumCache sums;
    done = run(sums);
  });
  for (const auto& [setting, value] : same) {
    print_line(name, setting, value, time, ratio_of(done), done.programs, marker::is_valid(done.marker));
  }
}
template <class Run>
void measured(const std::string& name, const std::string& setting, const std::string& value, const Run& run) {
  measured(name, {{setting, value}}, run);
}

bool may_tilt(const Marker& marker) {
  return std::any_of(marker.shapes.begin(), marker.shapes.end(),
                     [](const Shape& shape) { return shape.tilt_limit.degrees > 0; });
}
void measure_tilt_settings(const std::string& name, const Marker& marker) {
  for (const char* degrees : {"0.25", "0.5", "1", "2", "3"}) {
    motion::tilting::TiltSettings settings =
        tilt_settings(motion::tilting::TiltMethod::kLinearisation, motion::compaction::Accuracy::kStandard);
    settings.step = Angle::of_degrees(std::stod(degrees));
    measured(name, "tilt step", degrees, [&](SumCache& sums) { return *tilt(marker, settings, {sums}); });
  }
  for (const char* tilts : {"3", "7", "13", "25", "49"}) {
    motion::tilting::TiltSettings settings =
        tilt_settings(motion::tilting::TiltMethod::kRelaxation, motion::compaction::Accuracy::kStandard);
    settings.tilts = std::stoi(tilts);
    measured(name, "tilts", tilts, [&](SumCache& sums) { return *tilt(marker, settings, {sums}); });
  }
}

// Settings of refinement without tilts: the number of other descents, the effort spent on swaps, and the number of
// seeds of which the best result is kept; also the presets that use refinement.
void measure_refinement_settings(const std::string& name, const Marker& marker) {
  const auto refined = [&](const search::RefineSettings& settings) {
    return [&marker, settings](SumCache& sums) { return *refine(marker, settings, {sums}); };
  };
  const search::RefineSettings preset = search::refine_settings();
  search::RefineSettings settings = preset;
  settings.most_pieces_swapped = marker::kMaxPieces;
  settings.tilts = false;
  settings.effort = 0;
  for (const char* ways : {"0", "1", "2", "3", "4"}) {
    settings.variants = std::stoi(ways);
    measured(name, "other descents", ways, refined(settings));
  }
  for (const char* effort : {"0", "4000", "15000", "30000"}) {
    settings.effort = std::stoull(effort);
    measured(name, "swaps", effort, refined(settings));
  }
  settings.effort = 60'000;
  double time = 0;
  double best = 2;
  int programs = 0;
  bool valid = true;
  for (settings.seed = 1; settings.seed <= 3; ++settings.seed) {
    const double start = own_time();
    SumCache sums;
    const motion::compaction::Compaction done = refined(settings)(sums);
    time += own_time() - start;
    best = std::min(best, ratio_of(done));
    programs += done.programs;
    valid = valid && marker::is_valid(done.marker);
    print_line(name, "seeds", std::to_string(settings.seed), time, best, programs, valid);
    if (settings.seed == 1) print_line(name, "swaps", std::to_string(settings.effort), time, best, programs, valid);
  }
  settings = preset;
  if (may_tilt(marker)) measured(name, "accuracy", "fine", refined(settings));
  settings.tilts = false;
  std::vector<std::pair<std::string, std::string>> same{{"accuracy", "fine without tilts"}};
  if (!may_tilt(marker)) same.emplace_back("accuracy", "fine");
  if (marker.pieces.size() <= preset.most_pieces_swapped) same.emplace_back("swaps", std::to_string(preset.effort));
  measured(name, same, refined(settings));
  if (same.back().first == "swaps") return;
  settings.most_pieces_swapped = marker::kMaxPieces;
  measured(name, "swaps", std::to_string(settings.effort), refined(settings));
}

void settings(const std::vector<std::string>& paths) {
  std::cout << "marker,setting,value,ms,ratio,programs,valid\n" << std::fixed;
  for (const std::string& path : paths) {
    const std::string name = name_of(path);
    const Marker marker = marker_in(path);
    for (const Variant& variant : variants()) {
      measured(name, variant.setting, variant.value,
               [&](SumCache& sums) { return *compact(marker, variant.settings, {sums}); });
    }
    measure_refinement_settings(name, marker);
    if (may_tilt(marker)) measure_tilt_settings(name, marker);
  }
}

// Simplification of pieces with many vertices, with an empty cache of sums and with a full one.
void digitised(const std::vector<std::string>& paths) {
  std::cout << "marker,pitch,vertices,simplification,cold,warm,sums,ratio,valid\n" << std::fixed;
  for (const std::string& path : paths) {
    const Marker drawn = marker_in(path);
    for (const Coord pitch : {Coord{1}, Coord{100}, Coord{200}, Coord{400}}) {
      const Coord width = drawn.strip.width;
      const Marker marker = pitch == 1 ? drawn : test::digitised(drawn, width / pitch, width / 10'000);
      std::size_t vertices = 0;
      for (const Shape& shape : marker.shapes) vertices += shape.outline.size();
      for (const char* part : kSimplifications) {
        motion::compaction::CompactionSettings settings = compaction_settings(motion::compaction::Accuracy::kStandard);
        settings.simplification = std::stod(part);
        motion::compaction::Compaction done;
        SumCache full;
        const double cold = median_time([&] {
          SumCache sums;
          done = *compact(marker, settings, {sums});
        });
        done = *compact(marker, settings, {full});
        const double warm = median_time([&] { done = *compact(marker, settings, {full}); });
        std::cout << name_of(path) << ',' << pitch << ',' << vertices / marker.shapes.size() << ',' << part << ','
                  << cold << ',' << warm << ',' << full.counts().entries << ',' << ratio_of(done) << ','
                  << (is_valid(done.marker) ? "valid" : "INVALID") << std::endl;
      }
    }
  }
}

// Requests a stop once the process has used a given amount of processor time.
class WorkDeadline {
 public:
  explicit WorkDeadline(double limit)
      : watch_{[this, end = milliseconds(CLOCK_PROCESS_CPUTIME_ID) + limit](const std::stop_token& done) {
          while (!done.stop_requested() && milliseconds(CLOCK_PROCESS_CPUTIME_ID) < end) {
            std::this_thread::sleep_for(std::chrono::microseconds{200});
          }
          source_.request_stop();
        }} {}
  [[nodiscard]] std::stop_token token() const { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::jthread watch_;
};

void anytime(const std::vector<std::string>& paths) {
  std::cout << "marker,accuracy,deadline,ms,ratio,programs,valid\n" << std::fixed;
  for (const std::string& path : paths) {
    const Marker marker = marker_in(path);
    for (const bool fine : {false, true}) {
      for (const int deadline : {5, 10, 20, 40, 60, 100, 200, 1000, 2000, 4000, 8000}) {
        const double start = own_time();
        SumCache sums;
        const WorkDeadline limit{static_cast<double>(deadline)};
        const motion::compaction::Compaction done =
            fine
                ? *refine(marker, search::refine_settings(), {sums, limit.token()})
                : *compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), {sums, limit.token()});
        print_line(name_of(path), fine ? "fine" : "standard", std::to_string(deadline), own_time() - start,
                   ratio_of(done), done.programs, marker::is_valid(done.marker));
      }
    }
  }
}

void scene(const std::string& path) {
  std::cout << "pieces,motion,ms,programs,variables,rows,nonzeros,sums\n" << std::fixed;
  const Marker tile = marker_in(path);
  for (const std::size_t pieces : {40U, 120U, 440U, 4000U}) {
    const Marker marker = test::tiled(tile, pieces);
    for (const test::OneRound& round : test::one_round_of_each()) {
      if (pieces > round.pieces) continue;
      test::Work work;
      const double time = median_time([&] { work = test::work_of(round, marker); });
      const auto& [programs, largest, sums] = work;
      std::cout << pieces << ",\"" << round.motion << "\"," << time << ',' << programs << ',' << largest.columns << ','
                << largest.rows << ',' << largest.nonzeros << ',' << sums << std::endl;
    }
  }
}

// The peak memory of this process, MB.  (getrusage would include the process that started it.)
std::size_t peak_megabytes() {
  std::ifstream status{"/proc/self/status"};
  for (std::string word; status >> word;) {
    if (word != "VmHWM:") continue;
    std::size_t kilobytes{};
    status >> kilobytes;
    return kilobytes / 1024;
  }
  return 0;
}

// A compaction and the milliseconds spent in each of its stages.
struct Staged {
  motion::compaction::Compaction done;
  std::array<double, 5> stages{};
  [[nodiscard]] double all() const { return std::accumulate(stages.begin(), stages.end(), 0.0); }
};
Staged staged(const Marker& marker) {
  std::array<double, 5> stages{};
  auto at = static_cast<std::size_t>(scene::Stage::kOther);
  double last = own_time();
  const auto enter = [&](std::size_t next) {
    const double now = own_time();
    stages[at] += now - last;
    last = now;
    at = next;
  };
  SumCache sums;
  scene::Run run{sums};
  run.observer.on_stage = [&](scene::Stage stage) { enter(static_cast<std::size_t>(stage)); };
  motion::compaction::Compaction done =
      *compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), run);
  enter(0);
  return {std::move(done), stages};
}

// Reports the run with the median time of three.
void growth(const std::vector<std::string>& paths) {
  std::cout << "tile,pieces,ms,sums,rows,solve,verify,other,programs,ratio,megabytes,valid\n" << std::fixed;
  for (const std::string& path : paths) {
    const Marker tile = test::loosened(marker_in(path), 0.05);
    for (const std::size_t pieces : {100U, 400U, 1600U, 4000U, 6400U}) {
      const Marker marker = test::tiled(tile, pieces);
      std::vector<Staged> runs;
      for (int run = 0; run < 3; ++run) runs.push_back(staged(marker));
      std::ranges::sort(runs, {}, &Staged::all);
      const Staged& middle = runs[1];
      std::cout << name_of(path) << ',' << pieces << ',' << middle.all();
      for (const double stage : middle.stages) std::cout << ',' << stage;
      std::cout << ',' << middle.done.programs << ',' << ratio_of(middle.done) << ',' << peak_megabytes() << ','
                << (is_valid(middle.done.marker) ? "valid" : "INVALID") << std::endl;
    }
  }
}

double wall_time() {
  return milliseconds(CLOCK_MONOTONIC);
}
double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct CoreCase {
  std::string marker, motion;
  bool warm{};
  std::size_t repetitions{};
  std::function<void(const scene::Run&)> run;
};

std::vector<CoreCase> core_cases(const std::string& name, const Marker& marker, std::size_t repetitions) {
  const auto compaction = [marker](const scene::Run& run) {
    (void)compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), run);
  };
  return {{name, "compact", false, repetitions, compaction}, {name, "compact", true, repetitions, compaction}};
}
std::vector<CoreCase> long_core_cases(const std::string& name, const Marker& marker) {
  constexpr std::size_t kFew = 5;
  const auto tilting = [marker](const scene::Run& run) {
    (void)tilt(marker,
               tilt_settings(motion::tilting::TiltMethod::kLinearisation, motion::compaction::Accuracy::kStandard),
               run);
  };
  const auto refining = [marker](const scene::Run& run) {
    search::RefineSettings settings = search::refine_settings();
    settings.tilts = false;
    (void)refine(marker, settings, run);
  };
  return {{name, "tilt", false, kFew, tilting}, {name, "compact, fine, no tilts", false, kFew, refining}};
}

// Computes the speed-up of two threads without using them: runs the parts one after another, and derives from the
// processor time of each what two threads would have saved, each taking the next part when it has finished one.  The
// cost of waking and waiting is not included.
class SimulatedPair final : public Executor {
 public:
  [[nodiscard]] std::size_t parallelism() const override { return 2; }
  void for_each(std::size_t count, const Part& part) const override {
    std::array<double, 2> busy{};
    for (std::size_t k = 0; k < count; ++k) {
      const double start = own_time();
      part(k);
      *std::ranges::min_element(busy) += own_time() - start;
    }
    saved += *std::ranges::min_element(busy);
  }
  mutable double saved{};
};

// The speed-up of two threads on 20 ms of plain arithmetic: 2 on idle cores.
double possible_speed_up(const Executor& two) {
  const auto work = [](std::size_t) {
    volatile double sum = 0;
    for (int k = 0; k < 4'000'000; ++k) sum = sum + 1.0 / (k + 1);
  };
  const double start = wall_time();
  serial().for_each(2, work);
  const double between = wall_time();
  two.for_each(2, work);
  return (between - start) / (wall_time() - between);
}

// Prints a row of the table.  Runs with one thread and with two alternate, so that both see the same load.
void print_row(const CoreCase& wanted, const Executor& two) {
  SumCache kept;
  if (wanted.warm) wanted.run({kept});
  std::vector<double> one_thread, two_threads, ratio, possible, simulated_ratio;
  const auto time_with = [&](const Executor& executor) {
    SumCache own;
    const double start = wall_time();
    wanted.run({wanted.warm ? kept : own, {}, {}, &executor});
    return wall_time() - start;
  };
  for (std::size_t k = 0; k < wanted.repetitions; ++k) {
    possible.push_back(possible_speed_up(two));
    one_thread.push_back(time_with(serial()));
    two_threads.push_back(time_with(two));
    ratio.push_back(one_thread.back() / two_threads.back());
    const SimulatedPair simulated;
    const double start = own_time();
    (void)time_with(simulated);
    const double all = own_time() - start;
    simulated_ratio.push_back(all / (all - simulated.saved));
  }
  std::cout << "| " << wanted.marker << " | " << wanted.motion << " | " << (wanted.warm ? "kept" : "none") << " | "
            << median(one_thread) << " | " << median(two_threads) << " | " << *std::ranges::min_element(one_thread)
            << " | " << *std::ranges::min_element(two_threads) << " | " << median(ratio) << " | " << median(possible)
            << " | " << median(simulated_ratio) << " |" << std::endl;
}

// "Possible" is the speed-up that the machine allowed at the time, "simulated" the one that two idle cores would bring.
void cores(const std::vector<std::string>& paths) {
  constexpr std::size_t kMany = 41, kSeveral = 7, kLongMarker = 4000;
  const protocol::execution::ThreadPool two{1};
  std::cout << "| marker | motion | sums | one thread, ms | two threads | least, one | two | one / two | possible | "
               "simulated |\n"
            << "|---|---|---|---|---|---|---|---|---|---|\n"
            << std::fixed << std::setprecision(2);
  const auto print_rows = [&](const std::vector<CoreCase>& cases) {
    for (const CoreCase& wanted : cases) print_row(wanted, two);
  };
  for (const std::string& path : paths) print_rows(core_cases(name_of(path), marker_in(path), kMany));
  const std::string& first = paths.front();
  print_rows(core_cases(name_of(first) + ", 4,000 pieces",
                        test::tiled(test::loosened(marker_in(first), 0.05), kLongMarker), kSeveral));
  print_rows(long_core_cases(name_of(first), marker_in(first)));
}

}  // namespace
}  // namespace selvage::bench

int main(int argc, char** argv) {
  const std::string what = argc > 2 ? argv[1] : "";
  const std::vector<std::string> paths(argv + std::min(argc, 2), argv + argc);
  if (what == "settings") {
    selvage::bench::settings(paths);
  } else if (what == "digitised") {
    selvage::bench::digitised(paths);
  } else if (what == "anytime") {
    selvage::bench::anytime(paths);
  } else if (what == "scene") {
    selvage::bench::scene(paths.front());
  } else if (what == "growth") {
    selvage::bench::growth(paths);
  } else if (what == "cores") {
    selvage::bench::cores(paths);
  } else {
    std::cerr << "usage: measure settings|digitised|anytime|scene|growth|cores MARKER...\n";
    return 2;
  }
}
