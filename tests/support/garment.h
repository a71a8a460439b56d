// The garment markers of examples/, for tests below the protocol.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/marker/marker.h"

namespace selvage::test {

// By file name without its ending; a failure, and an empty marker, when it cannot be read.
[[nodiscard]] Marker garment(const std::string& name);

// All five of them, and a name for each test.
inline const auto kGarments = ::testing::Values("jeans_02g", "charlie_04g", "simon_06g", "jeans_06g", "jeans_22g");
inline std::string garment_name(const ::testing::TestParamInfo<const char*>& tested) {
  return tested.param;
}

}  // namespace selvage::test
