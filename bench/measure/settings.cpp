#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "bench/measure/measurements.h"
#include "bench/measure/timing.h"
#include "bench/support/marker_file.h"
#include "core/motion/tilting/tilt.h"
#include "core/search/refine.h"
#include "tests/support/tiled/digitised.h"

namespace selvage::bench::measure {
namespace {

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

// Settings of refinement without tilts and nesting: the number of other descents, the effort spent on swaps, and the
// number of seeds of which the best result is kept; also the presets that use refinement.
void measure_refinement_settings(const std::string& name, const Marker& marker) {
  const auto refined = [&](const search::RefineSettings& settings) {
    return [&marker, settings](SumCache& sums) { return *refine(marker, settings, {sums}); };
  };
  const search::RefineSettings preset = search::refine_settings();
  search::RefineSettings settings = preset;
  settings.most_pieces_swapped = marker::kMaxPieces;
  settings.tilts = settings.nests = false;
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
  measured(name, same, refined(settings));
  settings.nests = false;
  settings.most_pieces_swapped = marker::kMaxPieces;
  measured(name, "swaps", std::to_string(settings.effort), refined(settings));
}

}  // namespace

void settings(const Paths& paths) {
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

void digitised(const Paths& paths) {
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

}  // namespace selvage::bench::measure
