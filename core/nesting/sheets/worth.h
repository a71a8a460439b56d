// What pieces are worth where sheets do not have room for all of them.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/marker/marker.h"

namespace selvage::nesting::sheets {

// By piece.
struct Worth {
  std::vector<double> area;   // square lattice units
  std::vector<double> value;  // the given one, else the area
  // What a piece counts for while a sheet is filled: the given value, else at most the area, and for large pieces a
  // larger part of it, because it is harder to find room for them.  Small ones, which fit into what is left of any
  // sheet, then make way for large ones.
  std::vector<double> weight;
};
// `given`: values by the id of a piece; pieces without one may be left out.
[[nodiscard]] Worth worth_of(const Marker& marker, std::span<const Piece> pieces,
                             const std::map<std::string, double, std::less<>>& given);

}  // namespace selvage::nesting::sheets
