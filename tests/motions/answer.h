// How the result of a motion becomes an answer that the judge can check.
#pragma once

#include <limits>
#include <stdexcept>
#include <utility>

#include "core/marker/validity.h"
#include "tests/motions/motion_cases.h"

namespace selvage::test {

inline constexpr Coord kAnyLength = std::numeric_limits<Coord>::max();

// The answer of a motion whose result derives from MotionResult.
template <class Done>
Result<Answer> answer(Result<Done> done, Leave leave = {}) {
  if (!done) return done.error();
  leave.longest = done->length_before + done->repair.lengthened;
  Answer answer{.marker = std::move(done->marker), .leave = leave};
  if (done->length_after != length_of(answer.marker)) answer.contradiction = "reports a wrong length";
  const motion::repair::Repair& repair = done->repair;
  if (repair.pairs + repair.protruding == 0 && (repair.lengthened > 0 || repair.farthest_move > 0)) {
    answer.contradiction = "repairs a valid marker";
  }
  return answer;
}

// The result of a motion that had nothing to do.
inline Answer unmoved(const Marker& start) {
  return {.marker = start, .leave = {.longest = kAnyLength}, .apart = is_valid(start)};
}

// Throws when the motion failed; otherwise a failed motion would be recorded as one that needs nothing.
template <class Done>
void require(const Result<Done>& done) {
  if (!done) throw std::runtime_error{done.error().message};
}

}  // namespace selvage::test
