// Packing as tests call it, with the checks that every answer must pass.
#pragma once

#include "core/packing/pack.h"

namespace selvage::test {

// The answer is valid, no shorter than its bound, and its length is that of its marker.
[[nodiscard]] packing::Packing packed(const Marker& marker, const packing::PackSettings& settings = {});

// The pieces' shortest length is `optimum`, and the search proves it: within the gap of a millionth of the width and
// the few units by which rounding lengthens a layout.
void expect_optimum(const Marker& marker, Coord optimum, const packing::PackSettings& settings = {});

}  // namespace selvage::test
