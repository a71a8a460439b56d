// Everything behind the transport: messages in, answers out, without sockets.  Inline with 0 workers.
#pragma once

#include <gtest/gtest.h>

#include <condition_variable>
#include <deque>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "server/dispatch/dispatcher.h"
#include "tests/server/dispatch/stub_engine.h"

namespace selvage::test {

inline protocol::calls::Engine pushing_engine() {
  protocol::calls::Engine engine;
  engine.compact = [](const Marker& start, const motion::compaction::CompactionSettings&,
                      const scene::Run& run) -> Result<motion::compaction::Compaction> {
    run.observer.on_stage(scene::Stage::kSolve);
    return push_left(start);
  };
  return engine;
}

// Someone at the other end of a connection, and what they were notified of.
class Listener {
 public:
  explicit Listener(bool can_be_notified = true) {
    static std::atomic<std::uint64_t> made{};
    session_->id = ++made;
    session_->gone = gone_.get_token();
    if (!can_be_notified) return;
    session_->notify = [this](std::string text) {
      const std::lock_guard lock{mutex_};
      heard_.push_back(std::move(text));
      changed_.notify_all();
    };
  }
  [[nodiscard]] const std::shared_ptr<server::transport::access::Session>& session() const { return session_; }
  void leave() { gone_.request_stop(); }
  // The next notification, once it is there; null when there is none in time.
  [[nodiscard]] Json next() {
    std::unique_lock lock{mutex_};
    if (!changed_.wait_for(lock, kPatience, [this] { return !heard_.empty(); })) return nullptr;
    const std::string text = std::move(heard_.front());
    heard_.pop_front();
    return Json::parse(text);
  }
  [[nodiscard]] std::size_t heard() {
    const std::lock_guard lock{mutex_};
    return heard_.size();
  }

 private:
  std::stop_source gone_;
  std::shared_ptr<server::transport::access::Session> session_ = std::make_shared<server::transport::access::Session>();
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::string> heard_;
};

struct Desk {
  explicit Desk(std::size_t workers = 0, protocol::calls::Engine engine = pushing_engine(),
                server::calls::Limits with = {}, server::store::Journal* journal = nullptr)
      : limits{with},
        store{limits.open_markers, journal},
        methods{store, watchers, sums, limits, workers, std::move(engine)},
        parsing{workers == 0 ? 0U : 1U, limits.waiting_reads},
        reads{workers == 0 ? 0U : 1U, limits.waiting_reads, 1},
        motions{workers, limits.waiting_motions, 1},
        parallelism{workers == 0 ? 0U : 1U, limits.waiting_moves} {}

  std::future<std::string> send(std::string message,
                                const std::shared_ptr<server::transport::access::Session>& session) {
    const auto promise = std::make_shared<std::promise<std::string>>();
    // A second answer would throw: promise already satisfied.
    dispatcher.receive(std::move(message), session,
                       [promise](std::string text) { promise->set_value(std::move(text)); });
    return promise->get_future();
  }
  std::future<std::string> send(std::string message) { return send(std::move(message), usual.session()); }
  std::string ask(std::string message, const std::shared_ptr<server::transport::access::Session>& session) {
    auto answer = send(std::move(message), session);
    if (answer.wait_for(kPatience) != std::future_status::ready) return "(no answer)";
    return answer.get();
  }
  std::string ask(std::string message) { return ask(std::move(message), usual.session()); }
  Json ask_json(std::string message) { return Json::parse(ask(std::move(message))); }
  // The result of a call whose parameters are written with ' for ".
  Json result(const std::string& method, std::string params) {
    std::replace(params.begin(), params.end(), '\'', '"');
    const Json answer = ask_json(call(1, method, params));
    return answer.contains("result") ? answer["result"] : answer;
  }
  std::string open_small() {
    return ask_json(call(0, "marker.open", R"({"marker":)" + kSmallMarker + "}"))["result"]["markerId"];
  }

  server::calls::Limits limits;
  SumCache sums{std::size_t{1} << 20};
  server::store::MarkerStore store;
  server::methods::Watchers watchers;
  server::methods::Methods methods;
  server::jobs::DeadlineClock clock;
  Listener usual;
  server::jobs::JobQueue parsing, reads, motions, parallelism;
  server::methods::Drags drags{store, methods, sums, parallelism};
  server::dispatch::Dispatcher dispatcher{methods, drags, clock, parsing, reads, motions, limits};
};

inline int code_of(const Json& answer) {
  return answer.at("error").at("code");
}

}  // namespace selvage::test
