#include "server/calls/open_call.h"

namespace selvage::server::calls {

protocol::rpc::RpcError cancelled() {
  return {protocol::rpc::RpcCode::kCancelled, "the call was cancelled", {}};
}

OpenCall::OpenCall(std::shared_ptr<transport::access::Session> session, jobs::ReplyOnce<Outcome> reply,
                   std::int64_t params)
    : session_{std::move(session)}, params_{params}, reply_{std::move(reply)}, disconnected_{session_->gone, [this] {
                                                                                               stop_.request_stop();
                                                                                             }} {}

StopCause OpenCall::stop_cause() const {
  if (state_ == State::kCancelled) return StopCause::kCancelled;
  if (session_->gone.stop_requested()) return StopCause::kDisconnected;
  if (late_) return StopCause::kDeadline;
  return draining_ ? StopCause::kDraining : StopCause::kNone;
}

bool OpenCall::begin() {
  State state = State::kWaiting;
  return state_.compare_exchange_strong(state, State::kBegun);
}

bool OpenCall::leave_open(State to) {
  State state = state_;
  while (state == State::kWaiting || state == State::kBegun) {
    if (state_.compare_exchange_weak(state, to)) {
      *ending_ = true;
      return true;
    }
  }
  return false;
}

bool OpenCall::settle() {
  return leave_open(State::kSettled) || state_ == State::kSettled;
}

void OpenCall::answer(Outcome outcome) {
  if (settle()) std::move(reply_)(std::move(outcome));
}

bool OpenCall::cancel() {
  if (!leave_open(State::kCancelled)) return false;
  stop_.request_stop();
  std::move(reply_)(cancelled());
  return true;
}

void OpenCall::drain() {
  if (stop_.stop_requested()) return;
  draining_ = true;
  stop_.request_stop();
}

void OpenCall::set_deadline(const std::shared_ptr<OpenCall>& call, jobs::DeadlineClock& clock,
                            jobs::DeadlineClock::Time time, std::function<protocol::rpc::RpcError()> if_waiting) {
  call->deadline_ = clock.at(time, [weak = std::weak_ptr{call}, refusal = std::move(if_waiting)] {
    const auto open = weak.lock();
    if (!open) return;
    open->late_ = true;
    State state = State::kWaiting;
    const bool expired = open->state_.compare_exchange_strong(state, State::kExpired);
    open->stop_.request_stop();
    if (!expired) return;
    *open->ending_ = true;
    std::move(open->reply_)(refusal());
  });
}

}  // namespace selvage::server::calls
