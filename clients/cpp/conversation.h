// The exchange of one client with one daemon, over one connection after another.  Everything here runs on the thread of
// the io_context.
//
// On every connection it first asks for the daemon's instance, and sends nothing else until it knows whether the ids of
// markers still have their meaning.
//
// Invariants: every call that was begun is answered exactly once; every call marked as sent was sent on the current
// connection.
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
#include "clients/cpp/homes.h"

namespace selvage::client {

class Connection;

struct OpenCall {
  std::string method;
  std::string marker;  // the id of the marker that the call concerns; empty if there is none
  std::string line;    // the request, ending in a newline
  bool sent{};
  std::promise<Answer> promise;
  bool only_learns{};  // nothing is sent: from now on, the id names a marker of the present instance
};

class Conversation {
 public:
  Conversation(boost::asio::io_context& io, std::optional<Address> address, Settings settings, Handlers handlers);
  ~Conversation();
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;

  void begin(CallId id, OpenCall call);
  void cancel(CallId id);
  // Answers all open calls with kEnded and closes the connection.  No call may be begun afterwards.
  void end();

 private:
  enum class State { kIdle, kConnecting, kOpen, kEnded };
  // A watch on the current connection.  A daemon that is busy, for instance with loading its markers, refuses it, and
  // is asked again.
  enum class Watch { kAsked, kRefused, kHeld };
  // Whether the daemon has told its instance on the current connection.  One that is busy is asked again.
  enum class Instance { kUnknown, kAsked, kTold };

  void start_trying();
  void attempt();
  void connected();
  void ask_instance();
  void receive_instance(const Answer& received);
  void restore_watches();
  void refuse_calls(const CallError& busy);
  void send(CallId id);
  void receive(const std::string& line);
  void report_reconnection();
  void receive_answer(const Json& message);
  void receive_watch(const std::string& marker, const Answer& received);
  void receive_notification(const Json& message);
  void report_closed(const std::string& marker);
  void remember(const OpenCall& call, const Json& result);
  void send_watch(const std::string& marker);
  void call_later(CallId id);
  void retry_later();
  void handle_disconnect(const std::string& why);
  void handle_failure(const std::string& why);
  void handle_untrusted(const std::string& why);
  void give_up(const CallError& error);
  void answer(CallId id, Answer answer);
  [[nodiscard]] std::optional<CallId> longest_sent() const;

  boost::asio::io_context& io_;
  std::optional<Address> address_;
  Settings settings_;
  Handlers handlers_;
  State state_{State::kIdle};
  bool was_connected_{};    // at any earlier time
  bool reconnecting_{};     // the current connection is not the first one, and it has not been reported yet
  bool received_any_{};     // the daemon has sent something on the current connection
  bool last_was_silent_{};  // the previous connection ended before the daemon sent anything
  std::shared_ptr<Connection> connection_;
  Instance instance_{Instance::kUnknown};
  Homes homes_;
  boost::asio::steady_timer retry_timer_;
  std::chrono::steady_clock::time_point try_until_;
  std::chrono::milliseconds next_pause_{};
  std::map<CallId, OpenCall> open_;
  std::map<std::string, Watch> watched_;  // by the marker's id
  // Calls that began while the daemon was being looked for, and that a busy daemon refused; they are sent again.
  std::set<CallId> refused_calls_;
};

}  // namespace selvage::client
