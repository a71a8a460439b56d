// Why a motion ended where it did.
#pragma once

namespace selvage::scene {

enum class StopReason {
  kConverged,     // nothing was left to gain, or the last round gained less than the least gain
  kWorkLimit,     // the rounds are used up
  kCancelled,     // asked to stop
  kSolverFailed,  // no solver could solve a round's program; the best marker so far
};

}  // namespace selvage::scene
