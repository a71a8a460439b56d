// Sheets take only pieces that may go to any place of any sheet.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/marker/marker.h"

namespace selvage::nesting::sheets {

// What is wrong with the first piece that is locked in place, belongs to a group or is a zone; its `field` begins with
// `list`, a JSON pointer to the pieces that ends with a slash.
[[nodiscard]] std::optional<Error> unmovable(const std::vector<Piece>& pieces, const std::string& list);

}  // namespace selvage::nesting::sheets
