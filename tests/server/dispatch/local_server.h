// A server without sockets: messages in, answers out.  With 0 workers everything is executed inline.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "server/dispatch/backend.h"
#include "tests/server/dispatch/stub_methods.h"

namespace selvage::test {

// A client's connection and the notifications that it received.
class Client {
 public:
  explicit Client(bool can_be_notified = true) {
    static std::atomic<std::uint64_t> made{};
    session_->id = ++made;
    session_->gone = gone_.get_token();
    if (!can_be_notified) return;
    session_->notify = [this](std::string text) {
      const std::lock_guard lock{mutex_};
      received_.push_back(std::move(text));
      changed_.notify_all();
    };
  }
  [[nodiscard]] const std::shared_ptr<server::transport::access::Session>& session() const { return session_; }
  void disconnect() { gone_.request_stop(); }
  // The next notification; null if none arrives in time.
  [[nodiscard]] Json next() {
    std::unique_lock lock{mutex_};
    if (!changed_.wait_for(lock, kPatience, [this] { return !received_.empty(); })) return nullptr;
    const std::string text = std::move(received_.front());
    received_.pop_front();
    return Json::parse(text);
  }
  [[nodiscard]] std::size_t pending() {
    const std::lock_guard lock{mutex_};
    return received_.size();
  }

 private:
  std::stop_source gone_;
  std::shared_ptr<server::transport::access::Session> session_ = std::make_shared<server::transport::access::Session>();
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::string> received_;
};

class LocalServer {
 public:
  explicit LocalServer(std::size_t workers = 0, MethodTable methods = pushing_methods(),
                       const server::calls::Limits& limits = {}, server::store::Journal* journal = nullptr)
      : LocalServer{server::dispatch::BackendSettings{
            .workers = workers, .limits = limits, .journal = journal, .methods = std::move(methods)}} {}
  explicit LocalServer(server::dispatch::BackendSettings settings) : backend{std::move(settings)} {}

  std::future<std::string> send(std::string message,
                                const std::shared_ptr<server::transport::access::Session>& session) {
    const auto promise = std::make_shared<std::promise<std::string>>();
    // A second answer would throw: promise already satisfied.
    backend.receive(std::move(message), session, [promise](std::string text) { promise->set_value(std::move(text)); });
    return promise->get_future();
  }
  std::future<std::string> send(std::string message) { return send(std::move(message), client.session()); }
  std::string ask(std::string message, const std::shared_ptr<server::transport::access::Session>& session) {
    auto answer = send(std::move(message), session);
    if (answer.wait_for(kPatience) != std::future_status::ready) return "(no answer)";
    return answer.get();
  }
  std::string ask(std::string message) { return ask(std::move(message), client.session()); }
  Json ask_json(std::string message) { return Json::parse(ask(std::move(message))); }
  // The result of a call whose parameters are written with ' instead of ".
  Json result(const std::string& method, std::string params) {
    std::replace(params.begin(), params.end(), '\'', '"');
    const Json answer = ask_json(call(1, method, params));
    return answer.contains("result") ? answer["result"] : answer;
  }
  std::string open_small() {
    return ask_json(call(0, "marker.open", R"({"marker":)" + kSmallMarker + "}"))["result"]["markerId"].text();
  }
  [[nodiscard]] const server::store::MarkerStore& store() const { return backend.store(); }

  Client client;
  server::dispatch::Backend backend;
};

inline int code_of(const Json& answer) {
  return answer["error"]["code"].get<int>();
}

}  // namespace selvage::test
