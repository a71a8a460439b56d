#include "protocol/trade/aama/finishing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/json/json_text.h"

namespace selvage::protocol::trade::aama {
namespace {

constexpr double kReach = 0.01;        // ends of runs that meet
constexpr double kWidestGap = 1;       // of a boundary that is closed nevertheless
constexpr double kOnMirrorLine = 0.1;  // a vertex so near lies on it

std::string shown(double millimetres) {
  return json::number_text(std::round(millimetres * 1000) / 1000) + " mm";
}

void scale_spot(Spot& spot, double factor) {
  spot = {spot.x * factor, spot.y * factor};
}

double distance_to_line(Spot point, const std::pair<Spot, Spot>& line) {
  const auto [a, b] = line;
  return std::abs((b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x)) / distance(a, b);
}

// The chain of edges on the line, as the index of its first vertex and the number of its edges: the longest such chain.
struct Chain {
  std::size_t first{}, edges{};
};
Chain chain_on(const std::vector<Spot>& outline, const std::pair<Spot, Spot>& line) {
  const std::size_t count = outline.size();
  std::vector<bool> on;
  for (const Spot& point : outline) on.push_back(distance_to_line(point, line) <= kOnMirrorLine);
  Chain best;
  double longest = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (!on[k] || on[(k + count - 1) % count]) continue;  // only where a chain begins
    std::size_t edges = 0;
    while (edges + 1 < count && on[(k + edges + 1) % count]) ++edges;
    const double length = distance(outline[k], outline[(k + edges) % count]);
    if (edges == 0 || length <= longest) continue;
    longest = length;
    best = {k, edges};
  }
  return best;
}

// The annotations of both halves.
void unfold_annotations(PatternBlock& block, const document::Frame& mirror, const std::pair<Spot, Spot>& line) {
  document::Annotations& own = block.annotations;
  const document::Annotations other = placed(own, mirror);
  const auto on_line = [&](Spot spot) { return distance_to_line(spot, line) <= kOnMirrorLine; };
  const auto single = [&](Spot spot) {
    return on_line(spot) || std::find(block.unmirrored_spots.begin(), block.unmirrored_spots.end(), spot) !=
                                block.unmirrored_spots.end();
  };
  for (std::size_t k = 0, count = own.notches.size(); k < count; ++k) {
    if (!single(own.notches[k].at)) own.notches.push_back(other.notches[k]);
  }
  for (std::size_t k = 0, count = own.drills.size(); k < count; ++k) {
    if (!single(own.drills[k])) own.drills.push_back(other.drills[k]);
  }
  for (std::size_t k = 0, count = own.lines.size(); k < count; ++k) {
    const auto& points = own.lines[k].points;
    if (block.mirrored[k] && !std::all_of(points.begin(), points.end(), on_line)) own.lines.push_back(other.lines[k]);
  }
  block.mirrored.resize(own.lines.size(), true);
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
  for (GradedPoint& point : block.graded_points) scale_spot(point.at, factor);
  for (auto* lines : {&block.grains, &block.mirror_lines, &block.grade_references}) {
    for (auto& [from, to] : *lines) {
      scale_spot(from, factor);
      scale_spot(to, factor);
    }
  }
}

Result<std::vector<Spot>> boundary_of(const PatternBlock& block, std::vector<Note>& notes) {
  Loops loops = joined(block.boundary, kReach);
  if (loops.closed.empty() && !loops.open.empty()) {
    const auto longest = std::max_element(loops.open.begin(), loops.open.end(),
                                          [](const Run& a, const Run& b) { return a.points.size() < b.points.size(); });
    const double gap = distance(longest->points.front(), longest->points.back());
    if (longest->points.size() > 2 && gap <= kWidestGap) {
      notes.push_back(note_at(longest->line, "the boundary is open by " + shown(gap) + "; closed"));
      loops.closed.push_back({longest->points, longest->edges, longest->line, 1});
    } else {
      return error_at(longest->line, ErrorCode::kTooFewVertices,
                      "the boundary of block " + json::shortened(Json(block.name)) + " is not closed: its ends are " +
                          shown(gap) + " apart; 1 mm is allowed");
    }
  }
  if (loops.closed.empty()) {
    return error_at(block.line, ErrorCode::kTooFewVertices,
                    "block " + json::shortened(Json(block.name)) + " has no boundary on layer 1");
  }
  const auto largest = std::max_element(loops.closed.begin(), loops.closed.end(), [](const Loop& a, const Loop& b) {
    return std::abs(doubled_area(a.points)) < std::abs(doubled_area(b.points));
  });
  if (largest->runs > 1) {
    notes.push_back(note_at(largest->line, "the boundary is joined of " + std::to_string(largest->runs) + " runs"));
  }
  if (loops.closed.size() > 1) {
    notes.push_back(note_at(
        block.line, std::to_string(loops.closed.size()) + " closed boundaries in one block; the largest counts"));
  }
  for (const Run& open : loops.open) notes.push_back(note_at(open.line, "an open line on the boundary layer left out"));
  std::size_t dropped = 0;
  auto outline = without_repeats(containing_outline(*largest), dropped);
  if (dropped > 0) {
    notes.push_back(note_at(largest->line, dropped == 1 ? "1 repeated vertex left out"
                                                        : std::to_string(dropped) + " repeated vertices left out"));
  }
  return outline;
}

void unfold(PatternBlock& block, std::vector<Spot>& outline, std::vector<Note>& notes) {
  if (block.mirror_lines.empty() || outline.size() < 3) return;
  const std::pair<Spot, Spot> line = block.mirror_lines.front();
  const Chain chain = chain_on(outline, line);
  if (chain.edges == 0) {
    notes.push_back(note_at(block.line, "no edge of the boundary lies on the mirror line: taken for a whole piece"));
    return;
  }
  const document::Frame mirror = document::reflection(line.first, line.second);
  // Runs from the end of the chain around to its beginning, and returns along the reflection of that.
  const std::size_t count = outline.size(), half = count - chain.edges + 1;
  std::vector<Spot> whole;
  for (std::size_t k = 0; k < half; ++k) whole.push_back(outline[(chain.first + chain.edges + k) % count]);
  for (std::size_t k = half - 1; k-- > 1;) whole.push_back(mirror.apply(whole[k]));
  outline = std::move(whole);
  unfold_annotations(block, mirror, line);
  notes.push_back(note_at(block.line, "a half piece, unfolded about its mirror line"));
  if (block.mirror_lines.size() > 1) {
    notes.push_back(note_at(block.line, std::to_string(block.mirror_lines.size()) + " mirror lines; the first counts"));
  }
}

bool may_lie_on_fold(const PatternBlock& block, const std::vector<Spot>& outline, std::vector<Note>& notes) {
  if (block.mirror_lines.empty() || outline.size() < 3) return false;
  const std::pair<Spot, Spot> line = block.mirror_lines.front();
  if (chain_on(outline, line).edges == 0) return false;
  std::vector<Note> ignored;
  const document::Frame turn{false, turn_of_grain(block, ignored), {}};
  const Spot from = turn.apply(line.first), to = turn.apply(line.second);
  const bool along = std::abs(to.y - from.y) <= kOnMirrorLine;
  if (!along) notes.push_back(note_at(block.line, "the mirror line does not run along the grain: unfolded"));
  const auto above = [&](const Spot& point) { return turn.apply(point).y >= std::min(from.y, to.y) - kOnMirrorLine; };
  const auto below = [&](const Spot& point) { return turn.apply(point).y <= std::max(from.y, to.y) + kOnMirrorLine; };
  return along &&
         (std::all_of(outline.begin(), outline.end(), above) || std::all_of(outline.begin(), outline.end(), below));
}

void lay_on_fold(const PatternBlock& block, const document::Frame& turn, PatternPiece& piece) {
  double fold = turn.apply(block.mirror_lines.front().first).y, middle = 0;
  for (const Spot& point : piece.outline) middle += point.y / static_cast<double>(piece.outline.size());
  if (middle < fold) {
    const document::Frame over{true, 0, {}};
    for (Spot& point : piece.outline) point = over.apply(point);
    std::reverse(piece.outline.begin() + 1, piece.outline.end());
    piece.annotations = placed(piece.annotations, over);
    fold = -fold;
  }
  double low = fold;
  for (const Spot& point : piece.outline) low = std::min(low, point.y);
  for (Spot& point : piece.outline) {
    if (point.y - low <= 2 * kOnMirrorLine) point.y = low;
  }
  piece.half = true;
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
    notes.push_back(note_at(block.line, "turned by " + json::number_text(std::round(turn * 1000) / 1000) +
                                            " degrees: its grain did not lie along +x"));
  }
  return turn;
}

}  // namespace selvage::protocol::trade::aama
