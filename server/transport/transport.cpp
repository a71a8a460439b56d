#include "server/transport/transport.h"

#include "server/jobs/prompt_thread.h"
#include "server/transport/acceptor.h"
#include "server/transport/connection_table.h"
#include "server/transport/connections/connection.h"
#include "server/transport/peer.h"
#include "server/transport/tls.h"

#include <spdlog/spdlog.h>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>

#include <algorithm>
#include <array>
#include <deque>
#include <exception>
#include <memory>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace selvage::server::transport {
namespace {

namespace asio = boost::asio;
using Error = boost::system::error_code;

// Reads until a byte that is not blank.  Returns the text from that byte on, or nothing if there is no such byte.
asio::awaitable<std::string> first_bytes(std::shared_ptr<connections::Connection> connection,
                                         std::chrono::milliseconds patience) {
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
  connections::Connection::disarm(connection->read_watchdog);
  co_return std::string{received};
}

asio::awaitable<void> serve(std::shared_ptr<connections::Connection> connection,
                            const connections::ConnectionContext& context, access::Listener::Speaks speaks) {
  connection->watch();
  std::string received = co_await first_bytes(connection, context.limits.idle);
  if (received.empty()) co_return;
  const bool json = received.front() == '{' || received.front() == '[';
  if (speaks == access::Listener::Speaks::kLines && !json && !connection->needs_token) {
    // A page can make a browser send an HTTP request here, whose body would contain lines of JSON.  With a token such a
    // request fails to authenticate.
    connections::report(access::Refusal::kNotJson, connection->session->peer, context.service);
    co_return;
  }
  const bool lines = speaks == access::Listener::Speaks::kLines || (speaks == access::Listener::Speaks::kHttp && json);
  if (lines) {
    co_await serve_lines(connection, context, std::move(received));
  } else {
    co_await serve_http(connection, context, std::move(received));
  }
}

// Health probes are small and quick, so their limits are low.
access::TransportLimits limits_for_health(access::TransportLimits limits) {
  constexpr std::chrono::seconds kPatience{5};
  limits.body_bytes = 1024;
  limits.idle = limits.request = limits.write = kPatience;
  return limits;
}

void log_exception(std::string_view where, const std::exception_ptr& thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const std::exception& error) {
    spdlog::error("{} threw an exception: {}", where, error.what());
  } catch (...) {
    spdlog::error("{} threw something that is not a std::exception", where);
  }
}

}  // namespace

struct Transport::Implementation {
  Implementation(const access::ListenSettings& settings, const access::TransportLimits& with, access::Service answering)
      : limits{with}, service{std::move(answering)}, access{settings.access} {
    if (settings.tls) tls.emplace(Tls::load(*settings.tls), limits, [this] { end_when_empty(); });
    for (const access::Listener& listener : settings.listeners) {
      acceptors.push_back(std::make_unique<Acceptor>(io, listener));
      listeners.push_back(acceptors.back()->listener());
    }
    for (const auto& acceptor : acceptors) {
      asio::co_spawn(io, accept(*acceptor),
                     [](const std::exception_ptr& thrown) { log_exception("accepting", thrown); });
    }
    thread = std::jthread{[this] { run(); }};
  }

  // An exception that escapes a handler ends that handler only.
  void run() {
    jobs::run_promptly(jobs::Promptness::kFirst);
    for (;;) {
      try {
        turns.run();
        return;
      } catch (...) {
        log_exception("an I/O handler", std::current_exception());
      }
    }
  }

  asio::awaitable<void> accept(Acceptor& acceptor) {
    while (acceptor.is_open()) {
      Error error;
      connections::Socket socket = co_await acceptor.accept(error);
      if (error == asio::error::operation_aborted) co_return;
      if (error) {
        spdlog::warn("accepting failed: {}", error.message());
        co_await acceptor.pause();
      } else {
        try {
          take(std::move(socket), acceptor.listener());
        } catch (...) {  // that connection is closed; the next one may be served
          log_exception("a new connection", std::current_exception());
        }
      }
    }
  }

  // Opens the connection if there is room for it.
  void take(connections::Socket socket, const access::Listener& listener) {
    const Peer peer = peer_of(socket, listener);
    if (listener.speaks == access::Listener::Speaks::kHealth) return open_for_health(std::move(socket), peer);
    const auto refusal = connections.make_room(peer.address, [this](const ConnectionTable::Entry& closed) {
      connections::report(access::Refusal::kSilent, closed->session->peer, service);
    });
    if (refusal) {
      ++service.counts->turned_away;
      return connections::report(*refusal, peer.text, service);
    }
    ++service.counts->accepted;
    const bool tcp = listener.path.empty();
    Error ignored;
    if (tcp) socket.set_option(asio::ip::tcp::no_delay{true}, ignored);
    if (tcp && tls) socket = tls->unwrap(std::move(socket));
    const auto connection = std::make_shared<connections::Connection>(std::move(socket), ++sessions, peer.text,
                                                                      tcp && !access.token.empty(), service.account);
    connections.insert(connection, peer.address);
    spawn(connection, context, listener.speaks, [this, connection] { connections.erase(connection); });
  }

  // Serves the connection until it ends, then calls `forget`; also if an exception escapes from the handler for which
  // the coroutine waits, which then ends without a result.
  template <class Forget>
  void spawn(const ConnectionTable::Entry& connection, const connections::ConnectionContext& with,
             access::Listener::Speaks speaks, const Forget& forget) {
    std::shared_ptr<void> ended{nullptr, [this, connection, forget](void*) {
                                  connection->cut();
                                  forget();
                                  end_when_empty();
                                }};
    asio::co_spawn(io, serve(connection, with, speaks), [held = std::move(ended)](const std::exception_ptr& thrown) {
      log_exception("a connection", thrown);
    });
  }

  // The oldest connection for health checks makes room for a further one.
  void open_for_health(connections::Socket socket, const Peer& peer) {
    if (health.size() >= limits.health_connections) {
      health.front()->cut();
      health.pop_front();
    }
    const auto connection = std::make_shared<connections::Connection>(std::move(socket), ++sessions, peer.text, false);
    health.push_back(connection);
    spawn(connection, health_context, access::Listener::Speaks::kHealth,
          [this, connection] { std::erase(health, connection); });
  }

  void stop_reading() {
    for (const auto& acceptor : acceptors) acceptor->close();
    for (const auto& [connection, address] : connections) connection->drain();
    for (const auto& connection : health) connection->drain();
  }

  void finish(std::chrono::milliseconds time) {
    stop_reading();
    finishing = true;
    patience.expires_after(time);
    patience.async_wait([this](Error error) {
      if (error) return;
      for (const auto& [connection, address] : connections) connection->cut();
      for (const auto& connection : health) connection->cut();
      if (tls) tls->cut();
    });
    end_when_empty();
  }

  void end_when_empty() {
    if (!finishing || connections.size() != 0 || !health.empty() || (tls && !tls->idle())) return;
    patience.cancel();
    work.reset();
  }

  const access::TransportLimits limits;
  const access::Service service;
  access::Access access;  // the I/O thread's
  asio::io_context io{1};
  waiting::BulkTurns turns{io};
  const connections::ConnectionContext context{service, limits, access, turns};
  const access::TransportLimits health_limits = limits_for_health(limits);
  const access::Service health_service{
      .call = {}, .health = service.health, .ready = service.ready, .counts = service.counts};
  const access::Access access_to_health{.any_host = true};
  const connections::ConnectionContext health_context{health_service, health_limits, access_to_health, turns};
  asio::executor_work_guard<asio::io_context::executor_type> work{io.get_executor()};
  asio::steady_timer patience{io};
  std::optional<Tls> tls;
  std::vector<std::unique_ptr<Acceptor>> acceptors;
  std::vector<access::Listener> listeners;
  ConnectionTable connections{limits};
  std::deque<ConnectionTable::Entry> health;  // the oldest first
  std::uint64_t sessions{};                   // begun so far
  bool finishing{};
  std::jthread thread;
};

Transport::Transport(const access::ListenSettings& settings, const access::TransportLimits& limits,
                     access::Service service)
    : implementation_{std::make_unique<Implementation>(settings, limits, std::move(service))} {}

Transport::~Transport() {
  finish(std::chrono::milliseconds{0});
}

const std::vector<access::Listener>& Transport::listeners() const {
  return implementation_->listeners;
}

void Transport::reload(const std::string& token, const std::optional<access::TlsFiles>& tls) {
  std::shared_ptr<Tls::Credentials> credentials = tls ? Tls::load(*tls) : nullptr;
  asio::post(implementation_->io, [implementation = implementation_.get(), token, held = std::move(credentials)] {
    implementation->access.token = token;
    if (held && implementation->tls) implementation->tls->use(held);
  });
}

void Transport::stop_reading() {
  asio::post(implementation_->io, [implementation = implementation_.get()] { implementation->stop_reading(); });
}

void Transport::finish(std::chrono::milliseconds time) {
  if (!implementation_->thread.joinable()) return;
  asio::post(implementation_->io, [implementation = implementation_.get(), time] { implementation->finish(time); });
  implementation_->thread.join();
}

}  // namespace selvage::server::transport
