// The calls that can be cancelled, by session and by id: from when their message has been read, so that a call of a
// batch can be cancelled before its turn comes, until they end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "protocol/json/json_text.h"
#include "server/calls/open_call.h"

namespace selvage::server::calls {

class ListedCall;

class OpenCalls {
 public:
  // Lists a call whose turn has not come, as long as the returned value exists.  As long as another call with the same
  // id is in progress, only that one can be cancelled.
  [[nodiscard]] std::shared_ptr<ListedCall> expect(const Json& id, std::uint64_t session);
  // Returns false if there is no such call, or if it was too late.
  bool cancel(const Json& id, std::uint64_t session);
  // The calls whose turn has come.
  [[nodiscard]] std::size_t count() const;

 private:
  friend class ListedCall;
  using Key = std::pair<std::uint64_t, std::string>;
  struct List {
    std::mutex mutex;
    std::map<Key, ListedCall*> calls;
    std::size_t begun{};
  };
  const std::shared_ptr<List> list_ =
      std::make_shared<List>();  // a call may outlive us, on the deadline clock's thread
};

class ListedCall {
 public:
  ListedCall(std::shared_ptr<OpenCalls::List> list, OpenCalls::Key key)
      : list_{std::move(list)}, key_{std::move(key)} {}
  ~ListedCall();
  ListedCall(const ListedCall&) = delete;
  ListedCall& operator=(const ListedCall&) = delete;

  [[nodiscard]] bool cancelled() const;
  // The call is answered without having begun, or is one that cannot be cancelled.  Returns false if it has been
  // cancelled, which must then be its answer.
  [[nodiscard]] bool settle();
  // The call's turn has come: it stays listed as long as `call` exists, and replaces an earlier call with the same id.
  // Returns false if it has been cancelled, which must then be its answer.  REQUIRES: nobody else uses `call` yet.
  [[nodiscard]] static bool begin(std::shared_ptr<ListedCall> listed, const std::shared_ptr<OpenCall>& call);

 private:
  friend class OpenCalls;
  enum class State { kExpected, kCancelled, kBegun, kSettled };
  void remove();  // REQUIRES: the mutex is locked

  const std::shared_ptr<OpenCalls::List> list_;
  const OpenCalls::Key key_;
  State state_{State::kExpected};  // guarded by the list's mutex, as is the next one
  std::weak_ptr<OpenCall> call_;   // once it has begun
};

}  // namespace selvage::server::calls
