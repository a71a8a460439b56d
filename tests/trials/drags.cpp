#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/random.h"
#include "tests/trials/latencies.h"
#include "tests/trials/live/caller.h"
#include "tests/trials/live/error_codes.h"
#include "tests/trials/live/live_daemon.h"
#include "tests/trials/trials.h"

namespace selvage::trials {
namespace {

using test::Random;

constexpr std::size_t kDraggers = 32;
constexpr std::size_t kDraggedMarkers = 24;  // some are used by two clients, one of which ends its drag too late
constexpr std::size_t kReaders = 2;
constexpr double kReadGoalMs = 20;

struct OpenedMarker {
  std::string id;
  Json pieces;
  double length{}, width{};
};

OpenedMarker open(Caller& caller, const std::string& document) {
  const Json marker = Json::parse(document);
  const Json opened = caller.result("marker.open", {{"marker", marker}});
  const std::string id = opened["markerId"];
  const Json shown = caller.result("marker.get", {{"markerId", id}})["marker"];
  return {id, shown["pieces"], opened["length"], shown["strip"]["width"]};
}

struct DragTally {
  std::atomic<std::size_t> begun{}, requests{}, moved{}, superseded{}, cancelled{}, late{}, committed{}, checked{};
};

// One client that makes drag sessions on one marker, one after another.
class DragClient {
 public:
  DragClient(const LiveDaemon& daemon, Endpoint endpoint, const OpenedMarker& marker, std::uint64_t seed,
             DragTally& tally, Faults& faults)
      : caller_{daemon, endpoint}, marker_{marker}, random_{seed}, tally_{tally}, faults_{faults} {}

  void drag() {
    const Json& piece = marker_.pieces[random_.below(marker_.pieces.size())];
    const char* mode = random_.chance(50) ? "place" : "push";
    const std::string id =
        caller_.result("drag.begin", {{"markerId", marker_.id}, {"piece", piece["id"]}, {"mode", mode}})["dragId"];
    ++tally_.begun;
    ++tally_.requests;
    for (auto moves = random_.between(1, 6); moves > 0; --moves) {
      const Json to{random_.part() * marker_.length * 1.05, random_.part() * marker_.width};
      ask("drag.move", {{"dragId", id}, {"to", to}}, 15);
      if (random_.chance(30)) take_all();  // waits for the answers; otherwise moves supersede each other
    }
    if (random_.chance(50)) take_all();  // otherwise the drag ends while moves are in progress
    ask("drag.end", {{"dragId", id}, {"markerId", marker_.id}, {"commit", random_.chance(85)}}, 5);
    take_all();
  }

  // An unexpected message would arrive before this answer.
  void finish() { (void)caller_.result("engine.info"); }

 private:
  void ask(const std::string& method, const Json& params, int cancelled_percent) {
    const int call = caller_.send(method, params);
    awaited_.emplace(call, method);
    ++tally_.requests;
    if (random_.chance(cancelled_percent)) caller_.notify("$/cancelRequest", {{"id", call}});
  }

  void take_all() {
    bool ended{};
    while (!awaited_.empty()) {
      const Json answer = caller_.next_answer();
      const auto call = awaited_.find(answer["id"].get<int>());
      if (call == awaited_.end()) {
        faults_.add("an unexpected answer: " + answer.dump());
        continue;
      }
      const std::string method = call->second;
      awaited_.erase(call);
      if (method == "drag.move") {
        judge_move(answer);
      } else {
        ended = judge_end(answer);
      }
    }
    if (ended) check();
  }

  void judge_move(const Json& answer) {
    const int code = code_of(answer);
    if (code == 0) {
      ++tally_.moved;
      faults_.expect(answer["result"]["valid"] == true, "a move is not valid: " + answer.dump());
    } else if (code == kSuperseded) {
      ++tally_.superseded;
    } else if (code == kCancelled) {
      ++tally_.cancelled;
    } else {
      faults_.add("drag.move: " + answer.dump());
    }
  }

  // Returns true if the drag ended as requested.
  bool judge_end(const Json& answer) {
    const int code = code_of(answer);
    if (code == 0) {
      ++tally_.committed;
      faults_.expect(answer["result"]["valid"] == true, "a drag's end is not valid: " + answer.dump());
      return true;
    }
    if (code == kMoved) {
      ++tally_.late;
    } else if (code == kCancelled) {
      ++tally_.cancelled;
    } else {
      faults_.add("drag.end: " + answer.dump());
    }
    return false;
  }

  void check() {
    const Json checked = caller_.result("marker.check", {{"markerId", marker_.id}});
    ++tally_.checked;
    faults_.expect(checked["valid"] == true && checked["overlaps"].empty() && checked["protrusions"].empty(),
                   "invalid after a drag: " + checked.dump());
  }

  Caller caller_;
  const OpenedMarker& marker_;
  Random random_;
  DragTally& tally_;
  Faults& faults_;
  std::map<int, std::string> awaited_;  // calls in progress, by id
};

// Reads one marker after the other until it is stopped.
Latencies read_on(const std::stop_token& stop, const LiveDaemon& daemon, const std::vector<OpenedMarker>& markers,
                  Faults& faults) {
  Latencies latencies;
  test::Wire wire{daemon.port()};
  for (std::size_t k = 0; !stop.stop_requested(); ++k) {
    const std::string asked = call_text(k, "marker.get", {{"markerId", markers[k % markers.size()].id}});
    const auto answer = latencies.time([&] { return wire.post(asked); });
    faults.expect(answer && answer->body.find("\"result\"") != std::string::npos, "marker.get was not answered");
    std::this_thread::sleep_for(std::chrono::milliseconds{2});
  }
  return latencies;
}

std::size_t compact_on(const std::stop_token& stop, const LiveDaemon& daemon, const std::string& marker_id) {
  Caller caller{daemon, Endpoint::kTcp};
  std::size_t solves{};
  for (; !stop.stop_requested(); ++solves) {
    (void)caller.result("motion.compact", {{"markerId", marker_id}, {"commit", false}});
  }
  return solves;
}

}  // namespace

void drags(std::size_t count, Faults& faults) {
  LiveDaemon daemon;
  Caller caller{daemon, Endpoint::kTcp};
  std::vector<OpenedMarker> markers;
  for (std::size_t k = 0; k < kDraggedMarkers; ++k) {
    markers.push_back(open(caller, garment(k % 2 == 0 ? "jeans_02g" : "jeans_06g")));
  }
  const OpenedMarker solved = open(caller, garment("jeans_22g"));

  DragTally tally;
  std::array<Latencies, kReaders> reads;
  std::size_t solves{};
  const auto began = std::chrono::steady_clock::now();
  {
    std::vector<std::jthread> others;
    for (Latencies& latencies : reads) {
      others.emplace_back([&](const std::stop_token& stop) {
        faults.guard("a reader", [&] { latencies = read_on(stop, daemon, markers, faults); });
      });
    }
    others.emplace_back([&](const std::stop_token& stop) {
      faults.guard("the compacting client", [&] { solves = compact_on(stop, daemon, solved.id); });
    });
    std::vector<std::jthread> dragging;
    for (std::size_t k = 0; k < kDraggers; ++k) {
      dragging.emplace_back([&, k] {
        faults.guard("a dragging client", [&] {
          DragClient client{daemon, static_cast<Endpoint>(k % kEndpoints), markers[k % kDraggedMarkers], k, tally,
                            faults};
          for (std::size_t drag = k; drag < count; drag += kDraggers) client.drag();
          client.finish();
        });
      });
    }
  }
  const double seconds = std::chrono::duration<double>{std::chrono::steady_clock::now() - began}.count();
  for (std::size_t k = 1; k < kReaders; ++k) reads[0].join(reads[k]);
  faults.expect(tally.begun == count, "not every drag session was executed");
  faults.expect(tally.superseded > 0 && tally.cancelled > 0 && tally.moved > 0,
                "the trial did not exercise everything");
  std::printf("%zu drags from %zu connections in %.1f s: %zu requests, each answered once\n", count, kDraggers, seconds,
              tally.requests.load());
  std::printf("moves executed %zu, superseded %zu; calls cancelled %zu; ends executed %zu, too late %zu\n",
              tally.moved.load(), tally.superseded.load(), tally.cancelled.load(), tally.committed.load(),
              tally.late.load());
  std::printf("markers checked %zu times; %zu compactions of jeans_22g meanwhile\n", tally.checked.load(), solves);
  std::printf("marker.get by %zu other clients: %s (goal: p99 below %.0f)\n", kReaders, reads[0].text().c_str(),
              kReadGoalMs);
  faults.expect(daemon.end() == 0, "selvaged did not exit with code 0");
}

}  // namespace selvage::trials
