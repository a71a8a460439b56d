#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tests/trials/latencies.h"
#include "tests/trials/live/caller.h"
#include "tests/trials/live/error_codes.h"
#include "tests/trials/live/live_daemon.h"
#include "tests/trials/trials.h"

namespace selvage::trials {
namespace {

using namespace std::chrono_literals;

constexpr double kDeadlineMs = 200;
constexpr std::size_t kWorkers = 2;

using Clock = std::chrono::steady_clock;

// A connection with its own marker and an unanswered call.
struct Asker {
  Caller caller;
  std::string marker_id;
  Clock::time_point sent;

  Asker(const LiveDaemon& daemon, const std::string& name) : caller{daemon, Endpoint::kTcp} {
    marker_id = caller.result("marker.open", {{"marker", Json::parse(garment(name))}})["markerId"];
  }
  void send(const std::string& method, const Json& params) {
    sent = Clock::now();
    (void)caller.send(method, params);
  }
};

using Askers = std::vector<std::unique_ptr<Asker>>;

Askers askers(std::size_t count, const LiveDaemon& daemon, const std::string& name) {
  Askers all;
  for (std::size_t k = 0; k < count; ++k) all.push_back(std::make_unique<Asker>(daemon, name));
  return all;
}

// Reads the answers and prints when they arrived.
void collect(const char* what, Askers& all, Faults& faults) {
  Latencies times;
  std::size_t results{};
  for (const auto& asker : all) {
    const int code = code_of(asker->caller.next_answer());
    times.add(std::chrono::duration<double, std::milli>{Clock::now() - asker->sent}.count());
    faults.expect(code == 0 || code == kBusy, std::string{what} + " answered " + std::to_string(code));
    if (code == 0) ++results;
  }
  std::printf("%s\n  %s; %zu results; the last %.1f ms after the deadline (goal: at most 50)\n", what,
              times.text().c_str(), results, times.part(1) - kDeadlineMs);
}

}  // namespace

void deadlines(std::size_t count, Faults& faults) {
  LiveDaemon daemon{{"--workers", std::to_string(kWorkers)}};
  Askers busy = askers(kWorkers, daemon, "jeans_22g");
  Askers compacting = askers(count, daemon, "jeans_02g");
  Askers bumping = askers(count, daemon, "jeans_02g");
  const Json piece =
      busy[0]->caller.result("marker.get", {{"markerId", busy[0]->marker_id}})["marker"]["pieces"][0]["id"];
  for (const auto& asker : busy) {
    asker->send("motion.compact", {{"markerId", asker->marker_id}, {"accuracy", "fine"}});
  }
  std::this_thread::sleep_for(50ms);  // every worker compacts now
  const auto ask_all = [&] {
    for (const auto& asker : compacting) {
      asker->send("motion.compact", {{"markerId", asker->marker_id}, {"deadlineMs", kDeadlineMs}});
    }
    for (const auto& asker : bumping) {
      asker->send(
          "motion.bump",
          {{"markerId", busy[0]->marker_id}, {"piece", piece}, {"direction", {-1, 0}}, {"deadlineMs", kDeadlineMs}});
    }
  };
  ask_all();
  collect("compactions while every worker compacts", compacting, faults);
  collect("bumps behind a compaction of their marker", bumping, faults);
  ask_all();
  collect("the same compactions again, which are refused at once", compacting, faults);
  collect("the same bumps again", bumping, faults);
  busy.clear();
  faults.expect(daemon.end() == 0, "selvaged did not end by itself");
}

}  // namespace selvage::trials
