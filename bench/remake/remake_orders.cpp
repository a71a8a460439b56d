// Orders made of a garment marker (orders.h), remade from stored markers: one line of JSON for each order.
//
//   remake_orders --change NAME [--part P] [--first SEED] [--count N] [--tries N] [--trials N] [--fine]
//                 [--match BY] [--name-price P] [--size-price P] [--outlines FOLDER] [--write FILE]
//                 GARMENT.json [STORED.json...]
//
// The orders have the seeds SEED, SEED + 1, ...; without stored markers, the garment's own marker is the only
// one. --tries: tries for each order. --trials: trials of moving small pieces into gaps; 0 for none. --fine:
// also remakes every order with `fine`. --match: what pieces are compared by besides their shapes: `ids`
// (the default: an order's shapes have the ids of the garment's), or `shapes` (nothing: an order's shapes have ids of
// their own), and with such ids `names`, `sizes`, `labels`, which are both, or `whole`, which are names that contain
// the size. --name-price, --size-price: see core/matching/label.h. --outlines: also writes every result to the folder
// as placed outlines, for an independent judge. --write: only writes the order of the first seed to this file.
// Utilisations are parts of 1, times are processor time on one thread, with an empty cache of Minkowski sums for
// each order.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "bench/remake/orders.h"
#include "bench/support/marker_file.h"
#include "core/marker/validity.h"
#include "core/remake/remake.h"
#include "protocol/library/labels.h"

namespace {

using namespace selvage;

struct Options {
  bench::Change change{};
  double part{};
  std::uint64_t first{1}, count{1};
  bool fine{};
  std::string match{"ids"};
  std::string outlines, write;
  std::vector<std::string> paths;
  remake::RemakeSettings settings;
};

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::string_view name_of(remake::StepKind kind) {
  static constexpr std::string_view kNames[] = {"substituted", "separated", "popped",     "searched",    "compacted",
                                                "inserted",    "tilted",    "rearranged", "trims_moved", "refined"};
  return kNames[static_cast<std::size_t>(kind)];
}
Json steps_of(const remake::Attempt& attempt) {
  Json names = Json::array();
  for (const remake::Step& step : attempt.steps) names.push_back(name_of(step.kind));
  return names;
}

void write_result(const Options& options, std::uint64_t seed, const Marker& marker) {
  if (options.outlines.empty()) return;
  const std::string name = bench::name_of(options.paths.front()) + "-" + std::string{name_of(options.change)} + "-" +
                           std::to_string(options.part) + "-" + std::to_string(seed) + ".json";
  (void)bench::write_outlines(options.outlines + "/" + name, marker);
}

// With the labels that are compared.
matching::LabelledMarker labelled(const Options& options, const MarkerFile& file) {
  matching::LabelledMarker labelled = protocol::library::labelled(file);
  const bool whole = options.match == "whole";
  const bool names = options.match == "names" || options.match == "labels" || whole;
  const bool sizes = options.match == "sizes" || options.match == "labels";
  for (matching::Label& label : labelled.labels) {
    if (!names) label.name.clear();
    if (whole) label.name += label.size;
    if (!sizes) label.size.clear();
  }
  return labelled;
}

MarkerFile order_file(const Options& options, const MarkerFile& garment, std::uint64_t seed) {
  MarkerFile order = garment;
  order.marker = bench::order_of(garment, options.change, options.part, seed);
  order.attributes.pieces.clear();
  order.attributes.unplaced.assign(order.marker.unplaced.size(), Json::object());
  if (options.match != "ids") {
    for (Shape& shape : order.marker.shapes) shape.id.insert(0, "ordered ");
  }
  return order;
}

// Which parts of the order's pieces take the place of a piece of the same name, and of the same size, in the
// arrangement of the best prediction; whatever they were compared by.
void add_agreement(Json& line, const Options& options, const MarkerFile& order, const std::vector<MarkerFile>& files,
                   const std::vector<matching::LabelledMarker>& stored) {
  const auto found = remake::substitution::candidates_for(labelled(options, order), stored, true,
                                                          options.settings.attempt.tuning, serial());
  if (found.empty()) return;
  std::vector<matching::Label> slots;
  for (const std::size_t k : found[0].arrangement.stored) {
    const auto own = protocol::library::labelled(files[k]);
    slots.insert(slots.end(), own.labels.begin(),
                 own.labels.begin() + static_cast<std::ptrdiff_t>(own.marker.pieces.size()));
  }
  const auto labels = protocol::library::labelled(order).labels;
  double names = 0, sizes = 0;
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const auto& pair = found[0].pairing.pairs[k];
    if (!pair) continue;
    names += labels[k].name == slots[pair->slot].name ? 1 : 0;
    sizes += labels[k].size == slots[pair->slot].size ? 1 : 0;
  }
  line["same_name"] = names / static_cast<double>(labels.size());
  line["same_size"] = sizes / static_cast<double>(labels.size());
}

void remake_order(const Options& options, const MarkerFile& garment, const std::vector<MarkerFile>& files,
                  const std::vector<matching::LabelledMarker>& stored, std::uint64_t seed) {
  const MarkerFile file = order_file(options, garment, seed);
  const matching::LabelledMarker order = labelled(options, file);
  SumCache sums;
  const double begin = processor_seconds();
  const auto done = remake::remake(order, stored, options.settings, scene::Run{sums});
  Json line = Json::object();
  line["seed"] = seed;
  line["seconds"] = processor_seconds() - begin;
  add_agreement(line, options, file, files, stored);
  line["made"] = done && done->outcome == remake::Outcome::kRemade;
  if (done && !done->chosen && !done->attempts.empty()) line["steps"] = steps_of(done->attempts.front());
  if (done && done->chosen) {
    line["valid"] = is_valid(done->marker);
    line["utilisation"] = utilisation_of(done->marker);
    line["difference"] = done->attempts[*done->chosen].difference;
    line["stored"] = done->attempts[*done->chosen].used;
    line["tries"] = done->attempts.size();
    line["markers"] = done->attempts[*done->chosen].stored.size();
    line["steps"] = steps_of(done->attempts[*done->chosen]);
    write_result(options, seed, done->marker);
  }
  if (options.fine && done && done->chosen) {
    remake::RemakeSettings settings = options.settings;
    settings.attempt.fine = true;
    SumCache own;
    const double middle = processor_seconds();
    const auto fine = remake::remake(order, stored, settings, scene::Run{own});
    line["fine_seconds"] = processor_seconds() - middle;
    if (fine && fine->chosen) {
      line["fine"] = utilisation_of(fine->marker);
      line["fine_valid"] = is_valid(fine->marker);
    }
  }
  std::printf("%s\n", protocol::json::to_text(line).c_str());
  std::fflush(stdout);
}

bench::Change change_named(const std::string& name) {
  for (const bench::Change change : bench::kChanges) {
    if (name_of(change) == name) return change;
  }
  std::fprintf(stderr, "%s is not a known change\n", name.c_str());
  std::exit(EXIT_FAILURE);
}

Options options_in(int count, char** words) {
  Options options;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    if (word == "--fine") {
      options.fine = true;
    } else if (!word.starts_with("--")) {
      options.paths.push_back(word);
    } else if (k + 1 < count) {
      const char* const value = words[++k];
      if (word == "--change") options.change = change_named(value);
      if (word == "--part") options.part = std::strtod(value, nullptr);
      if (word == "--first") options.first = std::strtoull(value, nullptr, 10);
      if (word == "--count") options.count = std::strtoull(value, nullptr, 10);
      if (word == "--trials") options.settings.attempt.tuning.trim_trials = std::strtoull(value, nullptr, 10);
      if (word == "--tries") options.settings.tries = std::strtoull(value, nullptr, 10);
      if (word == "--match") options.match = value;
      if (word == "--name-price") options.settings.attempt.tuning.labels.name = std::strtod(value, nullptr);
      if (word == "--size-price") options.settings.attempt.tuning.labels.size = std::strtod(value, nullptr);
      if (word == "--outlines") options.outlines = value;
      if (word == "--write") options.write = value;
    }
  }
  options.settings.attempt.trims = options.settings.attempt.tuning.trim_trials > 0;
  if (options.paths.empty()) {
    std::fprintf(stderr, "remake_orders needs the marker of a garment\n");
    std::exit(EXIT_FAILURE);
  }
  return options;
}

}  // namespace

int main(int count, char** words) {
  const Options options = options_in(count, words);
  const MarkerFile garment = bench::marker_file_in(options.paths.front());
  if (!options.write.empty()) {
    const Marker order = bench::order_of(garment, options.change, options.part, options.first);
    return bench::write_marker(options.write, order, Format::kSparrow) ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  std::vector<MarkerFile> files;
  std::vector<matching::LabelledMarker> stored;
  for (std::size_t k = options.paths.size() > 1 ? 1 : 0; k < options.paths.size(); ++k) {
    files.push_back(bench::marker_file_in(options.paths[k]));
    stored.push_back(labelled(options, files.back()));
  }
  for (std::uint64_t k = 0; k < options.count; ++k) remake_order(options, garment, files, stored, options.first + k);
}
