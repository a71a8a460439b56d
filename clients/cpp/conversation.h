// One client's talk with one daemon, over as many connections as it takes.  Everything here happens on the thread of
// its io_context.
//
// Invariants: every call begun is answered exactly once; a call is unsent, or was sent on the present connection.
#pragma once

#include <chrono>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>

#include "clients/cpp/address.h"
#include "clients/cpp/client.h"

namespace selvage::client {

class Link;

struct OpenCall {
  std::string method, marker;  // the marker it is about, if any
  std::string line;            // the request, ending in a newline
  bool sent{};
  std::promise<Answer> promise;
};

class Conversation {
 public:
  Conversation(boost::asio::io_context& io, std::optional<Address> address, Settings settings, Handlers handlers);
  ~Conversation();
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;

  void begin(CallId id, OpenCall call);
  void cancel(CallId id);
  // Answers what is open and hangs up, for good.
  void end();

 private:
  enum class State { kIdle, kConnecting, kOpen, kEnded };

  void begin_trying();
  void attempt();
  void connected();
  void send(OpenCall& call);
  void hear(const std::string& line);
  void hear_answer(const Json& message);
  void hear_notification(const Json& message);
  void hear_closed(const std::string& marker);
  void note_watching(const OpenCall& call);
  void broken(const std::string& why);
  void failed(const std::string& why);
  void distrusted(const std::string& why);
  void give_up(const CallError& error);
  void answer(CallId id, Answer answer);
  [[nodiscard]] std::optional<CallId> longest_sent() const;

  boost::asio::io_context& io_;
  std::optional<Address> address_;
  Settings settings_;
  Handlers handlers_;
  State state_{State::kIdle};
  bool was_connected_{};  // at any time before
  bool again_{};          // the present connection is not the first
  bool heard_{};          // anything, on the present connection
  bool fruitless_{};      // the connection before it ended before anything was heard
  std::shared_ptr<Link> link_;
  boost::asio::steady_timer pause_;
  std::chrono::steady_clock::time_point try_until_;
  std::chrono::milliseconds next_pause_{};
  std::map<CallId, OpenCall> open_;
  std::set<std::string> watched_;
};

}  // namespace selvage::client
