// A signal that a coroutine of the I/O thread waits for.
#pragma once

#include <utility>  // before Asio 1.74, which uses std::exchange without it

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/steady_timer.hpp>

namespace selvage::server::transport::waiting {

// A wait may end spuriously: wait in a loop that checks the condition.
class Signal {
 public:
  explicit Signal(const boost::asio::any_io_executor& executor) : timer_{executor} {}

  // Not inline: g++ 12 numbers the fields of a coroutine's frame anew in every source that contains it, which the
  // linker's check of the one-definition rule reports.
  boost::asio::awaitable<void> wait();
  void notify() { timer_.cancel(); }

 private:
  boost::asio::steady_timer timer_;
};

}  // namespace selvage::server::transport::waiting
