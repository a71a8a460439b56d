#include "server/transport/waiting/bulk_turns.h"

namespace selvage::server::transport::waiting {

struct BulkTurns::Waiting {
  explicit Waiting(boost::asio::io_context& io) : turn{io.get_executor()} {}
  Signal turn;
  bool given{};
};

boost::asio::awaitable<void> BulkTurns::next() {
  const auto waiting = std::make_shared<Waiting>(io_);
  waiting_.push_back(waiting);
  while (!waiting->given) co_await waiting->turn.wait();
}

void BulkTurns::run() {
  for (;;) {
    if (waiting_.empty()) {
      if (io_.run_one() == 0) return;
      continue;
    }
    std::size_t others = 0;
    while (others < kOthers && io_.poll_one() > 0) ++others;
    give();
  }
}

void BulkTurns::give() {
  const auto first = waiting_.front().lock();
  waiting_.pop_front();
  if (!first) return;
  first->given = true;
  first->turn.notify();
}

}  // namespace selvage::server::transport::waiting
