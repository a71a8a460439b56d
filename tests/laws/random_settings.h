// How a compaction, or any other motion of all pieces, is to go about it: at random.
#pragma once

#include "core/motion/compact.h"
#include "tests/support/random.h"

namespace selvage::test {

[[nodiscard]] CompactionSettings random_settings(Random& random);

}  // namespace selvage::test
