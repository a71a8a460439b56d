// Why a motion ended.
#pragma once

namespace selvage::scene {

enum class StopReason {
  kConverged,     // nothing more to gain, or the last round gained less than the least gain
  kWorkLimit,     // all allowed rounds were used
  kCancelled,     // cancelled; the answer is the best marker so far
  kSolverFailed,  // no solver could solve the program of a round; the answer is the best marker so far
  kLatticeEnd,    // the marker would have to become longer than the lattice reaches (core/geometry/lattice.h)
};

}  // namespace selvage::scene
