// Work that another thread gives to the I/O thread.
#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/post.hpp>
#include <chrono>
#include <utility>

#include "server/jobs/prompt_thread.h"

namespace selvage::server::transport::connections {

// From any thread.
template <class Work>
void hand_over(const boost::asio::any_io_executor& io, Work work) {
  using std::chrono::steady_clock;
  boost::asio::post(io, [given = steady_clock::now(), held = std::move(work)]() mutable {
    jobs::woke_up_after(steady_clock::now() - given);
    held();
  });
}

}  // namespace selvage::server::transport::connections
