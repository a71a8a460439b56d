// Markers with outlines like those that a digitiser produces: pieces of hundreds of vertices, hardly any of them
// collinear with its neighbours.
#pragma once

#include "core/marker/marker.h"

namespace selvage::test {

// Cuts every edge of every shape into segments of at most `pitch` (lattice units), and moves the new vertices inwards
// by up to `noise`.  The result is the same on every call.  Every piece lies within the original piece, so a valid
// marker stays valid.
// REQUIRES: no shape exceeds kMaxVertices; `noise` is small compared with the features of the shapes.
[[nodiscard]] Marker digitised(const Marker& marker, Coord pitch, Coord noise);

}  // namespace selvage::test
