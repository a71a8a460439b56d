// What is drawn over a marker to explain a motion: how the pieces moved, the forces on them, and the critical
// path.
//
// Pieces often move by less than a pixel, so arrows of motion are enlarged by a round factor, which the caption states.
#pragma once

#include <string>
#include <vector>

#include "core/marker/marker.h"
#include "core/motion/compaction/critical_path.h"
#include "protocol/drawing/svg_view.h"

namespace selvage::protocol::drawing {

// An arrow from a point, in lattice units or in units of force.
struct SvgArrow {
  double x{}, y{}, dx{}, dy{};
};
// A contact of the critical path.  The line through it joins the middles of two pieces, or of a piece and an edge.
struct SvgContact {
  double x{}, y{};
  double from_x{}, from_y{}, to_x{}, to_y{};
  double worth{};  // 0..1
};

struct SvgOverlay {
  std::vector<SvgArrow> moves;    // how each piece moved
  std::vector<SvgArrow> forces;   // on pieces
  std::vector<SvgContact> chain;  // the critical path
  friend bool operator==(const SvgOverlay&, const SvgOverlay&) = default;
};

// An arrow for every piece of `end` whose position differs from that of the piece with the same id in `start`.
[[nodiscard]] std::vector<SvgArrow> moves_between(const Marker& start, const Marker& end);
[[nodiscard]] std::vector<SvgContact> chain_of(const Marker& marker, const motion::compaction::CriticalPath& path);

[[nodiscard]] std::string overlay(const SvgOverlay& drawn, const View& view);
// What the caption says about the overlay; empty if there is nothing to say.  `height`: of the strip, in pixels.
[[nodiscard]] std::string overlay_legend(const SvgOverlay& drawn, const Marker& marker, double height);

}  // namespace selvage::protocol::drawing
