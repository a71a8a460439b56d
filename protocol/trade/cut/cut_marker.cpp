#include "protocol/trade/cut/cut_marker.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "protocol/formats/decimal_marker.h"
#include "protocol/trade/cut/cut_words.h"
#include "protocol/trade/placed_marker.h"

namespace selvage::protocol::trade::cut {
namespace {

constexpr double kTenthMillimetre = 0.1, kHundredthInch = 0.254;
constexpr double kReach = 0.15;     // millimetres, between the ends of runs
constexpr double kOvercut = 3;      // millimetres: how far a knife may cut beyond a corner
constexpr double kLeastArea = 100;  // square millimetres: smaller loops that such a gap closes are notches

double settle_unit(const CutCommands& commands, const ReadingOptions& options, std::vector<Note>& notes) {
  if (options.unit) {
    notes.push_back({"", "unit: " + std::string{kUnitWords[static_cast<int>(*options.unit)]} + ", as asked for"});
    return in_millimetres(*options.unit);
  }
  if (commands.unit == 71) {
    notes.push_back({"", "unit: 0.1 mm, by G71"});
    return kTenthMillimetre;
  }
  notes.push_back(
      {"", "unit: 1/100 in, since the file " + std::string{commands.unit ? "says G70" : "has neither G70 nor G71"}});
  return kHundredthInch;
}

void scale(CutPiece& piece, double unit) {
  const auto scale_spot = [unit](Spot& spot) { spot = rounded({spot.x * unit, spot.y * unit}); };
  for (std::vector<Run>* const runs : {&piece.runs, &piece.drawn}) {
    for (Run& run : *runs) {
      for (Spot& point : run.points) scale_spot(point);
    }
  }
  for (Spot& drill : piece.drills) scale_spot(drill);
  for (CutLabel& label : piece.labels) scale_spot(label.at);
}

// The part of a label "S:XL-A M:STYLE N:FRONT" that begins with the letter; empty if there is none.
std::string part_of(const std::string& label, char letter) {
  const std::string key = std::string{letter} + ":";
  const std::size_t at = label.starts_with(key) ? 0 : label.find(" " + key);
  if (at == std::string::npos) return {};
  const std::size_t from = at + key.size() + (at == 0 ? 0 : 1);
  std::size_t end = label.size();
  for (const char other : {'S', 'M', 'N'}) end = std::min(end, label.find(std::string{" "} + other + ":", from));
  return label.substr(from, end - from);
}

void describe(PlacedPattern& piece, const std::string& label) {
  const std::string bundle = part_of(label, 'S'), style = part_of(label, 'M'), name = part_of(label, 'N');
  piece.name = name.empty() ? label : name;
  if (!bundle.empty() && !name.empty()) {
    const std::size_t dash = bundle.rfind('-');
    piece.size = bundle.substr(0, dash);
    piece.attributes["bundle"] = bundle;
    if (!style.empty()) piece.attributes["style"] = style;
  }
  if (!label.empty()) piece.attributes["label"] = label;
}

// The loops of one piece, the largest first.  The start and the end of a knife's outline may differ slightly.
std::vector<Loop> loops_of(CutPiece& piece, std::vector<Run>& open, std::vector<Note>& notes,
                           const std::string& field) {
  Loops loops = joined(std::move(piece.runs), kReach);
  Loops wide = joined(loops.open, kOvercut);
  const auto is_piece = [](const Loop& loop) { return std::abs(doubled_area(loop.points)) / 2 >= kLeastArea; };
  open = std::move(loops.open);
  if (std::any_of(wide.closed.begin(), wide.closed.end(), is_piece)) {
    notes.push_back({field, "runs of the knife are joined over up to 3 mm"});
    open = std::move(wide.open);
    for (Loop& loop : wide.closed) loops.closed.push_back(std::move(loop));
  }
  std::stable_sort(loops.closed.begin(), loops.closed.end(), [](const Loop& a, const Loop& b) {
    return std::abs(doubled_area(a.points)) > std::abs(doubled_area(b.points));
  });
  return std::move(loops.closed);
}

// The pattern of an outline, the loops inside it, and the piece's label, drill holes and open cuts.
PlacedPattern pattern_of(const CutPiece& piece, const Loop& outline, const std::vector<Loop>& inner) {
  PlacedPattern placed;
  describe(placed, piece.labels.empty() ? std::string{} : piece.labels.front().text);
  std::size_t dropped = 0;
  placed.outline = without_repeats(outline.points, dropped);
  for (const Loop& loop : inner) {
    placed.annotations.lines.push_back({document::LineKind::kCutOut, true, loop.points});
  }
  for (const Run& run : piece.runs) {
    placed.annotations.lines.push_back({document::LineKind::kCutOut, false, run.points});
  }
  for (const Run& run : piece.drawn) {
    if (run.points.size() > 1) placed.annotations.lines.push_back({document::LineKind::kInternal, false, run.points});
  }
  placed.annotations.drills = piece.drills;
  return placed;
}

// The pieces of a file without N: every outermost loop is one, with the labels, drill holes and open cuts inside it.
void add_unnumbered(CutPiece all, std::vector<Loop> loops, PlacedMarker& marker) {
  std::vector<NestedLoop> outer = nested(std::move(loops));
  std::vector<CutPiece> pieces(outer.size());
  std::size_t outside = 0;
  const auto around = [&](const std::vector<Spot>& points) -> CutPiece* {
    const NestedLoop* const found = outer.size() == 1 ? outer.data() : around_of(outer, points);
    if (!found) ++outside;
    return found ? &pieces[static_cast<std::size_t>(found - outer.data())] : nullptr;
  };
  for (CutLabel& label : all.labels) {
    if (CutPiece* const piece = around({label.at})) piece->labels.push_back(std::move(label));
  }
  for (const Spot& drill : all.drills) {
    if (CutPiece* const piece = around({drill})) piece->drills.push_back(drill);
  }
  for (Run& run : all.runs) {
    if (CutPiece* const piece = around(run.points)) piece->runs.push_back(std::move(run));
  }
  for (Run& run : all.drawn) {
    if (CutPiece* const piece = around(run.points)) piece->drawn.push_back(std::move(run));
  }
  if (outside > 0) {
    marker.notes.push_back(
        {"", std::to_string(outside) + " labels, drill holes and open cuts outside of all pieces are left out"});
  }
  for (std::size_t k = 0; k < outer.size(); ++k) {
    marker.pieces.push_back(pattern_of(pieces[k], outer[k].loop, outer[k].inner));
  }
}

}  // namespace

Result<MarkerFile> read_cut_marker(std::string_view text, const ReadingOptions& options) {
  CutCommands commands = read_commands(text);
  PlacedMarker marker;
  marker.name = commands.message;
  marker.notes = std::move(commands.notes);
  const double unit = settle_unit(commands, options, marker.notes);
  for (CutPiece& piece : commands.pieces) {
    const std::string field = piece.number > 0 ? "/piece/" + std::to_string(piece.number) : "";
    scale(piece, unit);
    std::vector<Run> open;
    std::vector<Loop> loops = loops_of(piece, open, marker.notes, field);
    piece.runs = std::move(open);
    if (loops.empty()) {
      marker.notes.push_back({field, "no closed outline is cut; left out"});
    } else if (commands.numbered) {
      marker.pieces.push_back(pattern_of(piece, loops.front(), {loops.begin() + 1, loops.end()}));
      marker.pieces.back().field = field;
    } else {
      add_unnumbered(std::move(piece), std::move(loops), marker);
    }
  }
  return file_of(std::move(marker), options);
}

}  // namespace selvage::protocol::trade::cut
