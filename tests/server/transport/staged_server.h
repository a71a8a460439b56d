// A transport whose service the test controls: messages that contain "hold" wait until the test answers them, those
// that contain "silent" get no answer, those that contain "throw" make the service throw an exception; all others are
// sent back unchanged.
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "server/transport/transport.h"
#include "tests/server/wire/wire.h"

namespace selvage::test {

struct HeldCall {
  std::string message;
  std::shared_ptr<server::transport::access::Session> session;
  std::stop_token caller;
  server::transport::access::Reply reply;
};

// Blocks until the token stops.  Returns false if that does not happen in time.
inline bool stops(const std::stop_token& token) {
  std::mutex mutex;
  std::condition_variable_any changed;
  std::unique_lock lock{mutex};
  changed.wait_for(lock, token, kPatience, [] { return false; });
  return token.stop_requested();
}

class StagedServer {
 public:
  explicit StagedServer(const server::transport::access::TransportLimits& limits = {})
      : StagedServer{server::transport::access::ListenSettings{}, limits} {}
  // Adds a TCP listener for HTTP if there are no listeners.
  explicit StagedServer(server::transport::access::ListenSettings listen,
                        const server::transport::access::TransportLimits& limits = {})
      : account_{std::make_shared<server::memory::ByteAccount>(limits.traffic_bytes)},
        transport_{
            with_http(std::move(listen)), limits,
            server::transport::access::Service{
                .call =
                    [this](std::string message, const std::shared_ptr<server::transport::access::Session>& session,
                           server::transport::access::Reply reply) {
                      take({std::move(message), session, session->gone, std::move(reply)});
                    },
                .weigh = weight_in,
                .health = [] { return std::string{"well"}; },
                .ready = [this] { return why_not_ready(); },
                .metrics = [] { return std::string{"up 1\n"}; },
                .authenticate =
                    [](std::string_view line, const server::transport::access::Access& access) {
                      const bool granted = token_matches(access, line);
                      return server::transport::access::Authentication{granted, granted ? "come in" : "stay out"};
                    },
                .line_too_long = "too long",
                .no_room = "no room",
                .account = account_,
                .counts = counts_}} {}

  [[nodiscard]] std::uint16_t port() const { return transport_.listeners().front().port; }
  [[nodiscard]] server::transport::Transport& transport() { return transport_; }
  [[nodiscard]] const server::transport::access::TransportCounts& counts() const { return *counts_; }
  // The bytes that clients make the server hold.
  [[nodiscard]] const server::memory::ByteAccount& account() const { return *account_; }
  void set_why_not_ready(std::string why) {
    const std::lock_guard lock{mutex_};
    why_not_ready_ = std::move(why);
  }

  // Waits for the next held call.
  [[nodiscard]] HeldCall next_held() {
    std::unique_lock lock{mutex_};
    if (!changed_.wait_for(lock, kPatience, [this] { return !held_.empty(); })) {
      throw std::runtime_error{"no call in time"};
    }
    HeldCall call = std::move(held_.front());
    held_.pop_front();
    return call;
  }
  [[nodiscard]] std::size_t held() {
    const std::lock_guard lock{mutex_};
    return held_.size();
  }

 private:
  static server::transport::access::ListenSettings with_http(server::transport::access::ListenSettings listen) {
    if (listen.listeners.empty())
      listen.listeners.push_back({.speaks = server::transport::access::Listener::Speaks::kHttp, .host = "127.0.0.1"});
    return listen;
  }
  // The weight that a message states for itself: {"weight":17, ...}.
  static std::size_t weight_in(std::string_view message) {
    constexpr std::string_view kField = "\"weight\":";
    const std::size_t found = message.find(kField);
    return found == std::string_view::npos ? 0 : std::stoul(std::string{message.substr(found + kField.size())});
  }
  [[nodiscard]] std::string why_not_ready() {
    const std::lock_guard lock{mutex_};
    return why_not_ready_;
  }

  void take(HeldCall call) {
    const auto says = [&](const char* word) { return call.message.find(word) != std::string::npos; };
    if (says("throw")) throw std::runtime_error{"on purpose"};
    if (says("silent")) return call.reply({});
    if (!says("hold")) return call.reply(call.message);
    const std::lock_guard lock{mutex_};
    held_.push_back(std::move(call));
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<HeldCall> held_;
  std::string why_not_ready_;
  const std::shared_ptr<server::memory::ByteAccount> account_;
  const std::shared_ptr<server::transport::access::TransportCounts> counts_ =
      std::make_shared<server::transport::access::TransportCounts>();
  server::transport::Transport transport_;
};

}  // namespace selvage::test
