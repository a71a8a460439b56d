// A connection with many calls in progress: answers are sent in the order of completion, with notifications in between.
//
// A connection is not read while it has too many unanswered calls, too many bytes of unanswered calls, or too many
// unsent bytes, until there are fewer.  No connection is read while all connections together have too many bytes.
// Notifications cannot be held back in this way: a client that does not receive them is disconnected when it reaches
// twice the limit of unsent bytes, or as soon as all connections together have too many.  Everything here belongs to
// the I/O thread.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "server/transport/connections/connection.h"

namespace selvage::server::transport::connections {

class Conversation : public std::enable_shared_from_this<Conversation> {
 public:
  Conversation(std::shared_ptr<Connection> connection, const ConnectionContext& context);
  virtual ~Conversation() = default;
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;

 protected:
  // Allows the service to send notifications from now on.
  void enable_notifications();
  // Waits while too many calls are unanswered or too many bytes unsent, here or on all connections together.
  boost::asio::awaitable<void> wait_for_room();
  // Passes the message on to the service as soon as there is room for answering it.  If there is none in time, answers
  // it with an error.
  boost::asio::awaitable<void> call(std::string message);
  // An empty text is not sent.
  void send(std::string text);
  // The bytes of unanswered calls and of unsent texts.
  [[nodiscard]] std::size_t held() const { return held_requests_.bytes() + held_answers_.bytes(); }
  // Waits until every call is answered and everything is sent.
  boost::asio::awaitable<void> settle();
  // Runs a handler.  If it throws an exception, such as std::bad_alloc, the connection is closed, because an answer may
  // be lost for which the client would wait.
  void attempt(const std::function<void()>& work);

  // Takes one or more texts from the front of `unsent`, writes them and returns their number of bytes; calls written()
  // when that is done, but never before it has returned.
  virtual std::size_t write(std::deque<std::string>& unsent) = 0;
  void written(boost::system::error_code error);

  const std::shared_ptr<Connection> connection_;
  const ConnectionContext context_;
  waiting::Signal changed_;  // fewer unanswered calls, or fewer unsent bytes

 private:
  void write_next();
  [[nodiscard]] bool crowded() const;

  std::deque<std::string> unsent_;
  std::size_t unsent_bytes_{};   // in unsent_ and being written
  std::size_t writing_bytes_{};  // being written; 0: none
  std::size_t unanswered_{};
  memory::HeldBytes held_requests_;  // of the unanswered calls
  memory::HeldBytes held_answers_;   // the unsent bytes
};

}  // namespace selvage::server::transport::connections
