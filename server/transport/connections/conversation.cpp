#include "server/transport/connections/conversation.h"

#include <spdlog/spdlog.h>

#include <exception>
#include <utility>

#include "server/transport/connections/hand_over.h"

namespace selvage::server::transport::connections {

namespace asio = boost::asio;

namespace {

constexpr std::size_t kBehind = std::size_t{64} << 10;  // unsent bytes at which a client counts as too slow

}  // namespace

Conversation::Conversation(std::shared_ptr<Connection> connection, const ConnectionContext& context)
    : connection_{std::move(connection)},
      context_{context},
      changed_{connection_->socket.get_executor()},
      held_requests_{context.service.account},
      held_answers_{context.service.account} {}

void Conversation::enable_notifications() {
  const auto executor = connection_->socket.get_executor();
  connection_->session->notify = [executor, weak = weak_from_this()](std::string message) {
    hand_over(executor, [weak, held = std::move(message)]() mutable {
      const auto self = weak.lock();
      if (!self) return;
      self->attempt([&] {
        const bool behind = self->unsent_bytes_ > kBehind && !self->context_.service.account->has_room(held.size());
        self->send(std::move(held));
        if (behind || self->unsent_bytes_ > 2 * self->context_.limits.backlog_bytes) self->connection_->cut();
      });
    });
  };
}

asio::awaitable<void> Conversation::wait_for_room() {
  constexpr std::chrono::seconds kAtATime{1};  // so that a connection that has ended, or drains, is seen
  while (crowded()) co_await changed_.wait();
  bool room = false;
  while (!room && connection_->socket.is_open() && !connection_->draining) {
    room = co_await connection_->wait_for_room(*context_.service.account, held(), 1, kAtATime);
  }
}

asio::awaitable<void> Conversation::call(std::string message) {
  const access::Service& service = context_.service;
  const std::size_t weight = co_await Connection::weigh(context_, message);
  if (weight > 0 &&
      !co_await connection_->wait_for_room(*service.account, held() + message.size(), weight, context_.limits.room)) {
    co_return send(service.no_room);
  }
  ++unanswered_;
  const std::size_t bytes = message.size() + weight;
  held_requests_.add(bytes);
  const auto executor = connection_->socket.get_executor();
  access::Reply reply = [executor, self = shared_from_this(), bytes](std::string answer) {
    hand_over(executor, [self, bytes, held = std::move(answer)]() mutable {
      --self->unanswered_;
      self->held_requests_.remove(bytes);
      self->attempt([&] { self->send(std::move(held)); });
      self->changed_.notify();
    });
  };
  service.call(std::move(message), connection_->session, std::move(reply));
}

void Conversation::send(std::string text) {
  if (text.empty() || !connection_->socket.is_open()) return;
  unsent_bytes_ += text.size();
  held_answers_.set(unsent_bytes_);
  unsent_.push_back(std::move(text));
  if (writing_bytes_ == 0) write_next();
}

asio::awaitable<void> Conversation::settle() {
  while (unanswered_ != 0 || unsent_bytes_ != 0) co_await changed_.wait();
}

void Conversation::attempt(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& error) {
    spdlog::error("closing a connection because a handler threw an exception: {}", error.what());
    unsent_.clear();
    unsent_bytes_ = writing_bytes_;  // what is being written ends with an error
    held_answers_.set(unsent_bytes_);
    connection_->cut();
    changed_.notify();
  }
}

void Conversation::write_next() {
  connection_->arm(connection_->write_watchdog, context_.limits.write);
  writing_bytes_ = write(unsent_);
}

void Conversation::written(boost::system::error_code error) {
  Connection::disarm(connection_->write_watchdog);
  unsent_bytes_ -= std::exchange(writing_bytes_, 0);
  if (error) {
    unsent_.clear();
    unsent_bytes_ = 0;
    connection_->cut();
  }
  held_answers_.set(unsent_bytes_);
  attempt([this] {
    if (!unsent_.empty()) write_next();
  });
  changed_.notify();
}

bool Conversation::crowded() const {
  return unanswered_ >= context_.limits.calls_per_connection ||
         held_requests_.bytes() >= context_.limits.request_bytes || unsent_bytes_ >= context_.limits.backlog_bytes;
}

}  // namespace selvage::server::transport::connections
