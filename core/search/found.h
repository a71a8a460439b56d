// What a search has found so far.
#pragma once

#include "core/marker/marker.h"

namespace selvage::search {

// A marker and its length in lattice units.
struct Found {
  Marker marker;
  Coord length{};
};

}  // namespace selvage::search
