// The program of a page that has no daemon: the daemon without its transport, its threads and its store.  The page
// calls receive() with each message, and is sent answers and notifications, as over a WebSocket.
//
// A call runs to its end before the next message is received, so only its own deadline can stop it.
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>

#include "server/dispatch/backend.h"

extern "C" {
// Provided by the page: takes a message of this many bytes, at once.
__attribute__((import_module("page"), import_name("send"))) void send_to_page(const char* text, std::size_t bytes);
}

namespace {

using namespace selvage;  // NOLINT(google-build-using-namespace)

constexpr std::size_t kSumBytes = std::size_t{64} << 20;
constexpr std::size_t kMarkerBytes = std::size_t{512} << 20;

void send(const std::string& text) {
  if (!text.empty()) send_to_page(text.data(), text.size());
}

server::dispatch::BackendSettings settings() {
  server::dispatch::BackendSettings settings{.cache_bytes = kSumBytes, .on_answered = [](auto&&) {}};
  settings.limits.markers_bytes = kMarkerBytes;
  return settings;
}

}  // namespace

extern "C" {

// Memory for a message, which receive() frees.
__attribute__((export_name("allocate"))) char* allocate(std::size_t bytes) {
  return static_cast<char*>(std::malloc(bytes));
}

__attribute__((export_name("receive"))) void receive(char* text, std::size_t bytes) {
  static server::dispatch::Backend backend{settings()};
  static const auto session = std::make_shared<server::transport::access::Session>(
      server::transport::access::Session{.id = 1, .notify = send, .gone = {}});
  std::string message{text, bytes};
  std::free(text);
  backend.receive(std::move(message), session, send);
}
}
