// The memory of a daemon that greedy clients try to make grow, and what another client notices of them.
#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "server/jobs/prompt_thread.h"
#include "tests/trials/latencies.h"
#include "tests/trials/live/caller.h"
#include "tests/trials/live/live_daemon.h"
#include "tests/trials/memory/greedy_clients.h"
#include "tests/trials/trials.h"

namespace selvage::trials {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kBudgetMb = 512;
constexpr std::size_t kAddressSpaceMb = kBudgetMb * 6 / 5 + 256;  // with what the threads reserve and never touch
constexpr double kMostResident = 1.2;                             // times the budget
// The other client makes at least this many calls in each half of a round: in three rounds a thousand.  The p99 of a
// single round would depend on four calls.
constexpr std::size_t kCallsOfARound = 350;
constexpr auto kRest = 200ms;  // before each round, for what the daemon still does for clients that have left

// A client that is not greedy.
class Other {
 public:
  explicit Other(const LiveDaemon& daemon) : caller_{daemon, Endpoint::kTcp} {
    marker_id_ = caller_.result("marker.open", {{"marker", Json::parse(garment("jeans_02g"))}})["markerId"];
  }
  // Makes the calls of a round, and more until `meanwhile` has returned, which is told whether those calls have been
  // answered.  Every call must be answered with a result.
  template <class Work>
  Latencies measure(const Work& meanwhile, Faults& faults) {
    Latencies times;
    std::atomic<std::size_t> calls{};
    const auto call = [&](const std::stop_token& stop) {
      server::jobs::run_promptly(server::jobs::Promptness::kFirst);  // it would be on a machine of its own
      while (!stop.stop_requested()) {
        const Json answer = times.time([&] { return caller_.ask("marker.get", {{"markerId", marker_id_}}); });
        faults.expect(code_of(answer) == 0, "another client's marker.get: " + answer.dump().substr(0, 200));
        ++calls;
        std::this_thread::sleep_for(2ms);
      }
    };
    std::jthread thread{[&](const std::stop_token& stop) {
      faults.guard("the other client", [&] { call(stop); });
      calls = kCallsOfARound;  // also if it has failed
    }};
    meanwhile([&] { return calls >= kCallsOfARound; });
    thread.request_stop();
    thread.join();
    return times;
  }

 private:
  Caller caller_;
  std::string marker_id_;
};

// Greedy clients would be on machines of their own: here they take no time from the daemon and from the other client.
// Threads that this one starts have the same priority.
void yield_to_others() {
  constexpr int kLowest = 19;
  (void)::setpriority(PRIO_PROCESS, 0, kLowest);
}

// Each of the clients works once, at the same time.
void be_greedy(const std::vector<GreedyClient>& clients, const LiveDaemon& daemon, Greed& greed, Faults& faults) {
  std::vector<std::jthread> threads;
  for (const GreedyClient& client : clients) {
    threads.emplace_back([&] {
      yield_to_others();
      faults.guard(client.name, [&] { client.work(daemon, greed, faults); });
    });
  }
}

// On a daemon of their own.  Each round measures the other client alone and then beside the greedy ones, so that a
// machine whose speed changes meanwhile does so for both.
void run_case(std::string_view name, const std::vector<GreedyClient>& clients, std::size_t rounds, Faults& faults) {
  LiveDaemon daemon{{"--workers", "2", "--memory", std::to_string(kBudgetMb)}};
  daemon.limit_address_space(kAddressSpaceMb << 20);
  Other other{daemon};
  Greed greed;
  const auto wait = [](const auto& answered) {
    while (!answered()) std::this_thread::sleep_for(10ms);
  };
  const auto be_greedy_until = [&](const auto& answered) {
    do {
      be_greedy(clients, daemon, greed, faults);
    } while (!answered());
  };
  Latencies without;
  Latencies with;
  for (std::size_t round = 0; round < rounds; ++round) {
    std::this_thread::sleep_for(kRest);
    without.join(other.measure(wait, faults));
    with.join(other.measure(be_greedy_until, faults));
  }
  const double peak = daemon.resources().peak_mb;
  std::printf("%-13s resident at most %.0f MiB, %.2f of the budget; %zu results, %zu refusals, %zu hangups\n",
              name.data(), peak, peak / kBudgetMb, greed.results.load(), greed.refusals.load(), greed.hangups.load());
  std::printf("  marker.get without: %s\n  with:               %s; p99 with / without %.2f (goal: at most 2)\n",
              without.text().c_str(), with.text().c_str(), with.part(0.99) / without.part(0.99));
  faults.expect(peak <= kMostResident * kBudgetMb, std::string{name} + ": resident " + std::to_string(peak) + " MiB");
  const int code = daemon.end();
  faults.expect(code == 0, std::string{name} + ": selvaged ended with code " + std::to_string(code));
  faults.expect(daemon.log_text().find("bad_alloc") == std::string::npos, std::string{name} + ": memory ran out");
}

}  // namespace

void memory(std::size_t rounds, Faults& faults) {
  const bool real_time = server::jobs::use_real_time(server::jobs::RealTime::kAlways);  // the other client
  std::printf("--memory %zu under an address space of %zu MiB%s\n", kBudgetMb, kAddressSpaceMb,
              real_time ? "" : "; but the system allows no real-time priorities");
  for (const GreedyClient& client : greedy_clients()) run_case(client.name, {client}, rounds, faults);
  run_case("all together", greedy_clients(), rounds, faults);
}

}  // namespace selvage::trials
