// Newline-delimited JSON on one connection: one message per line.  When the client has half-closed the connection, its
// calls are still answered before the connection closes; only a broken connection stops its calls.
#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "server/transport/connections/conversation.h"
#include "server/transport/connections/line_splitter.h"

namespace selvage::server::transport::connections {
namespace {

namespace asio = boost::asio;
using Error = boost::system::error_code;

// The bytes that are read or written at a time.
constexpr std::size_t kPart = std::size_t{16} << 10;
constexpr std::size_t kKeptBuffer = std::size_t{64} << 10;  // for the next answers; a larger one is freed

class LineConnection final : public Conversation {
 public:
  LineConnection(std::shared_ptr<Connection> connection, const ConnectionContext& context)
      : Conversation{std::move(connection), context},
        splitter_{context.limits.body_bytes},
        held_{context.service.account} {}

  asio::awaitable<void> serve(std::string received) {
    if (connection_->needs_token && !co_await authenticate(received)) {
      report(access::Refusal::kToken, connection_->session->peer, context_.service);
      co_await settle();
      co_return co_await connection_->linger();
    }
    if (connection_->needs_token) connection_->set_standing(Connection::Standing::kServed);
    enable_notifications();
    std::vector<Line> lines = splitter_.feed(received);
    co_await take(std::move(lines));
    co_await read_to_end();
    Connection::disarm(connection_->read_watchdog);
    co_await settle();
  }

 private:
  // The first line must contain the token; the bytes that follow it are left in `received`.
  asio::awaitable<bool> authenticate(std::string& received) {
    std::array<char, 4096> chunk{};
    Error error;
    connection_->arm(connection_->read_watchdog, context_.limits.request);
    while (!error && received.find('\n') == std::string::npos && received.size() < context_.limits.header_bytes) {
      const std::size_t count = co_await connection_->socket.async_read_some(
          asio::buffer(chunk), asio::redirect_error(asio::use_awaitable, error));
      received.append(chunk.data(), count);
    }
    Connection::disarm(connection_->read_watchdog);
    const std::size_t end = received.find('\n');
    if (end == std::string::npos || !context_.service.authenticate) co_return false;
    access::Authentication result =
        context_.service.authenticate(std::string_view{received}.substr(0, end), context_.access);
    received.erase(0, end + 1);
    send(std::move(result.answer));
    co_return result.granted;
  }

  asio::awaitable<void> read_to_end() {
    std::array<char, kPart> chunk{};
    Error error;
    for (;;) {
      if (connection_->draining || !connection_->socket.is_open()) co_return;
      guard_partial_line();
      const std::size_t count = co_await connection_->socket.async_read_some(
          asio::buffer(chunk), asio::redirect_error(asio::use_awaitable, error));
      if (connection_->draining) co_return;
      if (error && error != asio::error::eof) co_return connection_->cut();
      // A named variable, because g++ 12.2 destroys the temporary of a conditional inside a co_await expression twice.
      std::vector<Line> lines = error ? splitter_.finish() : splitter_.feed({chunk.data(), count});
      if (!lines.empty()) stop_guarding();
      co_await take(std::move(lines));
      if (error) co_return;
      co_await make_room();
    }
  }

  // Call this before reading more.  Between lines, it waits until there is room.  A line that has begun is dropped if
  // there is no room in time, so that incomplete lines cannot block each other.
  asio::awaitable<void> make_room() {
    held_.set(splitter_.partial_bytes());
    if (held_.bytes() >= waiting::BulkTurns::kLong) co_await context_.turns.next();
    if (held_.bytes() == 0) {
      co_await wait_for_room();
      co_return;
    }
    const memory::ByteAccount& account = *context_.service.account;
    const bool room = co_await connection_->wait_for_room(account, held() + held_.bytes(), 1, context_.limits.room);
    if (room) co_return;
    splitter_.drop();
    held_.set(0);
    send(context_.service.no_room);
  }

  // A line that has begun must end in time.  Between lines a connection may be silent for hours.
  void guard_partial_line() {
    if (splitter_.within_line() == guarding_) return;
    if (guarding_) return stop_guarding();
    guarding_ = true;
    connection_->arm(connection_->read_watchdog, context_.limits.request);
  }
  // While complete lines wait for room, nothing is read, so that the next line cannot end.
  void stop_guarding() {
    guarding_ = false;
    Connection::disarm(connection_->read_watchdog);
  }

  asio::awaitable<void> take(std::vector<Line> lines) {
    for (Line& line : lines) {
      co_await wait_for_room();
      connection_->set_standing(Connection::Standing::kServed);
      if (line.too_long) {
        send(context_.service.line_too_long);
      } else {
        co_await call(std::move(line.text));
      }
    }
  }

  std::size_t write(std::deque<std::string>& unsent) override {
    writing_.clear();
    std::size_t bytes{};
    std::string_view end{};
    // Short texts are sent together.  A long text is sent by itself, because copying megabytes takes long.
    if (unsent.front().size() > kKeptBuffer) {
      writing_ = std::move(unsent.front());
      unsent.pop_front();
      bytes = writing_.size();
      end = "\n";
    }
    while (end.empty() && !unsent.empty() && bytes + unsent.front().size() <= kKeptBuffer) {
      bytes += unsent.front().size();
      writing_.append(unsent.front()).push_back('\n');
      unsent.pop_front();
    }
    const std::array<asio::const_buffer, 2> written_parts{asio::buffer(writing_), asio::buffer(end)};
    const auto extend = [this](Error error, std::size_t sent) {
      connection_->extend(connection_->write_watchdog, context_.limits.write);
      return std::min(asio::transfer_all()(error, sent), kPart);
    };
    asio::async_write(connection_->socket, written_parts, extend,
                      [this, self = shared_from_this()](Error error, std::size_t) {
                        if (writing_.capacity() > kKeptBuffer) std::string{}.swap(writing_);
                        written(error);
                      });
    return bytes;
  }

  LineSplitter splitter_;
  memory::HeldBytes held_;  // of the line that has begun
  std::string writing_;
  bool guarding_{};
};

}  // namespace

asio::awaitable<void> serve_lines(std::shared_ptr<Connection> connection, const ConnectionContext& context,
                                  std::string received) {
  const Counted counted{context.service.counts->lines};
  const auto lines = std::make_shared<LineConnection>(std::move(connection), context);
  co_await lines->serve(std::move(received));
}

}  // namespace selvage::server::transport::connections
