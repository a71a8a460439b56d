#include "server/open_call.h"

namespace selvage {

OpenCall::OpenCall(std::shared_ptr<Session> session, ReplyOnce<Outcome> reply)
    : session_{std::move(session)}, reply_{std::move(reply)}, gone_{session_->gone, [this] {
                                                                      left_.request_stop();
                                                                      stop_.request_stop();
                                                                    }} {}

bool OpenCall::settle() {
  Fate fate = Fate::kOpen;
  return fate_.compare_exchange_strong(fate, Fate::kSettled) || fate == Fate::kSettled;
}

void OpenCall::answer(Outcome outcome) {
  if (settle()) std::move(reply_)(std::move(outcome));
}

bool OpenCall::cancel() {
  Fate fate = Fate::kOpen;
  if (!fate_.compare_exchange_strong(fate, Fate::kCancelled)) return false;
  left_.request_stop();
  stop_.request_stop();
  std::move(reply_)(RpcError{RpcCode::kCancelled, "the call was cancelled", {}});
  return true;
}

void OpenCall::set_deadline(const std::shared_ptr<OpenCall>& call, DeadlineClock& clock, DeadlineClock::Time time) {
  call->deadline_ = clock.at(time, [weak = std::weak_ptr{call}] {
    const auto still = weak.lock();
    if (!still) return;
    still->late_ = true;
    still->stop_.request_stop();
  });
}

void OpenCalls::add(const Json& id, const std::shared_ptr<OpenCall>& call) {
  const std::lock_guard lock{mutex_};
  calls_.insert_or_assign(Key{call->session()->id, to_text(id)}, Entry{call.get(), call});
}

void OpenCalls::remove(const Json& id, std::uint64_t session, const OpenCall* call) {
  const std::lock_guard lock{mutex_};
  const auto found = calls_.find(Key{session, to_text(id)});
  if (found != calls_.end() && found->second.which == call) calls_.erase(found);
}

bool OpenCalls::cancel(const Json& id, std::uint64_t session) {
  std::shared_ptr<OpenCall> call;
  {
    const std::lock_guard lock{mutex_};
    const auto found = calls_.find(Key{session, to_text(id)});
    if (found != calls_.end()) call = found->second.call.lock();
  }
  return call && call->cancel();
}

}  // namespace selvage
