// An SVG drawing of a marker for people.  It is only written, never read; the same marker gives the same text.
//
// The strip lies along x with y upwards; pieces are coloured by shape (mirror images share a hue, neighbours do not),
// each named in its middle where there is room; a ruler runs along the length, the caption states length and
// utilisation.  A strip of more than six times its width is folded into rows of the same length, one below the other; a
// piece across the end of a row is drawn in both.  Coordinates are rounded to a hundredth of a pixel: outlines.h writes
// exact ones.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/marker/marker.h"
#include "protocol/document/annotations.h"
#include "protocol/document/marker_file.h"
#include "protocol/drawing/svg_overlay.h"

namespace selvage::protocol::drawing {

struct SvgOptions {
  std::vector<std::string> labels;                 // one per piece; empty: the pieces' ids
  std::vector<document::Annotations> annotations;  // one per shape; empty: none
  std::optional<Coord> length_before;              // where the marker ended before: a second, dashed line
  double height = 400;                             // of the strip, in pixels
  SvgOverlay overlay;                              // what happened, and why it stopped
};

[[nodiscard]] std::string to_svg(const Marker& marker, const SvgOptions& options = {});

// The options that suit a file: pieces are labelled by the id, together with the "name" their shape has, if
// the id does not contain it; annotations are those among the shapes' attributes.
[[nodiscard]] SvgOptions svg_options(const MarkerFile& file);

}  // namespace selvage::protocol::drawing
