// Converts the paths and basic shapes of SVG to runs of points, transformed and flattened.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "protocol/trade/flattening.h"
#include "protocol/trade/loops.h"

namespace selvage::protocol::trade::svg {

// x' = a x + c y + e, y' = b x + d y + f.
struct Matrix {
  double a{1}, b{}, c{}, d{1}, e{}, f{};
  [[nodiscard]] document::Spot apply(document::Spot p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  [[nodiscard]] document::Spot turn(document::Spot v) const { return {a * v.x + c * v.y, b * v.x + d * v.y}; }
  // First `inner`, then this.
  [[nodiscard]] Matrix after(const Matrix& inner) const;
};

// The value of a transform attribute: matrix, translate, scale, rotate, skewX and skewY; none when it is malformed.
[[nodiscard]] std::optional<Matrix> transform_in(std::string_view text);

// The subpaths of a path's d.  As SVG requires, a malformed path is drawn up to its error.
[[nodiscard]] std::vector<Run> runs_of_path(std::string_view d, const Matrix& matrix, Flattening& flattening);
// The points of a polygon or polyline.
[[nodiscard]] std::vector<Run> runs_of_points(std::string_view points, bool closed, const Matrix& matrix);
[[nodiscard]] Run run_of_ellipse(document::Spot centre, double rx, double ry, const Matrix& matrix,
                                 Flattening& flattening);

// A length such as "12.5mm" or "40", and its unit, "" for none.
struct Length {
  double value{};
  std::string_view unit;
};
[[nodiscard]] std::optional<Length> length_in(std::string_view text);
[[nodiscard]] std::vector<double> numbers_in(std::string_view text);

}  // namespace selvage::protocol::trade::svg
