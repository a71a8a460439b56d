// Strong ids: the index into one table is a different type from the index into another.
#pragma once

#include <compare>
#include <cstdint>

namespace selvage {

template <class Tag>
struct Id {
  std::uint32_t value{};
  friend constexpr auto operator<=>(Id, Id) = default;
};

using ShapeId = Id<struct ShapeTag>;  // index into Marker::shapes
using PieceId = Id<struct PieceTag>;  // index into Marker::pieces

}  // namespace selvage
