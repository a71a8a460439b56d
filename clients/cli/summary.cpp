#include "clients/cli/summary.h"

#include <cmath>
#include <cstdio>

#include "protocol/formats/decimal_marker.h"
#include "protocol/json_text.h"

namespace selvage {
namespace {

// `value` with so many decimals, for reading only.
std::string rounded(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}
std::string per_cent(double part) {
  return rounded(100 * part, 4) + " %";
}
std::string significant(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

double to_microsecond(double ms) {
  return std::round(ms * 1000) / 1000;
}

std::string counted(std::size_t number, const std::string& one) {
  return std::to_string(number) + " " + one + (number == 1 ? "" : "s");
}

}  // namespace

std::string json_line(const CompactionFigures& f) {
  const Json line{{"name", f.name},
                  {"pieces", f.pieces},
                  {"length_before", f.length_before},
                  {"length_after", f.length_after},
                  {"utilisation_before", f.utilisation_before},
                  {"utilisation_after", f.utilisation_after},
                  {"rounds", f.rounds},
                  {"stop", name_of(f.stop)},
                  {"valid", f.valid},
                  {"healed",
                   {{"pairs", f.healed_pairs},
                    {"protruding", f.healed_protruding},
                    {"deepest", f.healed_deepest},
                    {"farthest_move", f.healed_farthest_move},
                    {"lengthened", f.healed_lengthened}}},
                  {"ms",
                   {{"sums", to_microsecond(f.times.sums)},
                    {"rows", to_microsecond(f.times.rows)},
                    {"solve", to_microsecond(f.times.solve)},
                    {"verify", to_microsecond(f.times.verify)},
                    {"total", to_microsecond(f.times.total)}}},
                  {"cache",
                   {{"hits", f.cache.hits},
                    {"misses", f.cache.misses},
                    {"entries", f.cache.entries},
                    {"bytes", f.cache.bytes}}}};
  return to_text(line) + "\n";
}

std::string plain_summary(const CompactionFigures& f, const Marker& marker) {
  const std::string unit = " " + marker.unit;
  std::string out = (f.name.empty() ? "marker" : f.name) + ": " + counted(f.pieces, "piece") + "\n";
  if (f.healed_pairs > 0 || f.healed_protruding > 0) {
    out += "  healed       " + counted(f.healed_pairs, "overlap") + ", " +
           counted(f.healed_protruding, "protrusion") + ", deepest " + significant(f.healed_deepest) + unit +
           ", moves up to " + significant(f.healed_farthest_move) + unit + "\n";
  }
  out += "  length       " + number_text(f.length_before) + " -> " + number_text(f.length_after) + unit +
         "  (" + rounded(100 * (f.length_after / f.length_before - 1), 3) + " %)\n";
  out += "  utilisation  " + per_cent(f.utilisation_before) + " -> " + per_cent(f.utilisation_after) + "\n";
  out += "  " + std::string{name_of(f.stop)} + " after " +
         counted(static_cast<std::size_t>(f.rounds), "round") + ", " + rounded(f.times.total, 1) + " ms; " +
         (f.valid ? "valid" : "NOT VALID") + "\n";
  return out;
}

std::string plain_figures(const Marker& marker) {
  return (marker.name.empty() ? "marker" : marker.name) + ": " + counted(marker.pieces.size(), "piece") +
         ", length " + number_text(to_decimal(length_of(marker), marker.resolution)) + " " + marker.unit +
         ", utilisation " + per_cent(utilisation_of(marker));
}

std::string plain_faults(const Marker& marker, const Validity& validity) {
  const auto length = [&](double lattice) { return significant(in_unit(lattice, marker.resolution)); };
  const auto id_of = [&](PieceId piece) { return marker.pieces[piece.value].id; };
  std::string out;
  for (const Overlap& overlap : validity.overlaps) {
    out += "  pieces " + id_of(overlap.first) + " and " + id_of(overlap.second) +
           (marker.spacing > 0 ? " are too close or overlap" : " overlap") + " by " + length(overlap.depth) +
           " " + marker.unit + " near (" + length(overlap.witness_x) + ", " + length(overlap.witness_y) +
           ")\n";
  }
  for (const Protrusion& protrusion : validity.protrusions) {
    out += "  piece " + id_of(protrusion.piece) + " leaves the strip by " +
           length(static_cast<double>(protrusion.by)) + " " + marker.unit + "\n";
  }
  return out;
}

}  // namespace selvage
