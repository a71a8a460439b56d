#include "server/transport/connections/connection.h"

#include <boost/asio/buffer.hpp>

#include <array>
#include <cstddef>

namespace selvage::server::transport::connections {

using Clock = std::chrono::steady_clock;

void report(access::Refusal refusal, const std::string& peer, const access::Service& service) {
  ++service.counts->refused.at(static_cast<std::size_t>(refusal));
  if (service.on_refused) service.on_refused(refusal, peer);
}

Connection::Connection(Socket connected, std::uint64_t id, std::string peer, bool requires_token,
                       std::shared_ptr<memory::ByteAccount> account)
    : socket{std::move(connected)},
      read_watchdog{socket.get_executor()},
      write_watchdog{socket.get_executor()},
      session{std::make_shared<access::Session>(access::Session{
          .id = id, .notify = {}, .gone = gone.get_token(), .peer = std::move(peer), .account = std::move(account)})},
      needs_token{requires_token} {}

void Connection::watch() {
  socket.async_wait(Socket::wait_error, [self = shared_from_this()](boost::system::error_code error) {
    if (!error) self->gone.request_stop();
  });
}

void Connection::watch_for_end() {
  if (std::exchange(watching_for_end_, true)) return;
  socket.async_wait(Socket::wait_read, [self = shared_from_this()](boost::system::error_code error) {
    self->watching_for_end_ = false;
    if (error || self->draining) return;
    char next{};
    boost::system::error_code state;
    self->socket.non_blocking(true, state);
    self->socket.receive(boost::asio::buffer(&next, 1), Socket::message_peek, state);
    // If there are bytes to read, they belong to the next request, which was sent early.
    if (state && state != boost::asio::error::would_block) self->gone.request_stop();
  });
}

void Connection::arm(boost::asio::steady_timer& watchdog, std::chrono::milliseconds time) {
  watchdog.expires_after(time);
  watchdog.async_wait([self = shared_from_this(), &watchdog](boost::system::error_code error) {
    if (!error && watchdog.expiry() <= Clock::now()) self->cut();
  });
}

void Connection::disarm(boost::asio::steady_timer& watchdog) {
  watchdog.expires_at(Clock::time_point::max());
}

void Connection::extend(boost::asio::steady_timer& watchdog, std::chrono::milliseconds time) {
  const Time expiry = watchdog.expiry();
  if (expiry != Time{} && expiry != Time::max()) arm(watchdog, time);  // that is, neither new nor disarmed
}

void Connection::set_standing(Standing standing) {
  if (std::exchange(standing_, standing) != standing) standing_since_ = Clock::now();
}

boost::asio::awaitable<bool> Connection::wait_for_room(const memory::ByteAccount& account, std::size_t held,
                                                       std::size_t bytes, std::chrono::milliseconds time) {
  constexpr std::chrono::milliseconds kPoll{10};  // polls, because this is rare and other threads make room, too
  constexpr std::size_t kModest = std::size_t{256} << 10;
  const std::size_t needed = held + bytes <= kModest ? bytes : account.beside_reserve(bytes);
  boost::asio::steady_timer timer{socket.get_executor()};
  boost::system::error_code ignored;
  for (const Time end = Clock::now() + time; !account.has_room(needed);) {
    if (needed > account.limit() || Clock::now() >= end || draining || !socket.is_open()) co_return false;
    timer.expires_after(kPoll);
    co_await timer.async_wait(boost::asio::redirect_error(boost::asio::use_awaitable, ignored));
  }
  co_return true;
}

boost::asio::awaitable<std::size_t> Connection::weigh(const ConnectionContext& context, std::string_view message) {
  constexpr std::size_t kPart = std::size_t{64} << 10;  // takes some hundredths of a millisecond
  const auto& weight_of = context.service.weigh;
  std::size_t weight{};
  if (!weight_of) co_return weight;
  while (message.size() > kPart) {
    weight += weight_of(message.substr(0, kPart));
    message.remove_prefix(kPart);
    co_await context.turns.next();
  }
  co_return weight + weight_of(message);
}

void Connection::drain() {
  draining = true;
  if (on_drain) return on_drain();
  boost::system::error_code ignored;
  socket.shutdown(Socket::shutdown_receive,
                  ignored);  // a pending read ends as if the client had closed
}

void Connection::cut() {
  gone.request_stop();
  boost::system::error_code ignored;
  socket.close(ignored);
  read_watchdog.cancel();
  write_watchdog.cancel();
}

boost::asio::awaitable<void> Connection::linger() {
  constexpr std::chrono::seconds kPatience{2};
  boost::system::error_code error;
  socket.shutdown(Socket::shutdown_send, error);
  arm(read_watchdog, kPatience);
  std::array<char, 16384> dropped{};
  while (!error && !draining) {
    co_await socket.async_read_some(boost::asio::buffer(dropped),
                                    boost::asio::redirect_error(boost::asio::use_awaitable, error));
  }
}

}  // namespace selvage::server::transport::connections
