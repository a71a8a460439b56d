// Markers as a digitiser leaves them: pieces of hundreds of vertices, none quite in line with its neighbours.
#pragma once

#include "core/marker/marker.h"

namespace selvage::test {

// The marker with every edge of every shape cut into stretches of at most `pitch` (lattice units), and the vertices
// that this makes moved inwards by up to `noise`, the same on every call: every piece lies within what it was, so a
// valid marker stays valid.  REQUIRES: no shape comes to more than kMaxVertices; noise is small beside the shapes'
// features.
[[nodiscard]] Marker digitised(const Marker& marker, Coord pitch, Coord noise);

}  // namespace selvage::test
