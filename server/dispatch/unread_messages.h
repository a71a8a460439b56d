// The messages of each session that have been received but not read yet: nobody knows which calls they contain.  A
// request to cancel a call waits until those received before it have been read.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace selvage::server::dispatch {

class UnreadMessages {
 public:
  using Work = std::function<void()>;
  class Ticket;

  // A message is unread as long as its ticket exists.
  [[nodiscard]] std::shared_ptr<const Ticket> add(std::uint64_t session);
  // Calls `work` when the messages of the session that are unread now have been read, on the thread that has read the
  // last one.  Returns false if there are none, and does not call it.
  [[nodiscard]] bool when_read(std::uint64_t session, Work work);

 private:
  struct Waiter;
  struct List {
    std::mutex mutex;
    std::multimap<std::uint64_t, std::vector<std::shared_ptr<const Waiter>>> unread;  // who waits for each message
  };
  const std::shared_ptr<List> list_ = std::make_shared<List>();
};

}  // namespace selvage::server::dispatch
