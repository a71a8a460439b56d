// Places in parameters: [x, y] in the marker's unit, first read as decimals, then put onto the lattice of the marker.
#pragma once

#include "core/base/result.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/json/fields.h"

namespace selvage::protocol::calls {

[[nodiscard]] formats::Decimal read_place(json::Fields& fields, std::string_view key, json::Mistake& mistake);
// The nearest lattice point.  Errors: kOutOfRange when the lattice does not reach so far; `field` names the parameter.
[[nodiscard]] Result<Vec> place_on_lattice(const formats::Decimal& place, Resolution resolution,
                                           std::string_view field);

}  // namespace selvage::protocol::calls
