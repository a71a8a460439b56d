// Turns for the work on long messages, which waits while the I/O thread has anything else to do.
//
// A long message is read and weighed part by part, and each part waits for a turn.  So a short message waits for at
// most one part of one long message, however many clients send long ones.
#pragma once

#include "server/transport/waiting/signal.h"

#include <boost/asio/io_context.hpp>

#include <cstddef>
#include <deque>
#include <memory>

namespace selvage::server::transport::waiting {

// Everything here belongs to the I/O thread.
class BulkTurns {
 public:
  // A message is long if this many of its bytes have arrived and more are to come.
  static constexpr std::size_t kLong = std::size_t{16} << 10;
  // Bulk work waits for at most this many other handlers, so that short messages cannot keep it from being done.
  static constexpr std::size_t kOthers = 64;

  explicit BulkTurns(boost::asio::io_context& io) : io_{io} {}
  BulkTurns(const BulkTurns&) = delete;
  BulkTurns& operator=(const BulkTurns&) = delete;

  // Waits for a turn.  Turns are given in the order in which they were asked for.
  boost::asio::awaitable<void> next();
  // Executes handlers, as io_context::run() does, and gives the turns; returns when there is no work left, or when a
  // handler throws an exception.
  void run();

 private:
  struct Waiting;
  void give();

  boost::asio::io_context& io_;
  std::deque<std::weak_ptr<Waiting>> waiting_;  // in order; expired: its coroutine has been destroyed
};

}  // namespace selvage::server::transport::waiting
