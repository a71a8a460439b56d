// Follows a marker that is open on a daemon.
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "clients/cli/run/remote.h"
#include "clients/cli/run/remote_marker.h"
#include "clients/cli/terminal/interrupt.h"
#include "clients/cli/terminal/summary.h"
#include "protocol/json/json_text.h"

namespace selvage::cli::run {
namespace {

struct Event {
  enum class Kind { kChanged, kClosed, kReconnected, kLost, kInterrupted } kind{};
  Json params{};          // for kChanged
  std::string message{};  // for kLost
};

// Passes events from the client's thread to the thread that prints.
class EventQueue {
 public:
  void add(Event event) {
    const std::lock_guard lock{mutex_};
    events_.push_back(std::move(event));
    added_.notify_one();
  }
  // Waits for an event.
  Event next() {
    std::unique_lock lock{mutex_};
    added_.wait(lock, [this] { return !events_.empty(); });
    Event event = std::move(events_.front());
    events_.pop_front();
    return event;
  }

 private:
  std::mutex mutex_;
  std::condition_variable added_;
  std::deque<Event> events_;
};

client::Handlers handlers_into(EventQueue& events) {
  client::Handlers handlers;
  handlers.notified = [&events](std::string_view method, const client::Json& params) {
    if (method == "marker.changed") events.add({Event::Kind::kChanged, from_wire(params)});
    if (method == "marker.closed") events.add({Event::Kind::kClosed});
  };
  handlers.reconnected = [&events] { events.add({Event::Kind::kReconnected}); };
  handlers.lost = [&events](const client::CallError& error) {
    events.add({.kind = Event::Kind::kLost, .message = error.message});
  };
  return handlers;
}

// Prints the figures of one marker, each revision once.
class Watch {
 public:
  Watch(std::string marker_id, bool json, client::Client& client)
      : marker_id_{std::move(marker_id)}, json_{json}, client_{client} {}

  // `figures`: {"markerId", "revision", "by"?, "name", "pieces", "length", "utilisation", "valid", ...}
  void print(const Json& figures) {
    const auto revision = figures.value("revision", std::uint64_t{0});
    if (revision <= printed_) return;
    printed_ = revision;
    std::cout << (json_ ? protocol::json::to_text(figures) : terminal::plain_change(figures)) << std::endl;
  }
  // Prints the current state if it has not been printed yet.
  std::optional<terminal::Failure> catch_up() {
    for (;;) {
      const client::Answer checked = ask("marker.check", {{"markerId", marker_id_}});
      if (!checked) return failure_of(checked.error());
      const client::Answer listed = ask("marker.list", client::Json::object());
      if (!listed) return failure_of(listed.error());
      for (client::Json figures : (*listed)["markers"]) {
        if (figures["markerId"] != marker_id_ || figures["revision"] != (*checked)["revision"]) continue;
        figures["valid"] = (*checked)["valid"];
        print(from_wire(figures));
        return std::nullopt;
      }
    }  // The marker changed between the two calls: try again.
  }

 private:
  // A daemon that has just been started may still be loading its markers.
  client::Answer ask(const std::string& method, const client::Json& params) {
    constexpr int kTries = 600;
    constexpr std::chrono::milliseconds kPause{100};
    for (int k = 1;; ++k) {
      client::Answer answer = client_.call(method, params);
      if (answer || answer.error().code != client::CallCode::kBusy || k == kTries) return answer;
      std::this_thread::sleep_for(kPause);
    }
  }

  const std::string marker_id_;
  const bool json_;
  client::Client& client_;
  std::uint64_t printed_{};
};

terminal::ExitCode follow(Watch& watch, EventQueue& events) {
  for (;;) {
    const Event event = events.next();
    switch (event.kind) {
      case Event::Kind::kChanged: watch.print(event.params); break;
      case Event::Kind::kReconnected:
        if (const auto failure = watch.catch_up()) return report(*failure);
        break;
      case Event::Kind::kLost: return terminal::report(terminal::Failure{event.message, terminal::ExitCode::kServer});
      case Event::Kind::kClosed:
      case Event::Kind::kInterrupted: return terminal::ExitCode::kOk;
    }
  }
}

}  // namespace

terminal::ExitCode watch(const ServerChoice& server, const std::string& marker_id, bool json) {
  const terminal::Interrupt interrupt;
  EventQueue events;
  const auto on_interrupt = [&events] { events.add({Event::Kind::kInterrupted}); };
  const std::stop_callback interrupted{interrupt.token(), on_interrupt};
  const auto connected = connect(server, handlers_into(events));
  if (const auto* failure = std::get_if<terminal::Failure>(&connected)) return report(*failure);
  client::Client& client = *std::get<std::unique_ptr<client::Client>>(connected);
  const client::Answer watching = client.call("marker.watch", {{"markerId", marker_id}});
  if (!watching) return report(failure_of(watching.error()));
  Watch watch{marker_id, json, client};
  if (const auto failure = watch.catch_up()) return report(*failure);
  return follow(watch, events);
}

}  // namespace selvage::cli::run
