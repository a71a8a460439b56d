// Many messages under way at once on one connection: answers in the order they are done, notifications between them.
//
// A connection with too many unanswered calls, or too many unsent bytes, is not read until that is over.  Notifications
// cannot be held back like that: a client that does not take them is cut off at twice the backlog.
// Everything here belongs to the I/O thread.
#pragma once

#include <deque>
#include <memory>
#include <string>

#include "server/transport/connections/connection.h"

namespace selvage::server::transport::connections {

class Conversation : public std::enable_shared_from_this<Conversation> {
 public:
  Conversation(std::shared_ptr<Connection> connection, const ConnectionTerms& terms);
  virtual ~Conversation() = default;
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;

 protected:
  // From now on the service may notify.
  void let_notify();
  // Waits while too much is under way.
  boost::asio::awaitable<void> wait_for_room();
  void call(std::string message);
  // Nothing is sent for an empty text.
  void send(std::string text);
  // Waits until every call is answered and everything is sent.
  boost::asio::awaitable<void> settle();

  // Takes one or more texts from the front of `unsent`, writes them, and then calls written(), never before it returns
  // how many bytes it took.
  virtual std::size_t write(std::deque<std::string>& unsent) = 0;
  void written(boost::system::error_code error);

  const std::shared_ptr<Connection> connection_;
  const ConnectionTerms terms_;
  Signal changed_;  // fewer unanswered calls, or fewer unsent bytes

 private:
  void write_next();
  [[nodiscard]] bool crowded() const;

  std::deque<std::string> unsent_;
  std::size_t unsent_bytes_{};   // in unsent_ and on the way
  std::size_t writing_bytes_{};  // on the way; 0: nothing is
  std::size_t unanswered_{};
};

}  // namespace selvage::server::transport::connections
