#include "server/transport/waiting/signal.h"

#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>

#include <chrono>

namespace selvage::server::transport::waiting {

boost::asio::awaitable<void> Signal::wait() {
  boost::system::error_code ignored;
  timer_.expires_at(std::chrono::steady_clock::time_point::max());
  co_await timer_.async_wait(boost::asio::redirect_error(boost::asio::use_awaitable, ignored));
}

}  // namespace selvage::server::transport::waiting
