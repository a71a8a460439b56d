#include "tests/soak/motion_sequence.h"

#include <algorithm>
#include <utility>

#include "core/marker/validity.h"
#include "core/motion/repair/repair.h"
#include "tests/judge/judge.h"
#include "tests/laws/random_marker.h"
#include "tests/motions/motion_cases.h"

namespace selvage::test {
namespace {

// Each of these edits leaves a marker well formed; edit() checks whether it is still valid.
void lock_some(Random& random, Marker& marker) {
  for (Piece& piece : marker.pieces) {
    if (random.chance(70)) continue;
    const bool x = random.chance(40);
    const bool y = random.chance(40);
    piece.locked = {x, y, random.chance(40)};
  }
}
void group_some(Random& random, Marker& marker) {
  for (Piece& piece : marker.pieces) {
    if (random.chance(30)) piece.group = random.chance(60) ? "" : random.chance(50) ? "a" : "b";
  }
}
void buffer_some(Random& random, Marker& marker) {
  for (Piece& piece : marker.pieces) {
    if (random.chance(30)) piece.buffer = random.chance(40) ? 0 : random.between(0, marker.strip.width / 60);
  }
}
void space(Random& random, Marker& marker) {
  marker.spacing = random.chance(50) ? 0 : random.between(0, marker.strip.width / 100);
}
void set_margin(Random& random, Marker& marker) {
  const Coord margin = random.chance(30) ? 0 : random.between(0, marker.strip.width / 40);
  const Coord wider = margin - marker.strip.margin;
  marker.strip.margin = margin;
  marker.strip.width += 2 * wider;
  if (marker.strip.longest) *marker.strip.longest += 2 * wider;
  for (Piece& piece : marker.pieces) piece.at = piece.at + Vec{wider, wider};
}
void end_cloth(Random& random, Marker& marker) {
  marker.strip.longest.reset();
  if (random.chance(60)) return;
  const Coord room = random.chance(30) ? 0 : random.between(0, marker.strip.width / 2);
  marker.strip.longest = length_of(marker) + marker.strip.margin + room;
}
void spread(Random& random, Marker& marker) {
  const auto stretch = static_cast<Coord>(random.between(1, 10));
  for (Piece& piece : marker.pieces) {
    if (!piece.locked.x && piece.group.empty()) piece.at.x += piece.at.x / 40 * stretch;
  }
}

using Edit = void (*)(Random&, Marker&);
constexpr Edit kEdits[] = {lock_some, group_some, buffer_some, space, set_margin, end_cloth, spread};

// Makes one of the edits, unless it would make the marker invalid.
void edit(Random& random, Marker& marker) {
  Marker edited = marker;
  kEdits[random.below(std::size(kEdits))](random, edited);
  if (make_marker(edited) && is_valid(edited)) marker = std::move(edited);
}

// Moves some pieces by amounts that rounding in other programs may cause, and that Selvage repairs.
Marker nudged(Random& random, Marker marker) {
  const auto most = static_cast<Coord>(0.4 * motion::repair::kRepairLimit * static_cast<double>(marker.strip.width));
  for (Piece& piece : marker.pieces) {
    if (random.chance(40)) piece.at = piece.at + random.point(-most, most);
  }
  return marker;
}

bool is_repair_error(ErrorCode code) {
  return code == ErrorCode::kMarkerOverlaps || code == ErrorCode::kOutsideStrip || code == ErrorCode::kRepairFailed ||
         code == ErrorCode::kStoppedEarly;
}

constexpr int kCancelledPercent = 15;  // percentage of the motions that are cancelled

// Requests a stop after a given number of stages, programs and rounds, and counts what the motion begins afterwards.
class StopAfter {
 public:
  StopAfter(std::size_t count, SumCache& sums) : left_{count}, sums_{sums} {
    observer_.on_stage = [this](scene::Stage) { wait(); };
    observer_.on_program = [this](const lp::LinearProgram&) { programs_ += stopped() ? 1 : 0, wait(); };
    observer_.on_round = [this](const scene::Round&) { wait(); };
  }
  StopAfter(const StopAfter&) = delete;
  StopAfter& operator=(const StopAfter&) = delete;
  [[nodiscard]] scene::Run run() const { return {sums_, source_.get_token(), observer_}; }
  // The programs and the Minkowski sums that were begun after the stop.
  [[nodiscard]] WorkAfterStop afterwards() const {
    return stopped() ? WorkAfterStop{programs_, sums_.counts().entries - known_} : WorkAfterStop{};
  }

 private:
  [[nodiscard]] bool stopped() const { return source_.stop_requested(); }
  void wait() {
    if (left_ == 0 || --left_ > 0) return;
    known_ = sums_.counts().entries;
    source_.request_stop();
  }
  std::size_t left_;  // 0: never
  SumCache& sums_;
  std::stop_source source_;
  std::uint64_t programs_{};
  std::size_t known_{};  // sums in the cache at the stop; none is evicted
  scene::Observer observer_;
};

class SequenceRunner {
 public:
  SequenceRunner(Marker start, Random& random, SumCache& sums)
      : marker_{std::move(start)}, random_{random}, sums_{sums} {}

  SequenceResult run(int motions) && {
    for (int step = 1; step <= motions && !result_.fault; ++step) {
      if (random_.chance(25)) edit(random_, marker_);
      const MotionCase& motion = drawn_motion(random_);
      ++result_.motions;
      ++result_.of_each[motion.name];
      Marker given = motion.repairs && random_.chance(15) ? nudged(random_, marker_) : marker_;
      const std::string what = fault_of(motion, given);
      if (!what.empty()) result_.fault = Fault{step, std::string{motion.name}, what, std::move(given)};
    }
    return std::move(result_);
  }

 private:
  // Runs one motion and returns its fault, or an empty string; marker_ then becomes the result.
  std::string fault_of(const MotionCase& motion, const Marker& given) {
    const bool valid = judge_.fault_of(given).empty();
    if (valid != is_valid(given)) return "is_valid is wrong about the marker it was given";
    if (judge_.length_of(given) != length_of(given)) return "length_of is wrong about the marker it was given";
    const Marker kept = given;
    const Random same_random = random_;
    const std::size_t events = random_.chance(kCancelledPercent) ? random_.below(30) + 1 : 0;
    SumCache own;  // other threads share sums_, and their sums would be counted
    StopAfter stop_after{events, events > 0 ? own : sums_};
    auto answer = motion.run(given, {random_, stop_after.run()});
    if (auto fault = fault_of(stop_after.afterwards(), given); !fault.empty()) return fault;
    if (given != kept) return "changed the marker it was given";
    if (!answer) {
      ++result_.refused;
      if (!valid && is_repair_error(answer.error().code)) return "";
      return "failed: " + answer.error().message;
    }
    if (auto fault = fault_of(*answer, given); !fault.empty()) return fault;
    if (random_.chance(4) && !repeats(motion, given, same_random, answer->marker)) return "depends on the cache";
    if (answer->apart && random_.chance(90)) marker_ = std::move(answer->marker);
    return "";
  }

  std::string fault_of(const WorkAfterStop& work, const Marker& given) {
    result_.after_stop.programs = std::max(result_.after_stop.programs, work.programs);
    result_.after_stop.sums = std::max(result_.after_stop.sums, work.sums);
    if (work.programs > kMostProgramsAfterStop)
      return "begins " + std::to_string(work.programs) + " programs after a stop";
    if (work.sums > given.pieces.size() * given.pieces.size())
      return "begins " + std::to_string(work.sums) + " sums after a stop";
    return "";
  }

  std::string fault_of(const Answer& answer, const Marker& given) {
    if (!answer.contradiction.empty()) return answer.contradiction;
    const Marker& before = answer.started ? *answer.started : given;
    if (auto fault = judge_.broken_promise(before, answer.marker, answer.leave); !fault.empty()) return fault;
    const std::string fault = judge_.fault_of(answer.marker);
    if (answer.apart && !fault.empty()) return fault;
    return !answer.apart && fault.empty() ? "reports overlaps in a valid marker" : "";
  }

  static bool repeats(const MotionCase& motion, const Marker& given, Random chance, const Marker& expected) {
    SumCache fresh{1};
    StopAfter stop_after{chance.chance(kCancelledPercent) ? chance.below(30) + 1 : 0, fresh};
    const auto again = motion.run(given, {chance, stop_after.run()});
    return again && again->marker == expected;
  }

  Marker marker_;
  Random& random_;
  SumCache& sums_;
  Judge judge_;
  SequenceResult result_;
};

}  // namespace

Marker constrained_marker(Random& random) {
  Marker marker = random_marker(random);
  for (Shape& shape : marker.shapes) {
    if (random.chance(60))
      shape.tilt_limit = Angle::of_degrees(random.chance(10) ? 45 * random.part() : 4 * random.part());
  }
  const auto edits = random.below(6);
  for (std::size_t k = 0; k < edits; ++k) edit(random, marker);
  return marker;
}

SequenceResult run_sequence(Marker start, int motions, Random& random, SumCache& sums) {
  return SequenceRunner{std::move(start), random, sums}.run(motions);
}

}  // namespace selvage::test
