// What is drawn over a marker to explain a motion: how the pieces went, the forces on them, and the tight chain that
// holds the length.
//
// Pieces often move by less than a pixel: arrows of motion are drawn longer by a round factor, which the caption tells.
#pragma once

#include <string>
#include <vector>

#include "core/marker/marker.h"
#include "core/motion/compaction/critical_path.h"
#include "protocol/drawing/svg_view.h"

namespace selvage::protocol::drawing {

// From a point; lattice units, or a force's own.
struct SvgArrow {
  double x{}, y{}, dx{}, dy{};
};
// A loaded contact; the line goes through it from the middle of one piece to that of the other, or to an edge.
struct SvgContact {
  double x{}, y{};
  double from_x{}, from_y{}, to_x{}, to_y{};
  double worth{};  // 0..1
};

struct SvgOverlay {
  std::vector<SvgArrow> moves;    // how each piece went
  std::vector<SvgArrow> forces;   // on pieces
  std::vector<SvgContact> chain;  // the tight chain
  friend bool operator==(const SvgOverlay&, const SvgOverlay&) = default;
};

// An arrow for every piece of `end` that lies elsewhere than the piece of the same id in `start`.
[[nodiscard]] std::vector<SvgArrow> moves_between(const Marker& start, const Marker& end);
[[nodiscard]] std::vector<SvgContact> chain_of(const Marker& marker, const motion::compaction::CriticalPath& path);

[[nodiscard]] std::string overlay(const SvgOverlay& drawn, const View& view);
// What the caption says of it; empty when there is nothing to say.  `height`: of the strip, in pixels.
[[nodiscard]] std::string overlay_legend(const SvgOverlay& drawn, const Marker& marker, double height);

}  // namespace selvage::protocol::drawing
