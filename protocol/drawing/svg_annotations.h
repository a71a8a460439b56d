// Draws the annotations of a piece where it lies: notches, drill holes, inner lines and texts.
#pragma once

#include <string>

#include "core/marker/marker.h"
#include "protocol/document/annotations.h"
#include "protocol/drawing/svg_view.h"

namespace selvage::protocol::drawing {

// `annotations` are those of the piece's shape; `outline` is the outline of the placed piece.
[[nodiscard]] std::string annotations(const document::Annotations& annotations, const Marker& marker,
                                      const Piece& piece, const Polygon& outline, const View& view);

}  // namespace selvage::protocol::drawing
