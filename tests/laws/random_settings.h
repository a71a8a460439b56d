// How a compaction, or any other motion of all pieces, is to go about it: at random.
#pragma once

#include "core/motion/compaction/compact.h"
#include "tests/support/random.h"

namespace selvage::test {

[[nodiscard]] motion::compaction::CompactionSettings random_settings(Random& random);

}  // namespace selvage::test
