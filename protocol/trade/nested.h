// Closed outlines that lie in no other, and those that lie in them.
#pragma once

#include <vector>

#include "protocol/trade/loops.h"

namespace selvage::protocol::trade {

struct NestedLoop {
  Loop loop;
  std::vector<Loop> inner;   // all that lie in it, however deep
  document::Spot low, high;  // of the loop's box
};
// The largest first; loops without area are left out.
[[nodiscard]] std::vector<NestedLoop> nested(std::vector<Loop> loops);

// The first loop in which most of the points lie, and at least the first, the last or the middle one; null when there
// is none.
[[nodiscard]] NestedLoop* around_of(std::vector<NestedLoop>& outer, const std::vector<document::Spot>& points);

}  // namespace selvage::protocol::trade
