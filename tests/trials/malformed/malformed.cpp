#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "tests/trials/latencies.h"
#include "tests/trials/live/caller.h"
#include "tests/trials/live/live_daemon.h"
#include "tests/trials/malformed/malformed_http.h"
#include "tests/trials/malformed/malformed_messages.h"
#include "tests/trials/trials.h"

namespace selvage::trials {
namespace {

constexpr std::size_t kBatch = 16;            // messages between two valid calls
constexpr std::size_t kPerExtreme = 100'000;  // number of requests for each round of the large ones
constexpr std::size_t kSweepAt = 300;         // open markers
constexpr double kGoalMs = 100;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kMostGrownMb = 4096;  // with a sanitiser, whose own memory grows, too
#else
constexpr double kMostGrownMb = 64;
#endif

struct AttackTally {
  std::atomic<std::size_t> sent{}, answered{}, closed{};
};

// The markers of one of the attackers, which nobody else may close.
class InUse {
 public:
  void exchange(const std::string& old, const std::string& fresh) {
    const std::lock_guard lock{mutex_};
    ids_.erase(old);
    ids_.insert(fresh);
  }
  [[nodiscard]] bool has(const std::string& id) const {
    const std::lock_guard lock{mutex_};
    return ids_.contains(id);
  }

 private:
  mutable std::mutex mutex_;
  std::set<std::string> ids_;
};

// A well-behaved client during an attack, whose calls must always be answered.
class SoundCaller {
 public:
  SoundCaller(const LiveDaemon& daemon, InUse& in_use) : caller_{daemon, Endpoint::kTcp}, in_use_{in_use} {}

  // Makes one call and records its duration.  Reopens the marker of the attack if a request that was valid has closed
  // it.
  void call() {
    const Json answer = latencies.time([&] { return caller_.ask("marker.get", {{"markerId", marker_id_}}); });
    if (code_of(answer) != 0) open();
    if (++calls_ % 50 == 0) sweep(kSweepAt);
  }
  // Closes markers that valid requests have opened if there are more than this number.
  void sweep(std::size_t most) {
    const Json markers = caller_.result("marker.list")["markers"];
    if (markers.size() <= most) return;
    for (const Json& marker : markers) {
      if (!in_use_.has(marker["markerId"])) (void)caller_.ask("marker.close", {{"markerId", marker["markerId"]}});
    }
  }
  [[nodiscard]] const std::string& marker_id() const { return marker_id_; }

  Latencies latencies;

 private:
  void open() {
    const std::string id = caller_.result("marker.open", {{"marker", Json::parse(R"({
      "format": "selvage-marker", "version": 1, "name": "two squares", "strip": {"width": 100},
      "shapes": [{"id": "square", "outline": [[0, 0], [40, 0], [40, 40], [0, 40]]}],
      "pieces": [{"id": "left", "shape": "square", "at": [0, 0]}, {"id": "right", "shape": "square", "at": [50, 10]}]
    })")}})["markerId"];
    in_use_.exchange(std::exchange(marker_id_, id), id);
  }

  Caller caller_;
  InUse& in_use_;
  std::string marker_id_;
  std::size_t calls_{};
};

// Attacks one listener with its share of the requests.
class Attack {
 public:
  Attack(const LiveDaemon& daemon, std::uint64_t seed, InUse& in_use, AttackTally& tally)
      : sound{daemon, in_use}, daemon_{daemon}, messages_{seed}, random_{seed}, tally_{tally} {
    sound.call();
  }
  virtual ~Attack() = default;
  Attack(const Attack&) = delete;
  Attack& operator=(const Attack&) = delete;

  void run(std::size_t count, std::size_t extreme_rounds) {
    for (std::size_t sent = 0; sent < count;) {
      const std::size_t now = std::min(kBatch, count - sent);
      std::vector<std::string> batch;
      for (std::size_t k = 0; k < now; ++k) batch.push_back(messages_.next(sound.marker_id()));
      send(batch);
      sound.call();
      sent += now;
      if (sent / kBatch % 8 == 0) {
        send_raw();
        sound.call();
      }
    }
    const std::size_t limit = Caller{daemon_, Endpoint::kTcp}.result("engine.info")["limits"]["requestBytes"];
    for (std::size_t round = 0; round < extreme_rounds; ++round) {
      for (std::size_t which = 0; which < kExtremes; ++which) {
        send({extreme_message(which, limit)});
        sound.call();
      }
    }
  }

  SoundCaller sound;

 protected:
  // Sends the messages and waits until each is answered or the connection is closed.
  virtual void send(const std::vector<std::string>& batch) = 0;
  // Sends bytes on a new connection and waits until that is closed.
  virtual void send_raw() = 0;

  void await_close(test::Wire& wire, const std::string& bytes) {
    ++tally_.sent;
    if (wire.try_send(bytes)) wire.half_close();
    ++(wire.rest().empty() ? tally_.closed : tally_.answered);
  }

  const LiveDaemon& daemon_;
  MalformedMessages messages_;
  test::Random random_;
  AttackTally& tally_;
};

class HttpAttack final : public Attack {
 public:
  using Attack::Attack;

 private:
  void send(const std::vector<std::string>& batch) override {
    for (const std::string& message : batch) {
      if (!wire_) wire_ = std::make_unique<test::Wire>(daemon_.port());
      ++tally_.sent;
      (void)wire_->try_send(test::post_request(message));  // may be refused and closed before everything is read
      const auto answer = wire_->answer();
      ++(answer ? tally_.answered : tally_.closed);
      if (!answer || answer->says("Connection: close")) wire_.reset();
    }
  }
  void send_raw() override {
    test::Wire wire{daemon_.port()};
    await_close(wire, malformed_http(random_));
  }

  std::unique_ptr<test::Wire> wire_;
};

class LineAttack final : public Attack {
 public:
  LineAttack(Endpoint endpoint, const LiveDaemon& daemon, std::uint64_t seed, InUse& in_use, AttackTally& tally)
      : Attack{daemon, seed, in_use, tally}, door_{endpoint}, caller_{daemon, endpoint} {
    (void)caller_.result("engine.info");  // a connection whose first line is not JSON would be closed
  }

 private:
  void send(const std::vector<std::string>& batch) override {
    for (const std::string& message : batch) caller_.send_text(message);
    tally_.sent += batch.size();
    for (std::size_t answers = 0; answers < batch.size(); answers += one_answer() ? 1 : 0) {
    }
  }
  // Returns false if the message was a notification.
  bool one_answer() {
    const auto text = caller_.next_text();
    if (!text) throw std::runtime_error{"a line connection has ended"};
    const Json message = Json::parse(*text);
    if (message.is_object() && !message.contains("id")) return false;
    ++tally_.answered;
    return true;
  }
  void send_raw() override {
    Caller other{daemon_, door_};
    std::string bytes(1 + random_.below(20'000), ' ');
    for (char& byte : bytes) byte = static_cast<char>(random_.below(256));
    await_close(other.wire(), bytes);
  }

  Endpoint door_;
  Caller caller_;
};

class WebSocketAttack final : public Attack {
 public:
  using Attack::Attack;

 private:
  void send(const std::vector<std::string>& batch) override {
    for (const std::string& message : batch) {
      if (!socket_) socket_ = std::make_unique<test::WebSocketWire>(daemon_.port());
      ++tally_.sent;
      if (is_answered(message)) {
        ++tally_.answered;
      } else {
        ++tally_.closed;
        socket_.reset();
      }
    }
  }
  bool is_answered(const std::string& message) {
    if (!socket_->wire().try_send(test::frame_bytes({test::Opcode::kText, message}))) return false;
    for (;;) {
      const auto text = socket_->text();
      if (!text) return false;
      const Json answer = Json::parse(*text);
      if (!answer.is_object() || answer.contains("id")) return true;
    }
  }
  void send_raw() override {
    test::WebSocketWire socket{daemon_.port()};
    await_close(socket.wire(), malformed_frames(random_));
  }

  std::unique_ptr<test::WebSocketWire> socket_;
};

}  // namespace

void malformed(std::size_t count, Faults& faults) {
  // What asks for hours of work, such as 2^31 moves of a nesting, is answered after this time.
  LiveDaemon daemon{{"--call-seconds", "10"}};
  InUse in_use;
  AttackTally tally;
  std::vector<std::unique_ptr<Attack>> attacks;
  attacks.push_back(std::make_unique<HttpAttack>(daemon, 1, in_use, tally));
  attacks.push_back(std::make_unique<WebSocketAttack>(daemon, 2, in_use, tally));
  attacks.push_back(std::make_unique<LineAttack>(Endpoint::kTcp, daemon, 3, in_use, tally));
  attacks.push_back(std::make_unique<LineAttack>(Endpoint::kUnix, daemon, 4, in_use, tally));
  const Resources before = daemon.resources();
  const auto began = std::chrono::steady_clock::now();
  {
    std::vector<std::jthread> threads;
    for (const auto& attack : attacks) {
      threads.emplace_back([&, one = attack.get()] {
        faults.guard("an attack", [&] { one->run(count / attacks.size(), count / kPerExtreme + 1); });
      });
    }
  }
  const double seconds = std::chrono::duration<double>{std::chrono::steady_clock::now() - began}.count();
  attacks.front()->sound.sweep(0);
  std::this_thread::sleep_for(std::chrono::seconds{1});  // the last answers are being freed
  const Resources after = daemon.resources();
  Latencies sound;
  for (const auto& attack : attacks) sound.join(attack->sound.latencies);
  std::printf("%zu malformed requests on HTTP, WebSocket, TCP and Unix in %.1f s: %zu answered, %zu closed\n",
              tally.sent.load(), seconds, tally.answered.load(), tally.closed.load());
  std::printf("the next valid call: %s (goal: below %.0f)\n", sound.text().c_str(), kGoalMs);
  std::printf("resident %.1f MB before, %.1f after, %.1f at most\n", before.resident_mb, after.resident_mb,
              after.peak_mb);
  faults.expect(tally.sent == tally.answered + tally.closed,
                "some requests were neither answered nor followed by closing the connection");
  faults.expect(after.resident_mb - before.resident_mb < kMostGrownMb, "resident memory has grown");
  attacks.clear();
  faults.expect(daemon.end() == 0, "selvaged did not exit with code 0");
}

}  // namespace selvage::trials
