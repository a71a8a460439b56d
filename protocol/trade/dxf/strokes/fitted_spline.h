// The curve through the fit points of a SPLINE that has no control points.
//
// DXF defines a spline by its control points and knots; the fit points are only what a drafter clicked, and from them
// alone programs compute slightly different curves.  Here it is the cubic spline whose parameter grows by the distance
// between the points [Farin, Curves and Surfaces for CAGD, chapter 9], twice continuously differentiable; with the end
// tangents of the file, otherwise with natural ends, and periodic if it is closed.  Units: those of the drawing.
#pragma once

#include <optional>

#include "protocol/trade/dxf/drawing.h"
#include "protocol/trade/flattening.h"
#include "protocol/trade/loops.h"

namespace selvage::protocol::trade::dxf::strokes {

// Whether the entity is a SPLINE that only its fit points define: what it draws is an assumption, which a reader notes.
[[nodiscard]] bool is_fitted(const Entity& entity);
inline constexpr std::string_view kFittedNote =
    "SPLINE has fit points only: the cubic spline through them is assumed, parametrised by their distances";

// None if it has fewer than two different fit points.
[[nodiscard]] std::optional<Run> fitted_run(const Entity& spline, Flattening& flattening);

}  // namespace selvage::protocol::trade::dxf::strokes
