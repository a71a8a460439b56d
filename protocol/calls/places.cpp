#include "protocol/calls/places.h"

#include <cmath>

namespace selvage::protocol::calls {

formats::Decimal read_place(json::Fields& fields, std::string_view key, json::Mistake& mistake) {
  const std::string at = fields.pointer(key);
  const Json& value = fields.array(key);
  if (mistake) return {};
  return formats::read_point(value, at, mistake);
}

Result<Vec> place_on_lattice(const formats::Decimal& place, Resolution resolution, std::string_view field) {
  for (const double coordinate : {place.x, place.y}) {
    if (fits_lattice(coordinate, resolution)) continue;
    return Error{ErrorCode::kOutOfRange,
                 json::number_text(coordinate) + " is too far out; up to " +
                     json::number_text(to_decimal(kLatticeLimit - 1, resolution)) + " either way is allowed",
                 std::string{field}};
  }
  return Vec{to_lattice(place.x, resolution), to_lattice(place.y, resolution)};
}

}  // namespace selvage::protocol::calls
