// Newline-delimited JSON on one connection: a message per line, many under way at once, answers in the order
// they are done.  When the other side has sent its last (half-closed), what it asked is still answered before
// the connection closes; only a connection that breaks stops its calls.
#include "server/transport/connection.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "server/transport/line_splitter.h"

namespace selvage {
namespace {

namespace asio = boost::asio;
using Error = boost::system::error_code;

class LineConnection : public std::enable_shared_from_this<LineConnection> {
 public:
  LineConnection(std::shared_ptr<Connection> connection, const Service& service, const TransportLimits& limits)
      : connection_{std::move(connection)},
        service_{service},
        limits_{limits},
        splitter_{limits.body_bytes},
        changed_{connection_->socket.get_executor()} {}

  asio::awaitable<void> serve(std::string received) {
    let_notify();
    std::vector<Line> lines = splitter_.feed(received);
    co_await take(std::move(lines));
    co_await read_to_end();
    Connection::disarm(connection_->read_watchdog);
    while (!settled()) co_await changed_.wait();
  }

 private:
  asio::awaitable<void> read_to_end() {
    std::array<char, 65536> chunk{};
    Error error;
    for (;;) {
      if (connection_->draining || !connection_->socket.is_open()) co_return;
      guard_partial_line();
      const std::size_t count = co_await connection_->socket.async_read_some(
          asio::buffer(chunk), asio::redirect_error(asio::use_awaitable, error));
      if (connection_->draining) co_return;
      if (error && error != asio::error::eof) co_return connection_->cut();
      // Named: g++ 12.2 destroys twice a temporary of a conditional inside a co_await expression.
      std::vector<Line> lines = error ? splitter_.finish() : splitter_.feed({chunk.data(), count});
      co_await take(std::move(lines));
      if (error) co_return;
    }
  }

  // A client that does not take its notifications is cut off: unlike answers, they cannot be held back by not reading.
  void let_notify() {
    const auto executor = connection_->socket.get_executor();
    connection_->session->notify = [executor, weak = weak_from_this()](std::string message) {
      asio::post(executor, [weak, held = std::move(message)] {
        const auto self = weak.lock();
        if (!self) return;
        self->send(held);
        if (self->writing_.size() + self->outbox_.size() > 2 * self->limits_.backlog_bytes) self->connection_->cut();
      });
    };
  }

  // A line that has begun must end in time; between lines there is no hurry: a front end stays for hours.
  void guard_partial_line() {
    if (splitter_.within_line() == guarding_) return;
    guarding_ = !guarding_;
    if (guarding_) {
      connection_->arm(connection_->read_watchdog, limits_.request);
    } else {
      Connection::disarm(connection_->read_watchdog);
    }
  }

  // Waits while too much is under way: the other side is not read until it has taken its answers.
  asio::awaitable<void> take(std::vector<Line> lines) {
    for (Line& line : lines) {
      while (crowded()) co_await changed_.wait();
      if (line.too_long) {
        send(service_.line_too_long);
      } else {
        call(std::move(line.text));
      }
    }
  }

  void call(std::string message) {
    ++unanswered_;
    const auto executor = connection_->socket.get_executor();
    Reply reply = [executor, self = shared_from_this()](std::string answer) {
      asio::post(executor, [self, held = std::move(answer)] {
        --self->unanswered_;
        self->send(held);
        self->changed_.notify();
      });
    };
    service_.call(std::move(message), connection_->session, std::move(reply));
  }

  void send(const std::string& answer) {
    if (answer.empty() || !connection_->socket.is_open()) return;
    outbox_ += answer;
    outbox_ += '\n';
    if (writing_.empty()) write();
  }

  void write() {
    writing_.swap(outbox_);
    connection_->arm(connection_->write_watchdog, limits_.write);
    asio::async_write(connection_->socket, asio::buffer(writing_),
                      [self = shared_from_this()](Error error, std::size_t) { self->written(error); });
  }

  void written(Error error) {
    Connection::disarm(connection_->write_watchdog);
    writing_.clear();
    if (error) {
      outbox_.clear();
      connection_->cut();
    }
    if (!outbox_.empty()) write();
    changed_.notify();
  }

  [[nodiscard]] bool crowded() const {
    return unanswered_ >= limits_.calls_per_connection || writing_.size() + outbox_.size() >= limits_.backlog_bytes;
  }
  [[nodiscard]] bool settled() const { return unanswered_ == 0 && writing_.empty() && outbox_.empty(); }

  std::shared_ptr<Connection> connection_;
  const Service& service_;
  const TransportLimits& limits_;
  LineSplitter splitter_;
  Signal changed_;  // fewer unanswered calls, or fewer unsent bytes
  std::size_t unanswered_{};
  std::string outbox_, writing_;
  bool guarding_{};
};

}  // namespace

asio::awaitable<void> serve_lines(std::shared_ptr<Connection> connection, const Service& service,
                                  const TransportLimits& limits, std::string received) {
  const auto lines = std::make_shared<LineConnection>(std::move(connection), service, limits);
  co_await lines->serve(std::move(received));
}

}  // namespace selvage
