#include "server/transport/transport.h"

#include "server/transport/connection.h"

#include <spdlog/spdlog.h>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>

#include <array>
#include <exception>
#include <optional>
#include <set>
#include <string_view>
#include <thread>
#include <utility>

namespace selvage {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using Error = boost::system::error_code;

tcp::endpoint endpoint_of(const std::string& host, std::uint16_t port) {
  return {asio::ip::make_address(host), port};
}

// Reads until a byte that is not blank: that byte and what came with it, or nothing when there is none.
asio::awaitable<std::string> first_bytes(std::shared_ptr<Connection> connection, std::chrono::milliseconds patience) {
  connection->arm(connection->read_watchdog, patience);
  std::array<char, 4096> chunk{};
  Error error;
  std::string_view received;
  while (!error && received.empty()) {
    const std::size_t count = co_await connection->socket.async_read_some(
        asio::buffer(chunk), asio::redirect_error(asio::use_awaitable, error));
    received = {chunk.data(), count};
    received.remove_prefix(std::min(received.find_first_not_of(" \t\r\n"), received.size()));
  }
  Connection::disarm(connection->read_watchdog);
  co_return std::string{received};
}

asio::awaitable<void> serve(std::shared_ptr<Connection> connection, const Service& service,
                            const TransportLimits& limits) {
  connection->watch();
  std::string received = co_await first_bytes(connection, limits.idle);
  if (received.empty()) co_return;
  if (received.front() == '{' || received.front() == '[') {
    co_await serve_lines(connection, service, limits, std::move(received));
  } else {
    co_await serve_http(connection, service, limits, std::move(received));
  }
}

void log_exception(std::string_view where, const std::exception_ptr& thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const std::exception& error) {
    spdlog::error("{} threw: {}", where, error.what());
  } catch (...) {
    spdlog::error("{} threw something that is not an exception", where);
  }
}

}  // namespace

struct Transport::Inside {
  Inside(const std::string& host, std::uint16_t wanted, const TransportLimits& with, Service answering)
      : limits{with}, service{std::move(answering)}, acceptor{io, endpoint_of(host, wanted)}, pause{io}, patience{io} {
    asio::co_spawn(io, accept(), [](const std::exception_ptr& thrown) { log_exception("accepting", thrown); });
    thread = std::jthread{[this] { run(); }};
  }

  // An exception that escapes a handler ends that handler only.
  void run() {
    for (;;) {
      try {
        io.run();
        return;
      } catch (...) {
        log_exception("an I/O handler", std::current_exception());
      }
    }
  }

  asio::awaitable<void> accept() {
    while (acceptor.is_open()) {
      Error error;
      tcp::socket socket = co_await acceptor.async_accept(asio::redirect_error(asio::use_awaitable, error));
      if (error == asio::error::operation_aborted) co_return;
      if (error) {
        spdlog::warn("accepting failed: {}",
                     error.message());  // out of file descriptors: some will come back
        pause.expires_after(std::chrono::milliseconds{100});
        co_await pause.async_wait(asio::redirect_error(asio::use_awaitable, error));
      } else if (connections.size() >= limits.connections) {
        spdlog::warn("a connection was turned away: {} are open", connections.size());
      } else {
        open(std::move(socket));
      }
    }
  }

  void open(tcp::socket socket) {
    const auto connection = std::make_shared<Connection>(std::move(socket), ++sessions);
    connections.insert(connection);
    asio::co_spawn(io, serve(connection, service, limits), [this, connection](const std::exception_ptr& thrown) {
      log_exception("a connection", thrown);
      connection->cut();
      connections.erase(connection);
      end_when_empty();
    });
  }

  void stop_reading() {
    Error ignored;
    acceptor.close(ignored);
    pause.cancel();
    for (const auto& connection : connections) connection->drain();
  }

  void finish(std::chrono::milliseconds time) {
    stop_reading();
    finishing = true;
    patience.expires_after(time);
    patience.async_wait([this](Error error) {
      if (error) return;
      for (const auto& connection : connections) connection->cut();
    });
    end_when_empty();
  }

  void end_when_empty() {
    if (!finishing || !connections.empty()) return;
    patience.cancel();
    work.reset();
  }

  const TransportLimits limits;
  const Service service;
  asio::io_context io{1};
  asio::executor_work_guard<asio::io_context::executor_type> work{io.get_executor()};
  tcp::acceptor acceptor;
  asio::steady_timer pause, patience;
  std::set<std::shared_ptr<Connection>> connections;
  const std::uint16_t port{acceptor.local_endpoint().port()};
  std::uint64_t sessions{};  // begun so far
  bool finishing{};
  std::jthread thread;
};

Transport::Transport(const std::string& host, std::uint16_t port, const TransportLimits& limits, Service service)
    : inside_{std::make_unique<Inside>(host, port, limits, std::move(service))} {}

Transport::~Transport() {
  finish(std::chrono::milliseconds{0});
}

std::uint16_t Transport::port() const {
  return inside_->port;
}

void Transport::stop_reading() {
  asio::post(inside_->io, [inside = inside_.get()] { inside->stop_reading(); });
}

void Transport::finish(std::chrono::milliseconds patience) {
  if (!inside_->thread.joinable()) return;
  asio::post(inside_->io, [inside = inside_.get(), patience] { inside->finish(patience); });
  inside_->thread.join();
}

}  // namespace selvage
