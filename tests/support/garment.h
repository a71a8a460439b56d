// The garment markers of examples/, for tests of layers below the protocol.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/marker/marker.h"

namespace selvage::test {

// Reads the marker with this file name (without extension).  When it cannot be read, the test fails and the marker is
// empty.
[[nodiscard]] Marker garment(const std::string& name);

// The names of all five markers, and the name of the test for each.
inline const auto kGarments = ::testing::Values("jeans_02g", "charlie_04g", "simon_06g", "jeans_06g", "jeans_22g");
inline std::string garment_name(const ::testing::TestParamInfo<const char*>& tested) {
  return tested.param;
}

}  // namespace selvage::test
