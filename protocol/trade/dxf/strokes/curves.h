// The runs of points that DXF entities draw: polylines with or without bulges, lines, arcs, circles, ellipses, splines.
#pragma once

#include <optional>

#include "protocol/trade/dxf/drawing.h"
#include "protocol/trade/flattening.h"
#include "protocol/trade/loops.h"

namespace selvage::protocol::trade::dxf::strokes {

// Returns none for an entity that draws no line.
[[nodiscard]] std::optional<Run> run_of(const Entity& entity, Flattening& flattening);

}  // namespace selvage::protocol::trade::dxf::strokes
