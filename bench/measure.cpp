// Time against length for every knob of compaction, the anytime curve, what each motion models, and how time grows:
// comma-separated lines that bench/measure.py makes tables and pictures of.  Times are the processor's, milliseconds,
// nothing in the cache of sums.
//
// usage: measure knobs|anytime|scene|growth MARKER...
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/marker/validity.h"
#include "core/motion/refine.h"
#include "protocol/formats/format.h"
#include "tests/support/one_round.h"
#include "tests/support/tiled_marker.h"

namespace selvage {
namespace {

constexpr int kRepetitions = 3;  // the median is told
constexpr double kLong = 1500;   // milliseconds: what takes longer is run once

Marker marker_in(const std::string& path) {
  std::ifstream in{path};
  std::stringstream text;
  text << in.rdbuf();
  const auto read = read_marker(text.str());
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

// The median time of runs, each with a cache of its own.
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

struct Variant {
  std::string knob, value;
  CompactionSettings settings;
};

std::vector<Variant> variants() {
  const CompactionSettings standard = compaction_settings(Accuracy::kStandard);
  std::vector<Variant> all;
  const auto vary = [&](const std::string& knob, const std::string& value, auto change) {
    CompactionSettings settings = standard;
    change(settings);
    all.push_back({knob, value, settings});
  };
  for (const char* trust : {"0.02", "0.05", "0.1", "0.15", "0.2", "0.3", "1"}) {
    vary("trust", trust, [&](auto& s) { s.trust = std::stod(trust); });
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
  vary("region", "greedy", [](auto& s) { s.region = RegionRule::kGreedy; });
  vary("region", "walk", [](auto& s) { s.region = RegionRule::kWalk; });
  vary("solver", "automatic", [](auto& s) { s.solver = SolverChoice::kAutomatic; });
  vary("solver", "simplex", [](auto& s) { s.solver = SolverChoice::kSimplex; });
  vary("solver", "interior_point", [](auto& s) { s.solver = SolverChoice::kInteriorPoint; });
  for (const char* tolerance : {"0", "1e-6", "1e-4", "1e-3", "3e-3", "1e-2", "1e-1"}) {
    vary("solver_tolerance", tolerance, [&](auto& s) { s.solver_tolerance = std::stod(tolerance); });
  }
  all.push_back({"accuracy", "draft", compaction_settings(Accuracy::kDraft)});
  all.push_back({"accuracy", "standard", standard});
  return all;
}

void told(const std::string& name, const std::string& knob, const std::string& value, double time,
          const Compaction& done) {
  const double ratio = static_cast<double>(done.length_after) / static_cast<double>(done.length_before);
  std::cout << name << ',' << knob << ',' << value << ',' << time << ',' << ratio << ',' << done.programs << ','
            << (is_valid(done.marker) ? "valid" : "INVALID") << std::endl;
}

void knobs(const std::vector<std::string>& paths) {
  std::cout << "marker,knob,value,ms,ratio,programs,valid\n" << std::fixed;
  for (const std::string& path : paths) {
    const Marker marker = marker_in(path);
    Compaction done;
    for (const Variant& variant : variants()) {
      const double time = median_time([&] {
        SumCache sums;
        done = *compact(marker, variant.settings, sums);
      });
      told(name_of(path), variant.knob, variant.value, time, done);
    }
    for (const bool tilts : {false, true}) {
      RefineSettings settings = refine_settings();
      settings.tilts = tilts;
      const double start = own_time();
      SumCache sums;
      done = *refine(marker, settings, sums);
      told(name_of(path), "accuracy", tilts ? "fine" : "fine without tilts", own_time() - start, done);
    }
  }
}

// Asks to stop once the process has worked for so long.
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
        const Compaction done = fine ? *refine(marker, refine_settings(), sums, limit.token())
                                     : *compact(marker, compaction_settings(Accuracy::kStandard), sums, limit.token());
        told(name_of(path), fine ? "fine" : "standard", std::to_string(deadline), own_time() - start, done);
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
      const double start = own_time();
      const auto [programs, largest, sums] = test::work_of(round, marker);
      const double time = own_time() - start;
      std::cout << pieces << ",\"" << round.motion << "\"," << time << ',' << programs << ',' << largest.columns << ','
                << largest.rows << ',' << largest.nonzeros << ',' << sums << std::endl;
    }
  }
}

void growth(const std::vector<std::string>& paths) {
  std::cout << "tile,pieces,ms,sums,rows,solve,verify,other,programs,ratio,megabytes,valid\n" << std::fixed;
  for (const std::string& path : paths) {
    const Marker tile = test::loosened(marker_in(path), 0.05);
    for (const std::size_t pieces : {100U, 400U, 1600U, 4000U, 6400U}) {
      const Marker marker = test::tiled(tile, pieces);
      std::array<double, 5> stages{};
      auto at = static_cast<std::size_t>(Stage::kOther);
      double last = own_time();
      const double start = last;
      const auto enter = [&](std::size_t next) {
        const double now = own_time();
        stages[at] += now - last;
        last = now;
        at = next;
      };
      Observer observer;
      observer.on_stage = [&](Stage stage) { enter(static_cast<std::size_t>(stage)); };
      SumCache sums;
      const auto done = compact(marker, compaction_settings(Accuracy::kStandard), sums, {}, observer);
      enter(0);
      rusage usage{};
      getrusage(RUSAGE_SELF, &usage);
      std::cout << name_of(path) << ',' << pieces << ',' << last - start;
      for (const double stage : stages) std::cout << ',' << stage;
      std::cout << ',' << done->programs << ','
                << static_cast<double>(done->length_after) / static_cast<double>(done->length_before) << ','
                << usage.ru_maxrss / 1024 << ',' << (is_valid(done->marker) ? "valid" : "INVALID") << std::endl;
    }
  }
}

}  // namespace
}  // namespace selvage

int main(int argc, char** argv) {
  const std::string what = argc > 2 ? argv[1] : "";
  const std::vector<std::string> paths(argv + std::min(argc, 2), argv + argc);
  if (what == "knobs") {
    selvage::knobs(paths);
  } else if (what == "anytime") {
    selvage::anytime(paths);
  } else if (what == "scene") {
    selvage::scene(paths.front());
  } else if (what == "growth") {
    selvage::growth(paths);
  } else {
    std::cerr << "usage: measure knobs|anytime|scene|growth MARKER...\n";
    return 2;
  }
}
