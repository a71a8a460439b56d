// Dissection: the vertices of a graph divided into domains and a small border that separates them, so that the columns
// of each domain can be eliminated independently of the other domains' [Geo73].
//
// The graph is given by its nets: all vertices of a net are adjacent to each other.  The vertices of a component are
// sorted into levels by their distance from a vertex at one of its ends, which a breadth-first search finds, started at
// the end of an earlier one [GL79].  A level separates what is before it from what is after it.  The graph is cut near
// every multiple of 1/domains of its vertices, at the nearby level that has the fewest vertices adjacent to the next
// level; these vertices form the border, together with the hubs: vertices in so many nets that they would join
// everything.  Deterministic: the result depends on the nets and the number of domains alone.
#pragma once

#include <vector>

namespace selvage::lp::elimination {

struct Nets {
  int vertices{};
  std::vector<int> start{0};  // the vertices of net k are at start[k] up to start[k + 1], each once
  std::vector<int> vertex;
  [[nodiscard]] int count() const { return static_cast<int>(start.size()) - 1; }
};

struct Dissection {
  static constexpr int kBorder = -1;
  // The border has at most kMostBorder of the vertices, and no domain exceeds an equal share by more than kMostExcess
  // of it.
  static constexpr double kMostBorder = 0.125;
  static constexpr double kMostExcess = 0.5;

  int domains{1};
  std::vector<int> domain_of;  // of each vertex; kBorder for those of the border
};

// Laws.  (1) No net has vertices of two domains.  (2) No domain is empty.  (3) The bounds above.
// Returns one domain and no border when the graph cannot be cut within these bounds.
// REQUIRES: domains >= 1.
[[nodiscard]] Dissection dissection(const Nets& nets, int domains);

}  // namespace selvage::lp::elimination
