// What is drawn on a piece besides its outline: notches, drill holes, inner lines and texts, where the piece lies.
#pragma once

#include <string>

#include "core/marker/marker.h"
#include "protocol/document/annotations.h"
#include "protocol/drawing/svg_view.h"

namespace selvage::protocol::drawing {

// `annotations` are those of the piece's shape; `outline` is where the piece lies.
[[nodiscard]] std::string annotations(const document::Annotations& annotations, const Marker& marker,
                                      const Piece& piece, const Polygon& outline, const View& view);

}  // namespace selvage::protocol::drawing
