#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tests/trials/latencies.h"
#include "tests/trials/live/caller.h"
#include "tests/trials/live/live_daemon.h"
#include "tests/trials/trials.h"

namespace selvage::trials {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kSlowWriters = 500, kSlowReaders = 50;
constexpr auto kPeriod = 3s;                // with and without slow clients, alternating
constexpr std::size_t kUnreadAnswers = 40;  // that a slow reader leaves unread: about 3 MB

// Sends one byte of a request now and then; reconnects when it is disconnected.
class SlowWriter {
 public:
  SlowWriter(const LiveDaemon& daemon, std::size_t number) : daemon_{daemon}, text_{text_of(number)} { come(); }

  void send_a_byte() {
    if (sent_ == text_.size() || !wire_->try_send(text_.substr(sent_++, 1))) come();
  }

 private:
  static std::string text_of(std::size_t number) {
    const std::string pad(1000, 'a');
    switch (number % 4) {
      case 0: return "POST /rpc HTTP/1.1\r\nHost: localhost\r\nX-Slow: " + pad;
      case 1: return "POST /rpc HTTP/1.1\r\nHost: localhost\r\nContent-Length: 2000\r\n\r\n" + pad;
      case 2: return R"({"jsonrpc":"2.0","id":")" + pad;
      default: return test::upgrade_request().substr(0, 100) + pad;
    }
  }
  void come() {
    wire_ = std::make_unique<test::Wire>(daemon_.port());
    sent_ = 1;
    (void)wire_->try_send(text_.substr(0, sent_));
  }

  const LiveDaemon& daemon_;
  std::string text_;
  std::size_t sent_{};
  std::unique_ptr<test::Wire> wire_;
};

// Requests megabytes and reads none of them; reconnects when it is disconnected.
class SlowReader {
 public:
  SlowReader(const LiveDaemon& daemon, const std::string& marker_id)
      : daemon_{daemon}, asked_{call_text(1, "marker.get", {{"markerId", marker_id}}) + "\n"} {
    come();
  }

  void stay() {
    if (!wire_->try_send("\n")) come();
  }

 private:
  void come() {
    wire_ = std::make_unique<test::Wire>(daemon_.lines_port());
    for (std::size_t k = 0; k < kUnreadAnswers; ++k) (void)wire_->try_send(asked_);
  }

  const LiveDaemon& daemon_;
  std::string asked_;
  std::unique_ptr<test::Wire> wire_;
};

// All slow clients, on one thread: each does something once a second.
class SlowCrowd {
 public:
  SlowCrowd(const LiveDaemon& daemon, const std::string& marker_id, Faults& faults) {
    for (std::size_t k = 0; k < kSlowWriters; ++k) writers_.push_back(std::make_unique<SlowWriter>(daemon, k));
    for (std::size_t k = 0; k < kSlowReaders; ++k) readers_.push_back(std::make_unique<SlowReader>(daemon, marker_id));
    thread_ = std::jthread{
        [this, &faults](const std::stop_token& stop) { faults.guard("the slow clients", [&] { trickle(stop); }); }};
  }

 private:
  void trickle(const std::stop_token& stop) {
    for (std::size_t step = 0; !stop.stop_requested(); step = (step + 1) % 10) {
      for (std::size_t k = step; k < writers_.size(); k += 10) writers_[k]->send_a_byte();
      for (std::size_t k = step; k < readers_.size(); k += 10) readers_[k]->stay();
      std::this_thread::sleep_for(100ms);
    }
  }

  std::vector<std::unique_ptr<SlowWriter>> writers_;
  std::vector<std::unique_ptr<SlowReader>> readers_;
  std::jthread thread_;
};

// The latencies of the other clients.
class Others {
 public:
  explicit Others(const LiveDaemon& daemon) : wire_{daemon.port()}, caller_{daemon, Endpoint::kTcp} {
    const Json opened = caller_.result("marker.open", {{"marker", Json::parse(garment("jeans_06g"))}});
    marker_id_ = opened["markerId"];
    pieces_ = caller_.result("marker.get", {{"markerId", marker_id_}})["marker"]["pieces"];
  }
  [[nodiscard]] const std::string& marker_id() const { return marker_id_; }

  void measure(Latencies& gets, Latencies& bumps, Faults& faults) {
    const std::string get = call_text(1, "marker.get", {{"markerId", marker_id_}});
    for (const auto end = Clock::now() + kPeriod; Clock::now() < end; std::this_thread::sleep_for(1ms)) {
      const auto got = gets.time([&] { return wire_.post(get); });
      faults.expect(got && got->status == 200, "marker.get was not answered");
      const Json& piece = pieces_[turn_++ % pieces_.size()]["id"];
      const Json params{{"markerId", marker_id_}, {"piece", piece}, {"direction", {-1, 0.5}}, {"commit", false}};
      const Json bumped = bumps.time([&] { return caller_.ask("motion.bump", params); });
      faults.expect(code_of(bumped) == 0, "motion.bump: " + bumped.dump());
    }
  }

 private:
  test::Wire wire_;
  Caller caller_;
  std::string marker_id_;
  Json pieces_;
  std::size_t turn_{};
};

void allow_sockets() {
  rlimit limit{};
  ::getrlimit(RLIMIT_NOFILE, &limit);
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

void print(const char* what, const Latencies& without, const Latencies& with) {
  std::printf("%s\n  without: %s\n  with:    %s\n  p99 with / without: %.2f (goal: at most 2)\n", what,
              without.text().c_str(), with.text().c_str(), with.part(0.99) / without.part(0.99));
}

}  // namespace

void slow(std::size_t rounds, Faults& faults) {
  allow_sockets();
  LiveDaemon daemon{{"--max-connections", "1000"}};
  Others others{daemon};
  Latencies gets_without, gets_with, bumps_without, bumps_with;
  std::size_t most_descriptors{};
  for (std::size_t round = 0; round < rounds; ++round) {
    others.measure(gets_without, bumps_without, faults);
    const SlowCrowd crowd{daemon, others.marker_id(), faults};
    std::this_thread::sleep_for(1s);  // all have connected
    others.measure(gets_with, bumps_with, faults);
    most_descriptors = std::max(most_descriptors, daemon.resources().descriptors);
  }
  std::printf("%zu slow writers and %zu slow readers, %zu rounds; %zu descriptors at most, resident %.1f MB at most\n",
              kSlowWriters, kSlowReaders, rounds, most_descriptors, daemon.resources().peak_mb);
  print("marker.get over HTTP", gets_without, gets_with);
  print("motion.bump over lines", bumps_without, bumps_with);
  faults.expect(most_descriptors > kSlowWriters + kSlowReaders, "not all slow clients were connected");
  faults.expect(daemon.end() == 0, "selvaged did not exit with code 0");
}

}  // namespace selvage::trials
