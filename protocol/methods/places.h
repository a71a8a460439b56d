// Places in parameters: [x, y] in the marker's unit, first read as decimals, then put onto the lattice of the marker.
#pragma once

#include "core/base/result.h"
#include "protocol/fields.h"
#include "protocol/formats/decimal_marker.h"

namespace selvage {

[[nodiscard]] Decimal read_place(Fields& fields, std::string_view key, Mistake& mistake);
// The nearest lattice point.  Errors: kOutOfRange when the lattice does not reach so far; `field` names the parameter.
[[nodiscard]] Result<Vec> place_on_lattice(const Decimal& place, Resolution resolution, std::string_view field);

}  // namespace selvage
