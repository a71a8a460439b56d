// An engine whose motions are a single step that tests can hold, break and count; and a marker for it.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <string>

#include "protocol/calls/engine.h"
#include "tests/server/wire/wire.h"

namespace selvage::test {

// Two squares of 2 mm, one above the other, 3 mm from the strip's start: 5 mm long, valid.
inline const std::string kSmallMarker =
    R"({"format":"selvage-marker","version":1,"name":"small","strip":{"width":10},)"
    R"("shapes":[{"id":"square","outline":[[0,0],[2,0],[2,2],[0,2]]}],)"
    R"("pieces":[{"id":"low","shape":"square","at":[3,0]},{"id":"high","shape":"square","at":[3,4]}]})";

// Moves every piece 1 mm to the left, if there is room.
inline motion::compaction::Compaction push_left(const Marker& start) {
  motion::compaction::Compaction done;
  done.marker = start;
  done.length_before = length_of(start);
  Coord step = to_lattice(1, start.resolution);
  for (const Piece& piece : start.pieces) step = std::min(step, piece.at.x);
  for (Piece& piece : done.marker.pieces) piece.at.x -= step;
  done.length_after = length_of(done.marker);
  done.rounds = 1;
  return done;
}

// A gate that motions wait at until the test opens it or their token stops.
class Gate {
 public:
  // An engine whose compactions and pushes wait here; cancelled ones say so and have still moved.
  [[nodiscard]] protocol::calls::Engine engine() {
    protocol::calls::Engine engine;
    engine.compact = [this](const Marker& start, const motion::compaction::CompactionSettings&,
                            const scene::Run& run) -> Result<motion::compaction::Compaction> {
      motion::compaction::Compaction done = push_left(start);
      if (!pass(run.stop)) done.reason = scene::StopReason::kCancelled;
      return done;
    };
    engine.push = [this](const Marker& start, std::span<const motion::compaction::Force>,
                         const motion::compaction::CompactionSettings&,
                         const scene::Run& run) -> Result<motion::compaction::Push> {
      motion::compaction::Push done;
      done.marker = push_left(start).marker;
      if (!pass(run.stop)) done.reason = scene::StopReason::kCancelled;
      return done;
    };
    return engine;
  }

  // Blocks until `count` compactions have come to the gate, ever.
  void await_arrivals(int count) {
    std::unique_lock lock{mutex_};
    if (!changed_.wait_for(lock, kPatience, [&] { return arrived_ >= count; })) {
      throw std::runtime_error{"no compaction in time"};
    }
  }
  void open() {
    const std::lock_guard lock{mutex_};
    open_ = true;
    changed_.notify_all();
  }
  [[nodiscard]] int arrived() {
    const std::lock_guard lock{mutex_};
    return arrived_;
  }
  // Those that are in the compaction now, and the most that ever were.
  [[nodiscard]] int most_at_once() {
    const std::lock_guard lock{mutex_};
    return most_inside_;
  }
  // Blocks until `count` compactions have left because they were stopped.
  void await_stopped(int count) {
    std::unique_lock lock{mutex_};
    if (!changed_.wait_for(lock, kPatience, [&] { return stopped_ >= count; })) {
      throw std::runtime_error{"nothing was stopped in time"};
    }
  }

 private:
  bool pass(const std::stop_token& stop) {
    std::unique_lock lock{mutex_};
    ++arrived_;
    most_inside_ = std::max(most_inside_, ++inside_);
    changed_.notify_all();
    const bool passed = changed_.wait(lock, stop, [this] { return open_; });
    --inside_;
    if (!passed) ++stopped_;
    changed_.notify_all();
    return passed;
  }

  std::mutex mutex_;
  std::condition_variable_any changed_;
  bool open_{};
  int arrived_{}, inside_{}, most_inside_{}, stopped_{};
};

// A JSON-RPC call.
inline std::string call(int id, const std::string& method, const std::string& params = "{}") {
  return R"({"jsonrpc":"2.0","id":)" + std::to_string(id) + R"(,"method":")" + method + R"(","params":)" + params + "}";
}

}  // namespace selvage::test
