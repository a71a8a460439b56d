#include "protocol/trade/aama/unfolding.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "protocol/json/json_text.h"
#include "protocol/trade/aama/finishing.h"

namespace selvage::protocol::trade::aama {
namespace {

constexpr double kOnMirrorLine = 0.1;  // millimetres: a vertex this near lies on it
constexpr double kMostBeyond = 1;    // millimetres beyond it: an outline that reaches no farther is drawn inaccurately
constexpr double kLeastOpening = 1;  // square millimetres; smaller ones come from rounding

using Line = std::pair<Spot, Spot>;

// To the left of the line, positive.
double side_of_line(Spot point, const Line& line) {
  const auto [a, b] = line;
  return ((b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x)) / distance(a, b);
}
bool is_on(Spot point, const Line& line) {
  return std::abs(side_of_line(point, line)) <= kOnMirrorLine;
}

// Consecutive vertices on the line: the index of the first, and the number of edges between them; none for a vertex
// alone.
struct Chain {
  std::size_t first{}, edges{};
};

// In the order of the outline; none if all of its vertices satisfy the condition to lie on the line.
template <class IsOn>
std::vector<Chain> chains_of(const std::vector<Spot>& outline, IsOn is_on_line) {
  const std::size_t count = outline.size();
  std::vector<bool> on;
  for (const Spot& point : outline) on.push_back(is_on_line(point));
  std::vector<Chain> chains;
  for (std::size_t k = 0; k < count; ++k) {
    if (!on[k] || on[(k + count - 1) % count]) continue;  // only where a chain begins
    Chain chain{k, 0};
    while (chain.edges + 1 < count && on[(k + chain.edges + 1) % count]) ++chain.edges;
    chains.push_back(chain);
  }
  return chains;
}

std::vector<Chain> chains_on(const std::vector<Spot>& outline, const Line& line) {
  return chains_of(outline, [&](const Spot& point) { return is_on(point, line); });
}

// The chain with the most distant ends; none if there are only single vertices.
std::optional<Chain> longest_of(const std::vector<Chain>& chains, const std::vector<Spot>& outline) {
  const auto length = [&](const Chain& chain) {
    return distance(outline[chain.first], outline[(chain.first + chain.edges) % outline.size()]);
  };
  const auto longest = std::max_element(chains.begin(), chains.end(),
                                        [&](const Chain& a, const Chain& b) { return length(a) < length(b); });
  if (longest == chains.end() || longest->edges == 0) return std::nullopt;
  return *longest;
}

// The vertices from the end of each chain to the beginning of the next, both included.
std::vector<std::vector<Spot>> between(const std::vector<Chain>& chains, const std::vector<Spot>& outline) {
  const std::size_t count = outline.size();
  std::vector<std::vector<Spot>> ways;
  for (std::size_t k = 0; k < chains.size(); ++k) {
    const std::size_t from = chains[k].first + chains[k].edges;
    std::size_t to = chains[(k + 1) % chains.size()].first;
    while (to <= from) to += count;
    std::vector<Spot>& way = ways.emplace_back();
    for (std::size_t at = from; at <= to; ++at) way.push_back(outline[at % count]);
  }
  return ways;
}

// The way and, back to its beginning, its reflection.
std::vector<Spot> with_reflection(const std::vector<Spot>& way, const document::Frame& mirror) {
  std::vector<Spot> whole = way;
  for (std::size_t k = way.size() - 1; k-- > 1;) whole.push_back(mirror.apply(way[k]));
  return whole;
}

// The annotations of both halves.
void unfold_annotations(PatternBlock& block, const document::Frame& mirror, const Line& line) {
  document::Annotations& own = block.annotations;
  const document::Annotations other = placed(own, mirror);
  const auto on_line = [&](Spot spot) { return is_on(spot, line); };
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

// How far the outline reaches to each side of the line.
struct Reach {
  double left{}, right{};
  [[nodiscard]] double beyond() const { return std::min(left, right); }
};
Reach reach_of(const std::vector<Spot>& outline, const Line& line) {
  Reach reach;
  for (const Spot& point : outline) {
    const double side = side_of_line(point, line);
    reach.left = std::max(reach.left, side);
    reach.right = std::max(reach.right, -side);
  }
  return reach;
}

void note_other_lines(const PatternBlock& block, const Line& line, std::vector<Note>& notes) {
  const auto same = [&](const Line& other) { return is_on(other.first, line) && is_on(other.second, line); };
  if (std::all_of(block.mirror_lines.begin(), block.mirror_lines.end(), same)) return;
  notes.push_back(note_at(block.line, std::to_string(block.mirror_lines.size()) + " mirror lines; the first counts"));
}

void leave_folded(PatternBlock& block, double beyond, std::vector<Note>& notes) {
  notes.push_back(note_at(block.line, "the piece reaches " + json::number_text(std::round(beyond * 100) / 100) +
                                          " mm beyond its mirror line, where its reflection would overlap it: not "
                                          "unfolded, it lies as drawn"));
  for (const Line& drawn : block.mirror_lines) {
    block.annotations.lines.push_back({document::LineKind::kMirror, false, {drawn.first, drawn.second}});
    block.mirrored.push_back(true);
  }
}

}  // namespace

void unfold(PatternBlock& block, std::vector<Spot>& outline, std::vector<Note>& notes) {
  if (block.mirror_lines.empty() || outline.size() < 3) return;
  const Line line = block.mirror_lines.front();
  if (!longest_of(chains_on(outline, line), outline)) {
    notes.push_back(note_at(block.line, "no edge of the boundary lies on the mirror line: taken for a whole piece"));
    return;
  }
  const Reach reach = reach_of(outline, line);
  if (reach.beyond() > kMostBeyond) return leave_folded(block, reach.beyond(), notes);
  const double side = reach.left > reach.right ? 1 : -1;
  const auto chains =
      chains_of(outline, [&](const Spot& point) { return side * side_of_line(point, line) <= kOnMirrorLine; });
  // A half piece on one side of the line goes along it, leaves it and comes back.  The way that spans the others is
  // the outline of the whole piece; any other one encloses an opening in it.
  std::vector<std::vector<Spot>> ways = between(chains, outline);
  if (ways.empty()) return;
  const auto outer = std::max_element(ways.begin(), ways.end(), [](const auto& a, const auto& b) {
    return distance(a.front(), a.back()) < distance(b.front(), b.back());
  });
  const document::Frame mirror = document::reflection(line.first, line.second);
  outline = with_reflection(*outer, mirror);
  unfold_annotations(block, mirror, line);
  std::size_t openings = 0;
  for (auto way = ways.begin(); way != ways.end(); ++way) {
    std::vector<Spot> opening = with_reflection(*way, mirror);
    if (way == outer || std::abs(doubled_area(opening)) / 2 < kLeastOpening) continue;
    block.annotations.lines.push_back({document::LineKind::kCutOut, true, std::move(opening)});
    block.mirrored.push_back(true);
    ++openings;
  }
  notes.push_back(note_at(block.line, "a half piece, unfolded about its mirror line"));
  if (openings > 0) {
    notes.push_back(note_at(block.line, "it leaves the mirror line and comes back: " + std::to_string(openings) +
                                            (openings == 1 ? " opening is" : " openings are") +
                                            " cut out of the unfolded piece"));
  }
  note_other_lines(block, line, notes);
}

bool may_lie_on_fold(const PatternBlock& block, const std::vector<Spot>& outline, std::vector<Note>& notes) {
  if (block.mirror_lines.empty() || outline.size() < 3) return false;
  const Line line = block.mirror_lines.front();
  if (!longest_of(chains_on(outline, line), outline)) return false;
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
    mirror_piece(piece);
    fold = -fold;
  }
  double low = fold;
  for (const Spot& point : piece.outline) low = std::min(low, point.y);
  for (Spot& point : piece.outline) {
    if (point.y - low <= 2 * kOnMirrorLine) point.y = low;
  }
  piece.half = true;
}

}  // namespace selvage::protocol::trade::aama
