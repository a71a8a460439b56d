// The labels by which the pieces of an order and of a stored marker are compared: their names and sizes, as their file
// states them (protocol/document/piece_label.h).
//
// Names often contain the size: "back_36_L" is the piece "back_L" of size 36.  So that pieces of different sizes have
// the same name, the size is taken out of it: if the piece has a size, and exactly one word of its name, a run of
// letters and digits, is that size.  A number in the name of a piece without a size is not taken for one: it may be
// anything, as in "pocket 2".
#pragma once

#include <string>
#include <string_view>

#include "core/matching/label.h"
#include "protocol/document/marker_file.h"

namespace selvage::protocol::library {

// `size` may be empty.
[[nodiscard]] matching::Label label_from(std::string_view name, std::string_view size);

[[nodiscard]] matching::LabelledMarker labelled(const MarkerFile& file);

}  // namespace selvage::protocol::library
