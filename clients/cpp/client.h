// A client of selvaged: newline-delimited JSON-RPC 2.0 over TCP, TLS or a Unix socket.  It needs Boost.Asio, OpenSSL
// and nlohmann-json, and no other part of Selvage.
//
//   Client client{"127.0.0.1:7171"};
//   const Answer opened = client.call("marker.open", {{"marker", document}});
//   if (opened) std::cout << (*opened)["length"];
//
// protocol/README.md documents the methods, parameters and results.  Many calls may be in progress at once.  Each is
// answered exactly once, in the order in which they finish.
//
// The first call connects.  If the connection breaks, the client reconnects and sends unanswered calls again where that
// is safe (resending.h); for this, it adds an opId to calls that change something.  It also restores watches.  The id
// of a marker that was lost with its daemon is not used in another instance of it (homes.h).  A client may be used from
// many threads.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <string_view>

#include "clients/cpp/answer.h"

namespace selvage::client {

struct Settings {
  std::string token{};                       // sent first on every connection; empty: the daemon needs none
  std::string trusted{};                     // a PEM file of certificates to trust with TLS; empty: those of the system
  std::chrono::milliseconds connect_for{0};  // time limit of the first connection; 0: one attempt
  std::chrono::milliseconds reconnect_for{10'000};  // time limit of every later connection
};

// Called on the client's own thread.  Handlers may begin and cancel calls, but must not wait for answers.
struct Handlers {
  // A notification of the daemon: "marker.changed", "marker.closed" or "$/progress".
  std::function<void(std::string_view method, const Json& params)> notified{};
  // The connection broke and was restored, and the daemon again reports changes of every watched marker.  Notifications
  // may have been missed in between.
  std::function<void()> reconnected{};
  // The connection broke or could not be established, and the client has stopped trying.  The next call tries again.
  std::function<void(const CallError&)> lost{};
};

using CallId = std::uint64_t;

struct Call {
  CallId id{};
  std::future<Answer> answer;
};

class Client {
 public:
  // `address`: see address.h.  With an invalid address all calls fail (kBadAddress).
  explicit Client(std::string_view address, Settings settings = {}, Handlers handlers = {});
  // Unanswered calls are answered kEnded.  REQUIRES: not called on the client's own thread.
  ~Client();
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  // Sends the call and returns at once.  REQUIRES: all text is UTF-8.
  [[nodiscard]] Call begin(std::string_view method, Json params = Json::object());
  // Waits for the answer.  REQUIRES: not called on the client's own thread.
  Answer call(std::string_view method, Json params = Json::object());
  // Tells the client that this id, received from elsewhere, names a marker that is open now.  Calls that begin
  // afterwards use it even if it named a marker that was lost with an earlier instance of the daemon.  Nothing about
  // the marker is sent; the answer is null once the client is connected and knows the daemon's instance, or the error
  // that prevented it.
  [[nodiscard]] Call learn_marker(std::string marker_id);
  // Requests that the call be cancelled.  It is answered kCancelled, or as usual if it had already finished.
  void cancel(CallId id);

 private:
  class Own;
  std::unique_ptr<Own> own_;
};

}  // namespace selvage::client
