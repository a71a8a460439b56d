// Random settings of compaction and of other motions that move all pieces.
#pragma once

#include "core/motion/compaction/compact.h"
#include "tests/support/random.h"

namespace selvage::test {

[[nodiscard]] motion::compaction::CompactionSettings random_settings(Random& random);

}  // namespace selvage::test
