#include "server/dispatch/unread_messages.h"

#include <spdlog/spdlog.h>

#include <exception>

namespace selvage::server::dispatch {

// Shared by the messages that it waits for: the last one to be read does the work.
struct UnreadMessages::Waiter {
  Work work;

  explicit Waiter(Work when_read) : work{std::move(when_read)} {}
  ~Waiter() {
    try {
      work();
    } catch (const std::exception& error) {
      spdlog::error("a call that waited for earlier messages threw an exception: {}", error.what());
    }
  }
  Waiter(const Waiter&) = delete;
  Waiter& operator=(const Waiter&) = delete;
};

class UnreadMessages::Ticket {
 public:
  Ticket(std::shared_ptr<List> list, std::uint64_t session) : list_{std::move(list)} {
    const std::lock_guard lock{list_->mutex};
    place_ = list_->unread.emplace(session, std::vector<std::shared_ptr<const Waiter>>{});
  }
  ~Ticket() {
    std::vector<std::shared_ptr<const Waiter>> waiters;  // released without the lock, because that may do their work
    const std::lock_guard lock{list_->mutex};
    waiters.swap(place_->second);
    list_->unread.erase(place_);
  }
  Ticket(const Ticket&) = delete;
  Ticket& operator=(const Ticket&) = delete;

 private:
  const std::shared_ptr<List> list_;
  decltype(List::unread)::iterator place_;
};

std::shared_ptr<const UnreadMessages::Ticket> UnreadMessages::add(std::uint64_t session) {
  return std::make_shared<const Ticket>(list_, session);
}

bool UnreadMessages::when_read(std::uint64_t session, Work work) {
  const std::lock_guard lock{list_->mutex};
  const auto [first, last] = list_->unread.equal_range(session);
  if (first == last) return false;
  const auto waiter = std::make_shared<const Waiter>(std::move(work));
  for (auto unread = first; unread != last; ++unread) unread->second.push_back(waiter);
  return true;
}

}  // namespace selvage::server::dispatch
