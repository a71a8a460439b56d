#include "server/calls/open_calls.h"

namespace selvage::server::calls {

std::shared_ptr<ListedCall> OpenCalls::expect(const Json& id, std::uint64_t session) {
  auto listed = std::make_shared<ListedCall>(list_, Key{session, protocol::json::to_text(id)});
  std::shared_ptr<OpenCall> earlier;  // released without the lock, because its end removes it from the list
  const std::lock_guard lock{list_->mutex};
  ListedCall*& place = list_->calls[listed->key_];
  if (place) earlier = place->call_.lock();
  const bool ended = place && place->state_ == ListedCall::State::kBegun && (!earlier || *earlier->ending());
  if (!place || ended) place = listed.get();
  return listed;
}

bool OpenCalls::cancel(const Json& id, std::uint64_t session) {
  std::shared_ptr<OpenCall> call;
  {
    const std::lock_guard lock{list_->mutex};
    const auto found = list_->calls.find(Key{session, protocol::json::to_text(id)});
    if (found == list_->calls.end()) return false;
    ListedCall& listed = *found->second;
    if (listed.state_ == ListedCall::State::kExpected) {
      listed.state_ = ListedCall::State::kCancelled;
      return true;
    }
    call = listed.call_.lock();
  }
  return call && call->cancel();
}

std::size_t OpenCalls::count() const {
  const std::lock_guard lock{list_->mutex};
  return list_->begun;
}

ListedCall::~ListedCall() {
  const std::lock_guard lock{list_->mutex};
  remove();
  if (state_ == State::kBegun) --list_->begun;
}

bool ListedCall::cancelled() const {
  const std::lock_guard lock{list_->mutex};
  return state_ == State::kCancelled;
}

bool ListedCall::settle() {
  const std::lock_guard lock{list_->mutex};
  remove();
  if (state_ == State::kCancelled) return false;
  state_ = State::kSettled;
  return true;
}

bool ListedCall::begin(std::shared_ptr<ListedCall> listed, const std::shared_ptr<OpenCall>& call) {
  ListedCall& self = *listed;
  call->listing_ = std::move(listed);
  const std::lock_guard lock{self.list_->mutex};
  if (self.state_ == State::kCancelled) return false;
  self.state_ = State::kBegun;
  self.call_ = call;
  self.list_->calls.insert_or_assign(self.key_, &self);
  ++self.list_->begun;
  return true;
}

// Unless another call with the same id has taken its place.
void ListedCall::remove() {
  const auto found = list_->calls.find(key_);
  if (found != list_->calls.end() && found->second == this) list_->calls.erase(found);
}

}  // namespace selvage::server::calls
