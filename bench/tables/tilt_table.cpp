// Measures the gain of small tilts over translational compaction, and their time: by linearisation [Li94 6.2], by
// linearisation with random perturbations, and by relaxation [Li94 6.1.3].  Prints a Markdown table.
//
// usage: tilt_table [--limit DEGREES] [--perturbations N] [--outlines FOLDER] FILE...
//
// The limit (default 3 degrees) replaces every shape's own.  With --outlines, every result is written to
// FOLDER/MARKER-METHOD.json as placed outlines, for an independent judge.  Times are processor times of tilt(),
// including the compaction that it starts with, with an empty cache of sums.  Exit status 1 when a result is not valid,
// is longer than that of compaction, or is tilted beyond the limit.
#include <cstdio>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/marker/validity.h"
#include "core/motion/tilting/tilt.h"
#include "protocol/formats/format.h"

namespace selvage::bench {
namespace {

struct Options {
  double limit{3};
  int perturbations{10};
  std::string outlines;
  std::vector<std::string> files;
};

struct Method {
  const char* name;
  motion::tilting::TiltMethod method;
  bool perturbed;
};
constexpr Method kMethods[] = {{"linearisation", motion::tilting::TiltMethod::kLinearisation, false},
                               {"linearisation-perturbed", motion::tilting::TiltMethod::kLinearisation, true},
                               {"relaxation", motion::tilting::TiltMethod::kRelaxation, false}};

double part_of(Coord length, Coord of) {
  return static_cast<double>(length) / static_cast<double>(of);
}

bool save(const Options& options, const std::string& name, const MarkerFile& file) {
  if (options.outlines.empty()) return true;
  const auto text = protocol::formats::write_marker(file, Format::kOutlines);
  std::ofstream out{options.outlines + "/" + name + ".json"};
  if (text) out << *text;
  return text && out.good();
}

// The gains as fractions of the length before.
struct Gains {
  double compaction{}, tilt{};
};

bool print_row(const Options& options, const std::string& name, MarkerFile file, const Method& method, Gains& gains) {
  motion::tilting::TiltSettings settings = tilt_settings(method.method, motion::compaction::Accuracy::kStandard);
  settings.limit = Angle::of_degrees(options.limit);
  if (method.perturbed) {
    settings.perturbations = options.perturbations;
    settings.rounds *= 1 + options.perturbations;
  }
  SumCache sums;
  const std::clock_t begin = std::clock();
  const auto result = tilt(file.marker, settings, {sums});
  const double milliseconds = 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  if (!result) {
    std::printf("| %s | %s | %s |\n", name.c_str(), method.name, result.error().message.c_str());
    return false;
  }
  const bool good = is_valid(result->marker) && result->length_after <= result->length_compacted &&
                    result->farthest_tilt.degrees <= options.limit;
  gains.compaction += 1 - part_of(result->length_compacted, result->length_before);
  gains.tilt += 1 - part_of(result->length_after, result->length_before);
  std::printf("| %s | %zu | %s | %.6f | %.6f | %.6f | %.3f | %d | %d | %.0f | %s |\n", name.c_str(),
              file.marker.pieces.size(), method.name, part_of(result->length_compacted, result->length_before),
              part_of(result->length_after, result->length_compacted),
              part_of(result->length_after, result->length_before), result->farthest_tilt.degrees, result->rounds,
              result->programs, milliseconds, good ? "yes" : "NO");
  std::fflush(stdout);
  file.marker = result->marker;
  return save(options, name + "-" + method.name, file) && good;
}

int table(const Options& options) {
  std::printf(
      "| marker | pieces | method | compacted / before | tilted / compacted | tilted / before | farthest tilt | rounds "
      "| programs | CPU ms | valid |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  bool good = true;
  std::vector<Gains> gains(std::size(kMethods));
  for (const std::string& path : options.files) {
    std::ifstream in{path};
    std::stringstream text;
    text << in.rdbuf();
    const auto file = protocol::formats::read_marker(text.str());
    if (!file) return std::fprintf(stderr, "%s: %s\n", path.c_str(), file.error().message.c_str()), 1;
    const std::string name = path.substr(path.find_last_of('/') + 1);
    for (std::size_t k = 0; k < gains.size(); ++k) {
      good = print_row(options, name.substr(0, name.find_last_of('.')), *file, kMethods[k], gains[k]) && good;
    }
  }
  std::printf("\n");
  const double percent = 100.0 / static_cast<double>(options.files.size());
  for (std::size_t k = 0; k < gains.size(); ++k) {
    std::printf("Mean gain, %s: %.4f %% of the length before; by translation alone %.4f %%: %.2f times that.\n",
                kMethods[k].name, gains[k].tilt * percent, gains[k].compaction * percent,
                gains[k].tilt / gains[k].compaction);
  }
  return good ? 0 : 1;
}

}  // namespace
}  // namespace selvage::bench

int main(int argc, char** argv) {
  selvage::bench::Options options;
  std::vector<std::string> words{argv + 1, argv + argc};
  while (words.size() >= 2 && words[0].starts_with("--")) {
    if (words[0] == "--limit") options.limit = std::stod(words[1]);
    if (words[0] == "--perturbations") options.perturbations = std::stoi(words[1]);
    if (words[0] == "--outlines") options.outlines = words[1];
    words.erase(words.begin(), words.begin() + 2);
  }
  options.files = words;
  if (options.files.empty()) {
    std::fprintf(stderr, "usage: tilt_table [--limit DEGREES] [--perturbations N] [--outlines FOLDER] FILE...\n");
    return 2;
  }
  return selvage::bench::table(options);
}
