// A client of selvaged: newline-delimited JSON-RPC 2.0 over TCP, TLS or a Unix socket.  Needs Boost.Asio, OpenSSL and
// nlohmann-json, and nothing else of Selvage.
//
//   Client client{"127.0.0.1:7171"};
//   const Answer opened = client.call("marker.open", {{"marker", document}});
//   if (opened) std::cout << (*opened)["length"];
//
// Methods, parameters and results are those of protocol/README.md.  Many calls may be under way at once; each is
// answered exactly once, in the order they are done, not in the order they were begun.
//
// The connection is made by the first call, and made again when it breaks.  Calls without an answer are then sent
// again where that is safe (repeating.h): changes are given an opId for it.  Markers that were watched are watched
// again.  A client is safe to use from many threads.
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
  std::string token{};                       // shown first on every connection; empty: the daemon wants none
  std::string trusted{};                     // a PEM file of certificates to trust with TLS; empty: those of the system
  std::chrono::milliseconds connect_for{0};  // how long to try for the first connection; 0: once
  std::chrono::milliseconds reconnect_for{10'000};  // and for those after it
};

// All called on the client's own thread: they may begin and cancel calls, but must not wait for answers.
struct Handlers {
  // What the daemon tells unasked: "marker.changed", "marker.closed", "$/progress".
  std::function<void(std::string_view method, const Json& params)> notified{};
  // The connection broke and was made again; what happened in between was not told.
  std::function<void()> reconnected{};
  // It broke, or could not be made, and the client has stopped trying.  The next call tries again.
  std::function<void(const CallError&)> lost{};
};

using CallId = std::uint64_t;

struct Call {
  CallId id{};
  std::future<Answer> answer;
};

class Client {
 public:
  // `address` as of address.h.  A bad one fails the calls (kBadAddress).
  explicit Client(std::string_view address, Settings settings = {}, Handlers handlers = {});
  // Calls without an answer are answered kEnded.  REQUIRES: not on the client's own thread.
  ~Client();
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  // REQUIRES: text in UTF-8.
  [[nodiscard]] Call begin(std::string_view method, Json params = Json::object());
  // Waits for the answer.  REQUIRES: not on the client's own thread.
  Answer call(std::string_view method, Json params = Json::object());
  // Asks that the call be given up: it is answered kCancelled, or as usual when it is too late.
  void cancel(CallId id);

 private:
  class Own;
  std::unique_ptr<Own> own_;
};

}  // namespace selvage::client
