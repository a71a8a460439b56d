#include "server/transport/tls.h"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/local/connect_pair.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/asio/write.hpp>

#include <array>
#include <exception>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace selvage::server::transport {
namespace {

namespace asio = boost::asio;
namespace ssl = asio::ssl;
using Error = boost::system::error_code;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kClosePatience{2};

ssl::context make_context(const access::TlsFiles& files) {
  ssl::context context{ssl::context::tls_server};
  Error error;
  context.set_options(ssl::context::default_workarounds | ssl::context::no_tlsv1 | ssl::context::no_tlsv1_1 |
                      ssl::context::no_compression);
  context.use_certificate_chain_file(files.certificate, error);
  if (error) throw std::runtime_error{"TLS certificate " + files.certificate + ": " + error.message()};
  context.use_private_key_file(files.key, ssl::context::pem, error);
  if (error) throw std::runtime_error{"TLS key " + files.key + ": " + error.message()};
  return context;
}

// One connection, with its encrypted and its plain side.
class Tunnel : public std::enable_shared_from_this<Tunnel> {
 public:
  Tunnel(connections::Socket outside, connections::Socket inside, ssl::context& context,
         std::chrono::milliseconds patience)
      : outside_{std::move(outside), context},
        inside_{std::move(inside)},
        watchdog_{inside_.get_executor()},
        patience_{patience} {}

  // Runs until both directions have ended.
  static asio::awaitable<void> run(std::shared_ptr<Tunnel> self) {
    Error error;
    self->arm(self->patience_);
    self->watch_inside();
    co_await self->outside_.async_handshake(ssl::stream_base::server, asio::redirect_error(asio::use_awaitable, error));
    self->disarm();
    if (error) co_return self->cut();
    self->open_ = true;
    self->watch();
    asio::co_spawn(self->inside_.get_executor(), inwards(self), [self](const std::exception_ptr& thrown) {
      if (thrown) self->cut();
    });
    co_await self->outwards();
    self->cut();
  }

  void cut() {
    Error ignored;
    outside_.lowest_layer().close(ignored);
    inside_.close(ignored);
    watchdog_.cancel();
  }

 private:
  static asio::awaitable<void> inwards(std::shared_ptr<Tunnel> self) {
    std::array<char, 16384> chunk{};
    Error error;
    while (!error) {
      const std::size_t count = co_await self->outside_.async_read_some(
          asio::buffer(chunk), asio::redirect_error(asio::use_awaitable, error));
      if (error) break;
      co_await asio::async_write(self->inside_, asio::buffer(chunk.data(), count),
                                 asio::redirect_error(asio::use_awaitable, error));
    }
    Error ignored;
    // Without close_notify, anybody may have ended the connection, so it counts as broken.
    if (error == asio::error::eof) {
      self->inside_.shutdown(connections::Socket::shutdown_send, ignored);
    } else {
      self->cut();
    }
  }

  asio::awaitable<void> outwards() {
    std::array<char, 16384> chunk{};
    Error error;
    while (!error) {
      const std::size_t count =
          co_await inside_.async_read_some(asio::buffer(chunk), asio::redirect_error(asio::use_awaitable, error));
      if (error) break;
      arm(patience_);
      co_await asio::async_write(outside_, asio::buffer(chunk.data(), count),
                                 asio::redirect_error(asio::use_awaitable, error));
      disarm();
    }
    if (error != asio::error::eof) co_return;
    arm(kClosePatience);
    co_await outside_.async_shutdown(asio::redirect_error(asio::use_awaitable, error));
  }

  // Ends the handshake if the plain side has closed the connection; nothing else arrives from there at this stage.
  void watch_inside() {
    inside_.async_wait(connections::Socket::wait_read, [self = shared_from_this()](Error error) {
      if (!error && !self->open_) self->cut();
    });
  }

  // Detects a broken connection while nothing is read from it.
  void watch() {
    outside_.lowest_layer().async_wait(connections::Socket::wait_error, [self = shared_from_this()](Error error) {
      if (!error) self->cut();
    });
  }

  void arm(std::chrono::milliseconds patience) {
    watchdog_.expires_after(patience);
    watchdog_.async_wait([self = shared_from_this()](Error error) {
      if (!error && self->watchdog_.expiry() <= Clock::now()) self->cut();
    });
  }
  void disarm() { watchdog_.expires_at(Clock::time_point::max()); }

  ssl::stream<connections::Socket> outside_;
  connections::Socket inside_;
  asio::steady_timer watchdog_;
  const std::chrono::milliseconds patience_;
  bool open_{};  // the handshake has succeeded
};

}  // namespace

struct Tls::Credentials {
  ssl::context context;
};

struct Tls::Implementation {
  std::shared_ptr<Credentials> credentials;
  const std::chrono::milliseconds patience;
  const std::function<void()> on_ended;
  std::set<std::shared_ptr<Tunnel>> tunnels{};
};

std::shared_ptr<Tls::Credentials> Tls::load(const access::TlsFiles& files) {
  return std::make_shared<Credentials>(Credentials{make_context(files)});
}

Tls::Tls(std::shared_ptr<Credentials> credentials, const access::TransportLimits& limits,
         std::function<void()> on_ended)
    : implementation_{std::make_shared<Implementation>(
          Implementation{std::move(credentials), limits.write, std::move(on_ended)})} {}

Tls::~Tls() = default;

connections::Socket Tls::unwrap(connections::Socket outside) {
  const auto executor = outside.get_executor();
  asio::local::stream_protocol::socket mine{executor};
  asio::local::stream_protocol::socket theirs{executor};
  asio::local::connect_pair(mine, theirs);
  const auto tunnel = std::make_shared<Tunnel>(std::move(outside), std::move(mine),
                                               implementation_->credentials->context, implementation_->patience);
  implementation_->tunnels.insert(tunnel);
  // Also if the coroutine is destroyed because an exception escaped from a handler.
  std::shared_ptr<void> ended{nullptr, [weak = std::weak_ptr{implementation_}, tunnel](void*) {
                                tunnel->cut();
                                const auto state = weak.lock();
                                if (!state) return;
                                state->tunnels.erase(tunnel);
                                state->on_ended();
                              }};
  asio::co_spawn(executor, Tunnel::run(tunnel), [held = std::move(ended)](auto&&) {});
  return theirs;
}

void Tls::use(std::shared_ptr<Credentials> credentials) {
  implementation_->credentials = std::move(credentials);  // tunnels keep their old ones
}

bool Tls::idle() const {
  return implementation_->tunnels.empty();
}

void Tls::cut() {
  for (const auto& tunnel : implementation_->tunnels) tunnel->cut();
}

}  // namespace selvage::server::transport
