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
#include "tests/trials/caller.h"
#include "tests/trials/latencies.h"
#include "tests/trials/live_daemon.h"
#include "tests/trials/trials.h"

namespace selvage::trials {
namespace {

using test::Random;

constexpr std::size_t kHands = 32;
constexpr std::size_t kMarkers = 24;  // some have two hands on them, and one of two that end is too late
constexpr std::size_t kReaders = 2;
constexpr double kReadGoalMs = 20;
constexpr int kCancelled = -32800, kMoved = -32801, kSuperseded = -32802;

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

struct Tally {
  std::atomic<std::size_t> begun{}, requests{}, moved{}, superseded{}, cancelled{}, late{}, committed{}, checked{};
};

// One hand: drags of one marker, one after another.
class Hand {
 public:
  Hand(const LiveDaemon& daemon, Door door, const OpenedMarker& marker, std::uint64_t seed, Tally& tally,
       Faults& faults)
      : caller_{daemon, door}, marker_{marker}, random_{seed}, tally_{tally}, faults_{faults} {}

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
      if (random_.chance(30)) take_all();  // a hand that waits; otherwise moves overtake each other
    }
    if (random_.chance(50)) take_all();  // or ends with moves still on their way
    ask("drag.end", {{"dragId", id}, {"markerId", marker_.id}, {"commit", random_.chance(85)}}, 5);
    take_all();
  }

  // Whatever came without being asked for would come before this answer.
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
        faults_.add("a second answer, or one to nothing: " + answer.dump());
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

  // Did it end as asked?
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
  Tally& tally_;
  Faults& faults_;
  std::map<int, std::string> awaited_;  // calls under way, by id
};

// Reads one marker after the other until it is told to stop.
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
  Caller caller{daemon, Door::kTcp};
  std::size_t solves{};
  for (; !stop.stop_requested(); ++solves) {
    (void)caller.result("motion.compact", {{"markerId", marker_id}, {"commit", false}});
  }
  return solves;
}

}  // namespace

void drags(std::size_t count, Faults& faults) {
  LiveDaemon daemon;
  Caller caller{daemon, Door::kTcp};
  std::vector<OpenedMarker> markers;
  for (std::size_t k = 0; k < kMarkers; ++k) {
    markers.push_back(open(caller, garment(k % 2 == 0 ? "jeans_02g" : "jeans_06g")));
  }
  const OpenedMarker solved = open(caller, garment("jeans_22g"));

  Tally tally;
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
      faults.guard("who compacts", [&] { solves = compact_on(stop, daemon, solved.id); });
    });
    std::vector<std::jthread> parallelism;
    for (std::size_t k = 0; k < kHands; ++k) {
      parallelism.emplace_back([&, k] {
        faults.guard("a hand", [&] {
          Hand hand{daemon, static_cast<Door>(k % kDoors), markers[k % kMarkers], k, tally, faults};
          for (std::size_t drag = k; drag < count; drag += kHands) hand.drag();
          hand.finish();
        });
      });
    }
  }
  const double seconds = std::chrono::duration<double>{std::chrono::steady_clock::now() - began}.count();
  for (std::size_t k = 1; k < kReaders; ++k) reads[0].join(reads[k]);
  faults.expect(tally.begun == count, "not every drag was made");
  faults.expect(tally.superseded > 0 && tally.cancelled > 0 && tally.moved > 0, "the trial did not try everything");
  std::printf("%zu drags from %zu connections in %.1f s: %zu requests, each answered once\n", count, kHands, seconds,
              tally.requests.load());
  std::printf("moves carried out %zu, superseded %zu; calls cancelled %zu; ends carried out %zu, too late %zu\n",
              tally.moved.load(), tally.superseded.load(), tally.cancelled.load(), tally.committed.load(),
              tally.late.load());
  std::printf("markers checked %zu times; %zu compactions of jeans_22g beside them\n", tally.checked.load(), solves);
  std::printf("marker.get by %zu others: %s (goal: p99 below %.0f)\n", kReaders, reads[0].text().c_str(), kReadGoalMs);
  faults.expect(daemon.end() == 0, "selvaged did not end well");
}

}  // namespace selvage::trials
