// The right to answer one call, exactly once.  Move-only.  If it is destroyed unused, because a job threw an exception
// or a queue dropped it, it answers `if_lost`, so that no caller waits forever.
#pragma once

#include <functional>
#include <utility>

namespace selvage::server::jobs {

template <class Answer>
class ReplyOnce {
 public:
  using Send = std::function<void(Answer)>;

  ReplyOnce(Send send, Answer if_lost) : send_{std::move(send)}, if_lost_{std::move(if_lost)} {}
  ReplyOnce(ReplyOnce&& other) noexcept
      : send_{std::exchange(other.send_, nullptr)}, if_lost_{std::move(other.if_lost_)} {}
  ReplyOnce& operator=(ReplyOnce&&) = delete;
  ~ReplyOnce() {
    if (send_) send_(std::move(if_lost_));
  }

  // Can be used once: std::move(reply)(answer).
  void operator()(Answer answer) && { std::exchange(send_, nullptr)(std::move(answer)); }

 private:
  Send send_;
  Answer if_lost_;
};

}  // namespace selvage::server::jobs
