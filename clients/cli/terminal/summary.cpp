#include "clients/cli/terminal/summary.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "protocol/formats/decimal_marker.h"
#include "protocol/json/json_text.h"

namespace selvage::cli::terminal {
namespace {

std::string per_cent(double part) {
  return rounded(100 * part, 2) + " %";
}
// With four digits; from 10,000 on with all digits before the point, not as 1.234e+04.
std::string significant(double value) {
  char text[32];
  std::snprintf(text, sizeof text, std::abs(value) < 9999.5 ? "%.4g" : "%.0f", value);
  return text;
}

double to_microsecond(double ms) {
  return std::round(ms * 1000) / 1000;
}

// "work_limit" becomes "work limit".
std::string in_words(std::string word) {
  std::replace(word.begin(), word.end(), '_', ' ');
  return word;
}

std::string counted(std::size_t number, const std::string& one) {
  return std::to_string(number) + " " + one + (number == 1 ? "" : "s");
}

// "lengthBefore" becomes "length_before".
std::string snake_case(std::string_view name) {
  std::string out;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') {
      out += '_';
      out += static_cast<char>(c - 'A' + 'a');
    } else {
      out += c;
    }
  }
  return out;
}
Json in_snake_case(const Json& value) {
  if (!value.is_object()) return value;
  Json named = Json::object();
  for (const auto& [key, field] : value.items()) named[snake_case(key)] = in_snake_case(field);
  return named;
}

std::string repair_line(const Json& repair, const std::string& unit) {
  const auto pairs = repair["pairs"].get<std::size_t>();
  const auto protruding = repair["protruding"].get<std::size_t>();
  if (pairs == 0 && protruding == 0) return {};
  return "  repaired     " + counted(pairs, "overlap") + ", " + counted(protruding, "protrusion") + ", deepest " +
         significant(repair["deepest"].number()) + unit + ", moves up to " +
         significant(repair["farthestMove"].number()) + unit + "\n";
}

// The final position of a single piece that moved, and the pieces that stop it if the motion reports them.
std::string position_line(const Json& fields, const std::string& unit) {
  const Json& at = fields["at"];
  std::string out = "  position     " + length_text(at[0].number()) + ", " + length_text(at[1].number()) + unit;
  if (!fields.contains("touching")) return out + "\n";
  std::string by;
  for (const Json& id : fields["touching"]) by += (by.empty() ? ", stopped by " : ", ") + id.text();
  return out + by + "\n";
}

constexpr std::size_t kMostPairs = 20;  // that a summary names
constexpr double kNoDifference = 1e-5;  // between a length and its bound: this part of the length

// How far a separation moved the pieces, the overlaps that remain and the pieces that it took off the cloth.  A depth
// of 0 was not measured.
std::string separation_lines(const Json& fields, const std::string& unit) {
  std::string out = "  moved        " + significant(fields["moved"].number()) + unit + " in all, " +
                    significant(fields["farthestMove"].number()) + unit + " at most\n";
  const Json& remaining = fields["remaining"];
  for (std::size_t k = 0; k < std::min(remaining.size(), kMostPairs); ++k) {
    const Json& pair = remaining[k];
    const double depth = pair["depth"].number();
    out += "  overlapping  " + pair["first"].text() + " and " + pair["second"].text() +
           (depth > 0 ? " by " + significant(depth) + unit : "") + "\n";
  }
  if (remaining.size() > kMostPairs) {
    out += "  overlapping  " + counted(remaining.size() - kMostPairs, "more pair") + "\n";
  }
  for (const Json& id : fields["popped"]) out += "  popped out   " + id.text() + "\n";
  return out;
}

bool may_overlap(const Marker& marker) {
  const auto may = [](const Piece& piece) { return piece.overlap > 0; };
  return marker.overlap > 0 || std::ranges::any_of(marker.pieces, may) || std::ranges::any_of(marker.unplaced, may);
}

// What an exact search has proved about the length, and how near the bound is.
std::string bound_text(const Json& fields, const Marker& marker, const std::string& unit) {
  const double bound = fields["bound"].number();
  const bool proved = fields["proved"] == true;
  if (fields["found"] != true) {
    // Where there is no layout, the bound may be the end of the lattice.
    const double end = to_decimal(marker.strip.last().value_or(kLatticeLimit), marker.resolution);
    if (proved || bound >= end) return proved ? "no layout, proved" : "no layout so far";
    return length_text(bound) + unit + ", no layout so far";
  }
  if (bound <= 0) return may_overlap(marker) ? "none, because pieces may overlap" : "none";
  const double length = fields["lengthAfter"].number();
  const std::string text = length_text(bound) + unit;
  if (proved && length - bound <= kNoDifference * length) return text + ", the shortest, proved";
  if (proved) return text + ", the shortest but for up to " + significant(length - bound) + unit + ", proved";
  const std::string shorter = text + ", at most " + rounded(100 * (1 - bound / length), 3) + " % shorter";
  return fields["stop"].text() == "converged" ? shorter + "; more nodes do not close the gap" : shorter;
}

// What an exact search has proved.  It leaves tilts as they are, so where shapes allow others, that is said.
std::string search_lines(const Json& fields, const Marker& marker, const std::string& unit) {
  std::string out;
  if (fields.contains("verdict")) out += "  pieces       " + fields["verdict"].text() + "\n";
  if (fields.contains("bound")) {
    out += "  bound        " + bound_text(fields, marker, unit);
    const bool may_tilt =
        std::ranges::any_of(marker.shapes, [](const Shape& shape) { return shape.tilt_limit.degrees > 0; });
    out += may_tilt ? " (with the present tilts)\n" : "\n";
  }
  if (fields.contains("nodes")) out += "  nodes        " + std::to_string(fields["nodes"].get<std::uint64_t>()) + "\n";
  return out;
}

// The attempts of a remake, with the utilisation after each step.
std::string remake_lines(const Json& f) {
  const std::string& outcome = f["outcome"].text();
  std::string out;
  for (std::size_t k = 0; k < f["attempts"].size(); ++k) {
    const Json& attempt = f["attempts"][k];
    out += "  attempt " + std::to_string(k + 1) + "    pieces differ by " +
           rounded(100 * attempt["difference"].number(), 1) + " %";
    for (const Json& step : attempt["steps"]) {
      out += ", " + step["step"].text() + " " + per_cent(step["utilisation"].number());
    }
    if (attempt["made"] != true) out += ", overlaps remain";
    if (f.contains("chosen") && f["chosen"].get<std::size_t>() == k) out += "; chosen";
    out += "\n";
  }
  if (outcome == "none_near") out += "  no stored marker is similar enough\n";
  if (outcome == "nested") out += "  nested from nothing\n";
  return out;
}

}  // namespace

std::string json_line(const Json& fields, const protocol::execution::StageTimes& times,
                      const minkowski::CacheCounts& cache) {
  Json line = in_snake_case(fields);
  line.erase("placements");
  line["ms"] = {{"decomposition", to_microsecond(times.decomposition)},
                {"sums", to_microsecond(times.sums)},
                {"rows", to_microsecond(times.rows)},
                {"solve", to_microsecond(times.solve)},
                {"verify", to_microsecond(times.verify)},
                {"total", to_microsecond(times.total)}};
  line["cache"] = {{"hits", cache.hits}, {"misses", cache.misses}, {"entries", cache.entries}, {"bytes", cache.bytes}};
  return protocol::json::to_text(line) + "\n";
}

std::string plain_summary(const Json& f, const protocol::execution::StageTimes& times, const Marker& marker,
                          const Style& style) {
  const std::string unit = " " + marker.unit;
  const double before = f["lengthBefore"].number();
  const double after = f["lengthAfter"].number();
  std::string out = style.strong(marker.name.empty() ? "marker" : marker.name) + ": " +
                    counted(f["pieces"].get<std::size_t>(), "piece") + "\n";
  out += repair_line(f["healed"], unit);
  if (f.contains("at")) out += position_line(f, unit);
  if (f.contains("remaining")) out += separation_lines(f, unit);
  if (f.contains("leastAfter")) {
    out += "  least gap    " + significant(f["leastBefore"].number()) + " -> " + significant(f["leastAfter"].number()) +
           unit + "\n";
  }
  if (f.contains("gain")) out += "  gain         " + significant(f["gain"].number()) + unit + "\n";
  out += search_lines(f, marker, unit);
  if (f.contains("attempts")) out += remake_lines(f);
  if (f.contains("unplaced") && f["unplaced"].get<std::size_t>() > 0) {
    out += "  left over    " + counted(f["unplaced"].get<std::size_t>(), "piece") + "\n";
  }
  out += "  length       " + length_text(before) + " -> " + length_text(after) + unit;
  if (before > 0)
    out += "  (" + (after < before ? style.good(change_text(before, after)) : change_text(before, after)) + ")";
  out += "\n";
  out += "  utilisation  " + per_cent(f["utilisationBefore"].number()) + " -> " +
         per_cent(f["utilisationAfter"].number()) + "\n  ";
  if (f.contains("rounds")) {
    out += in_words(f["stop"].text()) + " after " + counted(f["rounds"].get<std::size_t>(), "round") + ", ";
  }
  out += rounded(times.total, 1) + " ms; " + (f["valid"] == true ? style.good("valid") : style.bad("NOT VALID")) + "\n";
  return out;
}

std::string plain_figures(const Marker& marker) {
  const std::string unplaced =
      marker.unplaced.empty() ? "" : ", " + std::to_string(marker.unplaced.size()) + " unplaced";
  return (marker.name.empty() ? "marker" : marker.name) + ": " + counted(piece_count(marker), "piece") + unplaced +
         ", length " + length_text(to_decimal(length_of(marker), marker.resolution)) + " " + marker.unit +
         ", utilisation " + per_cent(utilisation_of(marker));
}

std::string plain_violations(const Marker& marker, const Json& validity) {
  const std::string unit = " " + marker.unit;
  std::string out;
  for (const Json& overlap : validity["overlaps"]) {
    out += "  pieces " + overlap["first"].text() + " and " + overlap["second"].text() +
           (marker.spacing > 0 ? " are too close or overlap" : " overlap") + " by " +
           significant(overlap["depth"].number()) + unit + (may_overlap(marker) ? " too much" : "") + " near (" +
           length_text(overlap["witness"][0].number()) + ", " + length_text(overlap["witness"][1].number()) + ")\n";
  }
  for (const Json& protrusion : validity["protrusions"]) {
    const std::string& id = protrusion["piece"].text();
    const auto piece = std::ranges::find(marker.pieces, id, &Piece::id);
    const bool ruled = piece != marker.pieces.end() && piece->rules.own_room();
    out += "  piece " + id + (ruled ? " leaves the area that its rules allow by " : " leaves the strip by ");
    out += significant(protrusion["by"].number()) + unit + "\n";
  }
  for (const Json& shade : validity.value("shades", Json::array())) {
    out += "  the pieces of shade " + shade["shade"].text() + ", from " + shade["leftmost"].text() + " to " +
           shade["rightmost"].text() + ", are spread over " + significant(shade["by"].number()) + unit +
           " more of the length than allowed\n";
  }
  for (const Json& match : validity.value("matches", Json::array())) {
    out += "  piece " + match["piece"].text() + " of match set " + match["matchSet"].text() + " lies " +
           significant(match["by"][0].number()) + ", " + significant(match["by"][1].number()) + unit +
           " off the repeats of " + match["other"].text() + "\n";
  }
  return out;
}

std::string plain_change(const Json& figures) {
  const std::string by = figures.value("by", "");
  return "revision " + protocol::json::to_text(figures["revision"]) + ": length " +
         length_text(figures["length"].number()) + ", utilisation " + per_cent(figures["utilisation"].number()) + ", " +
         (figures["valid"] == true ? "valid" : "NOT valid") + (by.empty() ? "" : "; " + by);
}

}  // namespace selvage::cli::terminal
