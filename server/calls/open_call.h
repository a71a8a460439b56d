// A call that is under way, and the ways in which it may end: with its outcome, or cancelled - never both.
//
// Whoever settles a call first decides: a worker that settles it goes on to commit and to answer, a client that cancels
// it first has its answer at once, whatever the solver is doing, and the worker's result is dropped.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

#include "server/calls/outcome.h"
#include "server/jobs/deadline_clock.h"
#include "server/jobs/reply_once.h"
#include "server/transport/access/service.h"

namespace selvage::server::calls {

class OpenCall {
 public:
  OpenCall(std::shared_ptr<transport::access::Session> session, jobs::ReplyOnce<Outcome> reply);

  [[nodiscard]] const std::shared_ptr<transport::access::Session>& session() const { return session_; }
  // Its caller is gone or has cancelled it: nobody wants the outcome.
  [[nodiscard]] std::stop_token left() const { return left_.get_token(); }
  // The same, or its deadline has passed: the best so far is wanted now.
  [[nodiscard]] std::stop_token stop() const { return stop_.get_token(); }
  [[nodiscard]] bool late() const { return late_; }

  // True when the call is the worker's to end: from now on it cannot be cancelled.  May be asked again.
  [[nodiscard]] bool settle();
  // Answers, unless it was cancelled.  At most once.
  void answer(Outcome outcome);
  // False when it was too late to cancel.
  bool cancel();

  // REQUIRES: nobody else uses the call yet.
  static void set_deadline(const std::shared_ptr<OpenCall>& call, jobs::DeadlineClock& clock,
                           jobs::DeadlineClock::Time time);

 private:
  enum class Fate { kOpen, kSettled, kCancelled };

  const std::shared_ptr<transport::access::Session> session_;
  std::atomic<Fate> fate_{Fate::kOpen};
  std::atomic<bool> late_{};
  std::stop_source left_, stop_;
  jobs::ReplyOnce<Outcome> reply_;
  jobs::DeadlineClock::Alarm deadline_;
  friend class OpenCalls;
  std::shared_ptr<const void> listing_;  // its place in OpenCalls, given up with the call
  std::stop_callback<std::function<void()>> gone_;
};

// The calls under way that can be cancelled: by session and by the call's id.  A call is listed as long as it lives.
class OpenCalls {
 public:
  // A later call of the same id takes an earlier one's place.  REQUIRES: nobody else uses the call yet.
  void add(const Json& id, const std::shared_ptr<OpenCall>& call);
  // False when there is none, or when it was too late.
  bool cancel(const Json& id, std::uint64_t session);
  [[nodiscard]] std::size_t count() const;

 private:
  using Key = std::pair<std::uint64_t, std::string>;
  struct Entry {
    const OpenCall* which{};  // only compared
    std::weak_ptr<OpenCall> call;
  };
  struct List {
    std::mutex mutex;
    std::map<Key, Entry> calls;
  };
  struct Listing;
  const std::shared_ptr<List> list_ = std::make_shared<List>();  // a call may end after us, on the deadlines' thread
};

}  // namespace selvage::server::calls
