#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/random.h"
#include "tests/trials/linear_fit.h"
#include "tests/trials/live/caller.h"
#include "tests/trials/live/error_codes.h"
#include "tests/trials/live/live_daemon.h"
#include "tests/trials/trials.h"

namespace selvage::trials {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using test::Random;

constexpr std::size_t kClients = 64;
constexpr double kWarmUp = 0.2;   // the fraction of the time that is not evaluated
constexpr auto kMaxPause = 40ms;  // between two calls of a client

struct SoakTally {
  std::atomic<std::size_t> calls{}, lives{}, busy{}, notifications{};
};

// A marker that all clients may watch and read: the one that was opened last.
class Shown {
 public:
  void show(const std::string& id) {
    const std::lock_guard lock{mutex_};
    id_ = id;
  }
  [[nodiscard]] std::string id() const {
    const std::lock_guard lock{mutex_};
    return id_;
  }

 private:
  mutable std::mutex mutex_;
  std::string id_;
};

// The actions of a client from connecting to disconnecting.
class Life {
 public:
  Life(const LiveDaemon& daemon, Random& random, Shown& shown, SoakTally& tally, Faults& faults)
      : caller_{daemon, static_cast<Endpoint>(random.below(kEndpoints))},
        random_{random},
        shown_{shown},
        tally_{tally},
        faults_{faults} {}

  void live(const Json& document, const std::stop_token& stop) {
    const Json opened = ask("marker.open", {{"marker", document}});
    if (opened.is_null()) return;
    id_ = opened["markerId"];
    pieces_ = &document["pieces"];
    shown_.show(id_);
    for (auto deeds = random_.between(5, 30); deeds > 0 && !stop.stop_requested(); --deeds) {
      do_something();
      std::this_thread::sleep_for(random_.part() * kMaxPause);
    }
    if (random_.chance(90)) {
      (void)ask("marker.close", {{"markerId", id_}});
    } else {
      left_open = id_;  // as after a lost connection
    }
    tally_.notifications += caller_.notifications();
    ++tally_.lives;
  }

  std::string left_open;

 private:
  void do_something() {
    const Json marker{{"markerId", id_}};
    switch (random_.below(10)) {
      case 0: return drag();
      case 1: (void)ask("motion.compact", {{"markerId", id_}, {"accuracy", "draft"}}); return;
      case 2: (void)ask("marker.undo", marker); return;
      case 3: (void)ask("marker.redo", marker); return;
      case 4: (void)ask("marker.watch", {{"markerId", random_.chance(50) ? id_ : shown_.id()}}); return;
      case 5: (void)ask("marker.get", {{"markerId", shown_.id()}}); return;
      case 6: (void)ask("marker.check", marker); return;
      case 7: return bump();
      default: return edit();
    }
  }
  [[nodiscard]] const Json& some_piece() { return (*pieces_)[random_.below(pieces_->size())]["id"]; }
  [[nodiscard]] Json some_place() { return {random_.part() * 3000, random_.part() * 1000}; }

  // Moves the piece to a free place, so that motions still accept the marker.
  void edit() {
    (void)ask("motion.place", {{"markerId", id_}, {"piece", some_piece()}, {"to", some_place()}});
    (void)ask("marker.apply", {{"markerId", id_},
                               {"opId", std::to_string(random_.below(1'000'000'000))},
                               {"ops", {{{"op", "lock"}, {"piece", some_piece()}, {"locked", random_.chance(50)}}}}});
  }
  void bump() {
    const Json direction{random_.part() - 0.5, random_.part() + 0.1};
    (void)ask("motion.bump", {{"markerId", id_}, {"piece", some_piece()}, {"direction", direction}});
  }
  void drag() {
    const Json begun = ask("drag.begin", {{"markerId", id_}, {"piece", some_piece()}, {"mode", "push"}});
    if (begun.is_null()) return;
    const Json& drag = begun["dragId"];
    for (int step = 0; step < 3; ++step) (void)ask("drag.move", {{"dragId", drag}, {"to", some_place()}});
    if (random_.chance(90)) (void)ask("drag.end", {{"dragId", drag}, {"markerId", id_}});
  }

  // The result; null if the call was refused for an acceptable reason.
  Json ask(const std::string& method, const Json& params) {
    ++tally_.calls;
    Json answer = caller_.ask(method, params);
    const int code = code_of(answer);
    if (code == 0) return std::move(answer["result"]);
    if (code == kBusy) ++tally_.busy;
    // Another client may have closed its marker by now, or there may be nothing to undo.
    const bool may_be = code == kBusy || code == kMoved || code == kRefused || code == kUnknownMarker;
    faults_.expect(may_be, method + ": " + answer.dump());
    return nullptr;
  }

  Caller caller_;
  Random& random_;
  Shown& shown_;
  SoakTally& tally_;
  Faults& faults_;
  std::string id_;
  const Json* pieces_{};
};

// An example marker in the native format, which names its pieces.
Json native(const LiveDaemon& daemon, const std::string& name) {
  Caller caller{daemon, Endpoint::kTcp};
  const Json opened = caller.result("marker.open", {{"marker", Json::parse(garment(name))}});
  const Json marker{{"markerId", opened["markerId"]}};
  Json document = caller.result("marker.get", marker)["marker"];
  (void)caller.result("marker.close", marker);
  return document;
}

struct Samples {
  std::vector<Sample> resident_mb, sums_mb, descriptors, store_mb;  // over hours
};

double store_mb(const LiveDaemon& daemon) {
  std::error_code none;
  double bytes{};
  for (const char* end : {"", "-wal"}) {
    const auto size = std::filesystem::file_size(daemon.store() + end, none);
    if (!none) bytes += static_cast<double>(size);
  }
  return bytes / (1 << 20);
}

// The memory of the cached Minkowski sums, which grows up to a limit.
double sums_mb(Caller& caller) {
  return caller.result("engine.info")["cache"]["bytes"].get<double>() / (1 << 20);
}

Samples sample(const LiveDaemon& daemon, double seconds) {
  Samples samples;
  Caller caller{daemon, Endpoint::kTcp};
  const auto began = Clock::now();
  double printed_at{};
  for (;;) {
    std::this_thread::sleep_for(500ms);
    const double now = std::chrono::duration<double>{Clock::now() - began}.count();
    if (now >= seconds) return samples;
    const Resources found = daemon.resources();
    const double sums = sums_mb(caller);
    if (now >= printed_at + seconds / 20) {
      printed_at = now;
      std::printf("%6.0f s: resident %.1f MB, sums %.1f MB, %zu descriptors, store %.1f MB\n", now, found.resident_mb,
                  sums, found.descriptors, store_mb(daemon));
    }
    if (now < seconds * kWarmUp) continue;
    samples.resident_mb.push_back({now / 3600, found.resident_mb});
    samples.sums_mb.push_back({now / 3600, sums});
    samples.descriptors.push_back({now / 3600, static_cast<double>(found.descriptors)});
    samples.store_mb.push_back({now / 3600, store_mb(daemon)});
  }
}

void print(const char* what, const std::vector<Sample>& samples, const char* goal) {
  const LinearFit fit = linear_fit(samples);
  std::printf("%s: slope %+.3f an hour, standard error %.3f%s\n", what, fit.slope, fit.error, goal);
}

void live_on(const std::stop_token& stop, const LiveDaemon& daemon, std::uint64_t seed, const Json& document,
             Shown& shown, SoakTally& tally, Faults& faults) {
  Random random{seed};
  std::string left_open;
  while (!stop.stop_requested()) {
    Life life{daemon, random, shown, tally, faults};
    life.live(document, stop);
    if (!left_open.empty()) (void)Caller{daemon, Endpoint::kTcp}.ask("marker.close", {{"markerId", left_open}});
    left_open = life.left_open;
  }
}

// The number of open descriptors after connections that are being closed have been closed.
std::size_t settled_descriptors(const LiveDaemon& daemon, std::size_t wanted) {
  std::size_t found{};
  for (int tries = 0; tries < 100; ++tries) {
    found = daemon.resources().descriptors;
    if (found <= wanted) break;
    std::this_thread::sleep_for(100ms);
  }
  return found;
}

}  // namespace

void soak(std::size_t seconds, Faults& faults) {
  LiveDaemon daemon{{"--store", "STORE", "--max-connections", "1000"}};
  const std::array documents{native(daemon, "jeans_02g"), native(daemon, "charlie_04g")};
  const std::size_t before = settled_descriptors(daemon, 0);
  SoakTally tally;
  Shown shown;
  Samples samples;
  {
    std::vector<std::jthread> clients;
    for (std::size_t k = 0; k < kClients; ++k) {
      clients.emplace_back([&, k](const std::stop_token& stop) {
        faults.guard("a client",
                     [&] { live_on(stop, daemon, k, documents.at(k % documents.size()), shown, tally, faults); });
      });
    }
    samples = sample(daemon, static_cast<double>(seconds));
    for (std::jthread& client : clients) client.request_stop();
  }
  const std::size_t after = settled_descriptors(daemon, before);
  std::printf("%zu clients, %zu s: %zu connections, %zu calls (%zu busy), %zu notifications\n", kClients, seconds,
              tally.lives.load(), tally.calls.load(), tally.busy.load(), tally.notifications.load());
  print("resident MB", samples.resident_mb, " (goal: slope below 1)");
  print("of it sums MB", samples.sums_mb, "");
  print("descriptors", samples.descriptors, "");
  print("store MB", samples.store_mb, "");
  std::printf("descriptors without clients: %zu before, %zu after\n", before, after);
  faults.expect(tally.lives >= kClients && tally.notifications > 0, "the trial did not exercise everything");
  faults.expect(after <= before, "file descriptors were leaked");
  faults.expect(daemon.end() == 0, "selvaged did not exit with code 0");
}

}  // namespace selvage::trials
