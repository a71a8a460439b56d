#include "server/transport/connections/websocket_connection.h"

#include <boost/asio/co_spawn.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>

#include <utility>

#include "server/transport/connections/conversation.h"
#include "server/transport/connections/growing_text.h"

namespace selvage::server::transport::connections {
namespace {

namespace asio = boost::asio;
namespace websocket = boost::beast::websocket;
using Error = boost::system::error_code;
using Upgrade = boost::beast::http::request<boost::beast::http::string_body>;

constexpr std::size_t kChunk = 65536;  // bytes per read, so that a long message is seen to progress
constexpr std::chrono::seconds kClosePatience{2};

// The socket below a WebSocket.  When a write continues, the client has taken the bytes before it.
class WatchedSocket {
 public:
  using executor_type = Socket::executor_type;
  using next_layer_type = Socket;
  WatchedSocket(Connection& connection, std::chrono::milliseconds patience)
      : connection_{connection}, patience_{patience} {}

  executor_type get_executor() { return connection_.socket.get_executor(); }
  Socket& next_layer() { return connection_.socket; }
  const Socket& next_layer() const { return connection_.socket; }
  template <class Buffers, class Handler>
  auto async_read_some(const Buffers& buffers, Handler&& handler) {
    return connection_.socket.async_read_some(buffers, std::forward<Handler>(handler));
  }
  template <class Buffers, class Handler>
  auto async_write_some(const Buffers& buffers, Handler&& handler) {
    connection_.extend(connection_.write_watchdog, patience_);
    return connection_.socket.async_write_some(buffers, std::forward<Handler>(handler));
  }

 private:
  Connection& connection_;
  const std::chrono::milliseconds patience_;
};

// Beast finds this function by argument-dependent lookup.
template <class Handler>
void async_teardown(boost::beast::role_type role, WatchedSocket& socket, Handler&& handler) {
  using boost::beast::websocket::async_teardown;
  async_teardown(role, socket.next_layer(), std::forward<Handler>(handler));
}

class WebSocketConnection final : public Conversation {
 public:
  WebSocketConnection(std::shared_ptr<Connection> connection, const ConnectionContext& context)
      : Conversation{std::move(connection), context},
        stream_{*connection_, context.limits.write},
        ping_timer_{connection_->socket.get_executor()} {
    stream_.read_message_max(context_.limits.body_bytes);
    stream_.auto_fragment(false);
    stream_.text(true);
    stream_.control_callback([this](websocket::frame_type kind, auto&&) {
      kind == websocket::frame_type::close ? closed_by_client() : restart_silence_timer();
    });
  }

  asio::awaitable<void> serve(const Upgrade& upgrade) {
    const std::shared_ptr<void> stops_pings{nullptr, [this](void*) { ping_timer_.cancel(); }};
    Error error;
    connection_->arm(connection_->write_watchdog, context_.limits.write);
    co_await stream_.async_accept(upgrade, asio::redirect_error(asio::use_awaitable, error));
    Connection::disarm(connection_->write_watchdog);
    if (error) co_return connection_->cut();
    connection_->on_drain = [weak = weak()] {
      if (const auto self = weak.lock()) self->begin_close(websocket::close_code::going_away);
    };
    // An upgrade request with a wrong token has already been refused.
    const bool unauthenticated =
        connection_->needs_token && upgrade.count(boost::beast::http::field::authorization) == 0;
    if (unauthenticated) connection_->set_standing(Connection::Standing::kSilent);
    if (unauthenticated && !co_await authenticate()) {
      report(access::Refusal::kToken, connection_->session->peer, context_.service);
      begin_close(websocket::close_code::policy_error);
    } else {
      connection_->set_standing(Connection::Standing::kServed);
      enable_notifications();
      ping();
      co_await read_to_end();
    }
    Connection::disarm(connection_->read_watchdog);
    while (closing_ && !closed_) co_await changed_.wait();
    ping_timer_.cancel();  // before the calls in progress are waited for
    connection_->cut();
    co_await settle();
  }

 private:
  std::shared_ptr<WebSocketConnection> self() {
    return std::static_pointer_cast<WebSocketConnection>(shared_from_this());
  }
  std::weak_ptr<WebSocketConnection> weak() { return self(); }

  // The first message must contain the token.
  asio::awaitable<bool> authenticate() {
    boost::beast::flat_buffer message;
    Error error;
    stream_.read_message_max(context_.limits.header_bytes);
    connection_->arm(connection_->read_watchdog, context_.limits.request);
    co_await stream_.async_read(message, asio::redirect_error(asio::use_awaitable, error));
    stream_.read_message_max(context_.limits.body_bytes);
    if (error || closing_ || !context_.service.authenticate) co_return false;
    access::Authentication result = context_.service.authenticate(
        {static_cast<const char*>(message.data().data()), message.size()}, context_.access);
    send(std::move(result.answer));
    co_return result.granted;
  }

  asio::awaitable<void> read_to_end() {
    std::string message;
    memory::HeldBytes held{context_.service.account};  // of the message that has begun
    Error error;
    restart_silence_timer();
    for (;;) {
      make_room(message, kChunk, context_.limits.body_bytes + kChunk);  // Beast may end the program if it cannot
      auto buffer = asio::dynamic_buffer(message);
      co_await stream_.async_read_some(buffer, kChunk, asio::redirect_error(asio::use_awaitable, error));
      if (error) co_return;
      if (closing_) {
        message.clear();
      } else if (stream_.got_binary()) {
        begin_close(websocket::close_code::unknown_data);
      } else if (stream_.is_message_done()) {
        within_message_ = false;
        Connection::disarm(connection_->read_watchdog);
        co_await wait_for_room();
        std::string text = std::exchange(message, {});
        if (!closing_) co_await call(std::move(text));
        held.set(0);
        restart_silence_timer();
      } else {
        if (!std::exchange(within_message_, true)) {
          connection_->arm(connection_->read_watchdog, context_.limits.request);
        }
        held.set(message.size());
        if (message.size() >= waiting::BulkTurns::kLong) co_await context_.turns.next();
        const memory::ByteAccount& account = *context_.service.account;
        const bool room =
            co_await connection_->wait_for_room(account, this->held() + held.bytes(), 1, context_.limits.room);
        if (!room) {
          send(context_.service.no_room);
          begin_close(websocket::close_code::try_again_later);
          held.set(0);
        }
      }
    }
  }

  // Something was received.  A message in progress has its own time limit, which pongs do not extend.
  void restart_silence_timer() {
    if (!within_message_ && !closing_) connection_->arm(connection_->read_watchdog, context_.limits.silence);
  }

  // Stops the calls in progress; the stream answers the close and waits for the connection to end.
  void closed_by_client() {
    connection_->gone.request_stop();
    connection_->arm(connection_->read_watchdog, kClosePatience);
  }

  void ping() {
    ping_timer_.expires_after(context_.limits.ping);
    ping_timer_.async_wait([weak = weak()](Error error) {
      const auto self = weak.lock();
      if (error || !self || self->closing_) return;
      self->attempt([&self] {
        self->stream_.async_ping({}, [self](Error failed) {
          if (!failed) self->attempt([&self] { self->ping(); });
        });
      });
    });
  }

  // Accepts no more calls, answers those in progress, and closes with this code.
  void begin_close(websocket::close_code why) {
    if (std::exchange(closing_, true)) return;
    Connection::disarm(connection_->read_watchdog);
    // Also if the coroutine is destroyed because an exception escaped from a handler.
    std::shared_ptr<void> ended{nullptr, [self = self()](void*) {
                                  self->closed_ = true;
                                  self->changed_.notify();
                                }};
    asio::co_spawn(connection_->socket.get_executor(), close(self(), why), [ended = std::move(ended)](auto&&) {});
  }

  static asio::awaitable<void> close(std::shared_ptr<WebSocketConnection> self, websocket::close_code why) {
    Error ignored;
    co_await self->settle();
    self->connection_->arm(self->connection_->read_watchdog, kClosePatience);
    co_await self->stream_.async_close(why, asio::redirect_error(asio::use_awaitable, ignored));
  }

  std::size_t write(std::deque<std::string>& unsent) override {
    writing_ = std::move(unsent.front());
    unsent.pop_front();
    stream_.async_write(asio::buffer(writing_), [self = self()](Error error, std::size_t) { self->written(error); });
    return writing_.size();
  }

  websocket::stream<WatchedSocket> stream_;
  asio::steady_timer ping_timer_;
  std::string writing_;
  bool within_message_{};
  bool closing_{}, closed_{};
};

}  // namespace

asio::awaitable<void> serve_websocket(std::shared_ptr<Connection> connection, const ConnectionContext& context,
                                      const Upgrade& upgrade) {
  const Counted counted{context.service.counts->websockets};
  const auto websocket = std::make_shared<WebSocketConnection>(std::move(connection), context);
  co_await websocket->serve(upgrade);
}

}  // namespace selvage::server::transport::connections
