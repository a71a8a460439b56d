// A call in progress, and how it ends: with the outcome of its method, by cancellation, or refused at its deadline
// because it had not started.  It ends in exactly one of these ways.
//
// Whoever settles the call first decides.  A worker that settles it goes on to commit and to answer.  A client that
// cancels it first is answered at once, whatever the solver is doing, and the worker's result is dropped.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>

#include "server/calls/outcome.h"
#include "server/calls/stop_cause.h"
#include "server/jobs/deadline_clock.h"
#include "server/jobs/reply_once.h"
#include "server/transport/access/service.h"

namespace selvage::server::calls {

// The error that answers a cancelled call.
[[nodiscard]] protocol::rpc::RpcError cancelled();

class OpenCall {
 public:
  // `params`: a checksum of the call's parameters; 0 if the call has no opId, because the checksum is then not needed.
  OpenCall(std::shared_ptr<transport::access::Session> session, jobs::ReplyOnce<Outcome> reply,
           std::int64_t params = 0);

  [[nodiscard]] const std::shared_ptr<transport::access::Session>& session() const { return session_; }
  [[nodiscard]] std::int64_t params() const { return params_; }
  // Requests a stop whatever the cause.  A method that is stopped returns its best result so far.
  [[nodiscard]] std::stop_token stop() const { return stop_.get_token(); }
  // If there are several causes, abandonment takes precedence over the deadline, and the deadline over draining.
  [[nodiscard]] StopCause stop_cause() const;
  [[nodiscard]] bool abandoned() const { return is_abandoned(stop_cause()); }

  // The time until its deadline, negative when that has passed; none if it has none.
  [[nodiscard]] std::optional<jobs::DeadlineClock::Duration> time_left() const { return deadline_.left(); }

  // The call's turn has come: from now on its deadline only stops it.  Returns false if it has been answered already.
  [[nodiscard]] bool begin();
  // Becomes true when the call has been settled, cancelled or refused at its deadline.
  [[nodiscard]] std::shared_ptr<const std::atomic<bool>> ending() const { return ending_; }
  // Returns true if the worker may end the call, which can then no longer be cancelled.  May be called repeatedly.
  [[nodiscard]] bool settle();
  // Answers the call unless it was cancelled.  At most once.
  void answer(Outcome outcome);
  // Returns false if it was too late to cancel.
  bool cancel();
  // Stops the call because the server is shutting down.  Changes nothing if it was stopped before.
  void drain();

  // Sets the deadline.  At that time the call is stopped; if it is still waiting for its turn, it is answered with what
  // `if_waiting` returns, which is called on the clock's thread.  REQUIRES: nobody else uses the call yet.
  static void set_deadline(const std::shared_ptr<OpenCall>& call, jobs::DeadlineClock& clock,
                           jobs::DeadlineClock::Time time, std::function<protocol::rpc::RpcError()> if_waiting);

 private:
  enum class State { kWaiting, kBegun, kSettled, kCancelled, kExpired };
  // Changes the state to `to` unless the call is settled or answered already.  Returns true if it did.
  [[nodiscard]] bool leave_open(State to);

  const std::shared_ptr<transport::access::Session> session_;
  const std::int64_t params_;
  std::atomic<State> state_{State::kWaiting};
  const std::shared_ptr<std::atomic<bool>> ending_ = std::make_shared<std::atomic<bool>>(false);
  std::atomic<bool> late_{}, draining_{};
  std::stop_source stop_;
  jobs::ReplyOnce<Outcome> reply_;
  jobs::DeadlineClock::Alarm deadline_;
  friend class ListedCall;
  std::shared_ptr<const void> listing_;  // removes the call from OpenCalls when it ends
  std::stop_callback<std::function<void()>> disconnected_;
};

}  // namespace selvage::server::calls
