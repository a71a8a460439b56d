// The unit of a DXF file's coordinates.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "protocol/trade/options.h"
#include "protocol/trade/style.h"

namespace selvage::protocol::trade::dxf {

// In millimetres: the caller's unit, otherwise that of the text "Units:", otherwise $INSUNITS.  A note says which.
// Errors: kMissingField if none of them is given, or the text is not known and there is no other.
[[nodiscard]] Result<double> settle_unit(const std::map<std::string, std::string>& texts,
                                         std::optional<int> insert_units, std::optional<LengthUnit> asked,
                                         std::vector<Note>& notes);

// The unit of a text such as METRIC, mm, Inches; none if it is not known.
[[nodiscard]] std::optional<LengthUnit> unit_of_text(std::string_view text);

// The unit of a value of $INSUNITS; none for those that no pattern is drawn in.
[[nodiscard]] std::optional<LengthUnit> unit_of_insunits(int value);

}  // namespace selvage::protocol::trade::dxf
