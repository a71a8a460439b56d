#include "protocol/trade/aama/finishing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/json/json_text.h"

namespace selvage::protocol::trade::aama {
namespace {

constexpr double kReach = 0.01;   // ends of runs that meet
constexpr double kWidestGap = 1;  // of a boundary that is closed nevertheless

std::string shown(double millimetres) {
  return json::number_text(std::round(millimetres * 1000) / 1000) + " mm";
}

void scale_spot(Spot& spot, double factor) {
  spot = {spot.x * factor, spot.y * factor};
}

// Joins the open runs over gaps of up to kWidestGap, the narrowest first.  The edge across a gap becomes a run of its
// own, so that both ends remain vertices.
void close_gaps(Loops& loops, std::vector<Note>& notes) {
  constexpr std::size_t kMostRuns = 500;  // a drawing of more open lines is no boundary with gaps
  if (loops.open.size() > kMostRuns) return;
  struct Gap {
    double width;
    std::size_t from, to;  // ends: two of each run
  };
  std::vector<Spot> ends;
  for (const Run& run : loops.open) ends.insert(ends.end(), {run.points.front(), run.points.back()});
  std::vector<Gap> gaps;
  for (std::size_t a = 0; a < ends.size(); ++a) {
    for (std::size_t b = a + 1; b < ends.size(); ++b) {
      const bool two_points = a / 2 == b / 2 && loops.open[a / 2].points.size() < 3;
      if (const double width = distance(ends[a], ends[b]); width <= kWidestGap && !two_points)
        gaps.push_back({width, a, b});
    }
  }
  std::stable_sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.width < b.width; });
  std::vector<bool> joined_end(ends.size());
  std::vector<Run> runs = loops.open;
  for (const Gap& gap : gaps) {
    if (joined_end[gap.from] || joined_end[gap.to]) continue;
    joined_end[gap.from] = joined_end[gap.to] = true;
    const std::size_t line = loops.open[gap.from / 2].line;
    runs.push_back({{ends[gap.from], ends[gap.to]}, {}, false, line});
    notes.push_back(note_at(line, "the boundary is open by " + shown(gap.width) + "; closed"));
  }
  Loops closed = joined(std::move(runs), 0);
  loops.open = std::move(closed.open);
  for (Loop& loop : closed.closed) {
    loop.runs = 1;
    loops.closed.push_back(std::move(loop));
  }
}

// Drops vertices so near to their predecessor that rounding has made them: such a step may even lead back across the
// outline.  Returns their number.
std::size_t drop_near_vertices(std::vector<Spot>& outline) {
  std::vector<Spot> kept;
  for (const Spot& point : outline) {
    if (kept.empty() || distance(kept.back(), point) > kReach) kept.push_back(point);
  }
  while (kept.size() > 1 && distance(kept.back(), kept.front()) <= kReach) kept.pop_back();
  if (kept.size() < 3) return 0;
  const std::size_t dropped = outline.size() - kept.size();
  outline = std::move(kept);
  return dropped;
}

void note_vertices(const Loop& loop, std::size_t count, const std::string& which, std::vector<Note>& notes) {
  if (count == 0) return;
  const bool behind = which != "repeated";
  const std::string vertices = count == 1 ? "1 " : std::to_string(count) + " ";
  const std::string noun = count == 1 ? "vertex" : "vertices";
  notes.push_back(note_at(loop.line, vertices + (behind ? noun + " " + which : which + " " + noun) + " left out"));
}

}  // namespace

void scale(PatternBlock& block, double factor) {
  if (factor == 1) return;
  for (Run& run : block.boundary) {
    for (Spot& point : run.points) scale_spot(point, factor);
    for (Edge& edge : run.edges) {
      if (edge.apex) scale_spot(*edge.apex, factor);
    }
  }
  for (document::Notch& notch : block.annotations.notches) {
    scale_spot(notch.at, factor);
    notch.depth *= factor;
    notch.width *= factor;
  }
  for (Spot& drill : block.annotations.drills) scale_spot(drill, factor);
  for (document::DrawnLine& line : block.annotations.lines) {
    for (Spot& point : line.points) scale_spot(point, factor);
  }
  for (document::DrawnText& text : block.annotations.texts) {
    scale_spot(text.at, factor);
    text.height *= factor;
  }
  for (Spot& spot : block.unmirrored_spots) scale_spot(spot, factor);
  for (blocks::GradedPoint& point : block.graded_points) scale_spot(point.at, factor);
  for (auto* lines : {&block.grains, &block.mirror_lines, &block.grade_references}) {
    for (auto& [from, to] : *lines) {
      scale_spot(from, factor);
      scale_spot(to, factor);
    }
  }
}

Result<std::vector<Spot>> boundary_of(const PatternBlock& block, std::vector<Note>& notes) {
  Loops loops = joined(block.boundary, kReach);
  if (!loops.open.empty()) close_gaps(loops, notes);
  const auto smaller = [](const auto& a, const auto& b) {
    return std::abs(doubled_area(a.points)) < std::abs(doubled_area(b.points));
  };
  const auto largest = std::max_element(loops.closed.begin(), loops.closed.end(), smaller);
  const auto open = std::max_element(loops.open.begin(), loops.open.end(), smaller);
  // A small closed line in an outline that does not close must not pass for the piece.
  if (open != loops.open.end() && (largest == loops.closed.end() || smaller(*largest, *open))) {
    return error_at(open->line, ErrorCode::kTooFewVertices,
                    "the boundary of block " + json::shortened(Json(block.name)) + " is not closed: its ends are " +
                        shown(distance(open->points.front(), open->points.back())) +
                        " apart, and no other line ends within 1 mm, which is allowed");
  }
  if (largest == loops.closed.end()) {
    return error_at(block.line, ErrorCode::kTooFewVertices,
                    "block " + json::shortened(Json(block.name)) + " has no boundary on layer 1");
  }
  if (largest->runs > 1) {
    notes.push_back(note_at(largest->line, "the boundary is joined of " + std::to_string(largest->runs) + " runs"));
  }
  if (loops.closed.size() > 1) {
    notes.push_back(note_at(
        block.line, std::to_string(loops.closed.size()) + " closed boundaries in one block; the largest counts"));
  }
  for (const Run& left : loops.open) notes.push_back(note_at(left.line, "an open line on the boundary layer left out"));
  std::size_t dropped = 0, near = 0;
  auto outline = without_repeats(containing_outline(*largest), dropped);
  if (largest->edges.empty()) near = drop_near_vertices(outline);
  note_vertices(*largest, dropped, "repeated", notes);
  note_vertices(*largest, near, "within 0.01 mm of the one before", notes);
  return outline;
}

void mirror_piece(PatternPiece& piece) {
  const document::Frame over{true, 0, {}};
  for (Spot& point : piece.outline) point = over.apply(point);
  std::reverse(piece.outline.begin() + 1, piece.outline.end());
  piece.annotations = placed(piece.annotations, over);
}

double turn_of_grain(const PatternBlock& block, std::vector<Note>& notes) {
  if (block.grains.empty()) {
    notes.push_back(note_at(block.line, "no grain line: the piece lies as drawn"));
    return 0;
  }
  const auto grain = *std::max_element(block.grains.begin(), block.grains.end(), [](const auto& a, const auto& b) {
    return distance(a.first, a.second) < distance(b.first, b.second);
  });
  if (block.grains.size() > 1) {
    notes.push_back(note_at(block.line, std::to_string(block.grains.size()) + " grain lines; the longest counts"));
  }
  const double dx = grain.second.x - grain.first.x, dy = grain.second.y - grain.first.y;
  double turn = -std::atan2(dy, dx) * 180 / std::numbers::pi;
  if (dx == 0 || dy == 0) turn = dx > 0 ? 0 : dx < 0 ? 180 : dy > 0 ? -90 : 90;  // exactly
  if (turn != 0) {
    notes.push_back(note_at(block.line, "turned by " + json::number_text(std::round(turn * 1e6) / 1e6 + 0.0) +
                                            " degrees: its grain did not lie along +x"));
  }
  return turn;
}

}  // namespace selvage::protocol::trade::aama
