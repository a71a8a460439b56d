// The name and the size of a piece, as the attributes "name" and "size" of the piece itself state them or, where it has
// none, those of its shape.  A size may be a whole number, which is read as its digits; anything else that is not a
// text is ignored.
//
// `position` counts the placed pieces first, then the unplaced ones.
#pragma once

#include <string>

#include "protocol/document/marker_file.h"

namespace selvage::protocol::document {

// Empty if neither the piece nor its shape has one.
[[nodiscard]] std::string name_of_piece(const MarkerFile& file, std::size_t position);
[[nodiscard]] std::string size_of_piece(const MarkerFile& file, std::size_t position);

}  // namespace selvage::protocol::document
