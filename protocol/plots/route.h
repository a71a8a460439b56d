// The route of a knife: the order in which pieces are cut, and where each cut begins.
//
// A closed outline is cut from one of its vertices around to the same vertex, so the raised knife travels
// from the vertex of one piece to that of the next.  The order is that of the nearest neighbour from the
// origin, improved by 2-opt (a part of the route is reversed as long as that shortens it); then each piece's
// vertex is the best one between its two neighbours, and both are repeated.  Deterministic.  Units:
// millimetres.
#pragma once

#include <cstddef>
#include <vector>

#include "protocol/document/annotations.h"

namespace selvage::protocol::plots {

struct RouteStop {
  std::size_t piece{}, vertex{};  // of the piece's outline, where its cut begins and ends
};
struct Route {
  std::vector<RouteStop> stops;  // visits every piece once
  double travel{};               // of the raised knife, from the origin through all stops
};
// `before`: for each piece, those that are cut before it; none: any order.  They are moved forward in the route, and
// then the vertices are chosen once more.
[[nodiscard]] Route route_through(const std::vector<std::vector<document::Spot>>& outlines,
                                  const std::vector<std::vector<std::size_t>>& before = {});

// The travel in the order in which the outlines are given, starting each at its first vertex.
[[nodiscard]] double travel_as_given(const std::vector<std::vector<document::Spot>>& outlines);

}  // namespace selvage::protocol::plots
