// Motions with a single step, which tests can block, break and count, and a small marker for them.  They replace rows
// of the method table.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <functional>
#include <initializer_list>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "protocol/calls/motion.h"
#include "protocol/methods/method_table.h"
#include "tests/server/wire/wire.h"

namespace selvage::test {

// Two squares of 2 mm, one above the other, 3 mm from the strip's start: 5 mm long, valid.
inline const std::string kSmallMarker =
    R"({"format":"selvage-marker","version":1,"name":"small","strip":{"width":10},)"
    R"("shapes":[{"id":"square","outline":[[0,0],[2,0],[2,2],[0,2]]}],)"
    R"("pieces":[{"id":"low","shape":"square","at":[3,0]},{"id":"high","shape":"square","at":[3,4]}]})";

using protocol::calls::CommonParams;
using protocol::calls::MethodAnswer;
using protocol::calls::MethodContext;
using protocol::methods::MethodTable;

// What a method does with a marker after its parameters have been decoded.
using StubRun =
    std::function<Result<MethodAnswer>(const CommonParams&, const MarkerFile& file, const MethodContext& context)>;

// The table of all methods, in which the methods with these names run the stub instead.
inline MethodTable methods_with(std::initializer_list<const char*> names, const StubRun& stub) {
  MethodTable table = protocol::methods::method_table();
  for (const char* name : names) {
    protocol::calls::Method method = *table.find(name);
    method.read = [read = method.read, stub](const Json& params) {
      auto call = read(params);
      if (call) {
        call->run = [stub, about = call->about](const MarkerFile& file, const MethodContext& context) {
          return stub(about, file, context);
        };
      }
      return call;
    };
    table.replace(std::move(method));
  }
  return table;
}

// Moves every piece 1 mm to the left if there is room.
inline Marker push_left(const Marker& start) {
  Marker marker = start;
  Coord step = to_lattice(1, start.resolution);
  for (const Piece& piece : start.pieces) step = std::min(step, piece.at.x);
  for (Piece& piece : marker.pieces) piece.at.x -= step;
  return marker;
}

// The answer of a motion that ended with this marker after one round.
inline MethodAnswer motion_answer(const CommonParams& about, const Marker& start, Marker end,
                                  const MethodContext& context,
                                  scene::StopReason reason = scene::StopReason::kConverged) {
  const protocol::calls::RoundsResult own{1, stop_cause(reason, context)};
  return answer_of(start, {.marker = std::move(end)}, protocol::schema::encode(own), about.commit, context);
}

// All methods of the server, with compactions that push every piece 1 mm to the left.
inline MethodTable pushing_methods() {
  return methods_with(
      {"motion.compact"},
      [](const CommonParams& about, const MarkerFile& file, const MethodContext& context) -> Result<MethodAnswer> {
        context.run.observer.on_stage(scene::Stage::kSolve);
        return motion_answer(about, file.marker, push_left(file.marker), context);
      });
}

// A gate at which motions wait until the test opens it or their token stops.
class Gate {
 public:
  // All methods of the server, of which compaction and gravity wait here.  One that is stopped reports that, and has
  // moved the pieces nevertheless.
  [[nodiscard]] MethodTable methods() {
    return methods_with({"motion.compact", "motion.gravity"},
                        [this](const CommonParams& about, const MarkerFile& file, const MethodContext& context) {
                          return run(about, file, context);
                        });
  }
  [[nodiscard]] Result<MethodAnswer> run(const CommonParams& about, const MarkerFile& file,
                                         const MethodContext& context) {
    const auto reason = pass(context.run.stop) ? scene::StopReason::kConverged : scene::StopReason::kCancelled;
    return motion_answer(about, file.marker, push_left(file.marker), context, reason);
  }

  // Blocks until `count` motions in total have arrived at the gate.
  void await_arrivals(int count) {
    std::unique_lock lock{mutex_};
    if (!changed_.wait_for(lock, kPatience, [&] { return arrived_ >= count; })) {
      throw std::runtime_error{"no motion arrived in time"};
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
  // The largest number of motions that waited at the same time.
  [[nodiscard]] int most_at_once() {
    const std::lock_guard lock{mutex_};
    return most_inside_;
  }
  // Blocks until `count` motions in total have left because they were stopped.
  void await_stopped(int count) {
    std::unique_lock lock{mutex_};
    if (!changed_.wait_for(lock, kPatience, [&] { return stopped_ >= count; })) {
      throw std::runtime_error{"no motion was stopped in time"};
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
