// Closed outlines from the strokes of a drawing: runs of points whose ends meet are joined.
// Units: those of the drawing.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "protocol/document/annotations.h"

namespace selvage::protocol::trade {

// The connection from a point of a run to the next: a straight edge, or an arc that was flattened to a chord.
struct Edge {
  std::optional<document::Spot>
      apex;       // where the tangents at the arc's ends meet: the arc lies between it and the chord
  bool smooth{};  // the next edge continues the same curve
};

struct Run {
  std::vector<document::Spot> points;
  std::vector<Edge> edges{};  // empty when all are straight; else edges[k] follows points[k]
  bool closed{};              // the last point is joined to the first
  std::size_t line{};         // of the file, where the run begins
};

struct Loop {
  std::vector<document::Spot> points;  // the first is not repeated at the end
  std::vector<Edge> edges;             // as in a run
  std::size_t line{};
  std::size_t runs{1};  // of which it was joined
};
struct Loops {
  std::vector<Loop> closed;  // in the order of their first runs
  std::vector<Run> open;     // runs that could not be closed, joined as far as possible
};
// Open runs are joined, either way round, where their ends are at most `reach` apart; a run whose own ends are so near
// is closed.  Runs of fewer than two points are left out.
[[nodiscard]] Loops joined(std::vector<Run> runs, double reach);

// The loop's polygon, made to contain all that its arcs enclose: an arc that bulges outwards is replaced by its
// tangents, one that bulges inwards by its chords.
[[nodiscard]] std::vector<document::Spot> containing_outline(const Loop& loop);

// Twice the signed area; positive when counter-clockwise.
[[nodiscard]] double doubled_area(const std::vector<document::Spot>& points);
[[nodiscard]] double distance(document::Spot a, document::Spot b);
// Without the points that equal their predecessor, and without a last one that equals the first; `dropped` counts them.
[[nodiscard]] std::vector<document::Spot> without_repeats(const std::vector<document::Spot>& points,
                                                          std::size_t& dropped);
// Whether the point lies inside the closed outline; on its boundary, either.
[[nodiscard]] bool contains(const std::vector<document::Spot>& outline, document::Spot point);

// An outermost loop.
struct NestedLoop {
  Loop loop;
  std::vector<Loop> inner;   // all loops inside it, at any depth
  document::Spot low, high;  // of the loop's box
  std::size_t repeats{};     // how often the same loop is drawn again: a fill and its stroke, or a line cut twice
};
// The largest first; loops without area are left out, and repeated ones counted.
[[nodiscard]] std::vector<NestedLoop> nested(std::vector<Loop> loops);

// The first loop in which most of the points lie, and at least the first, the last or the middle one; null when there
// is none.  Of more than 64 points some are looked at, evenly chosen.
[[nodiscard]] NestedLoop* around_of(std::vector<NestedLoop>& outer, const std::vector<document::Spot>& points);

}  // namespace selvage::protocol::trade
