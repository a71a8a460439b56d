// The dragging hand, served: drag.begin, drag.move, drag.end.
//
// A drag works on the revision at which it began and belongs to the session that began it.  Its mailbox holds one move:
// a newer one takes the place of one that has not begun, which is answered as superseded.  Nothing is committed before
// the end.  All work is done on a queue of its own, in the drag's lane, so that a hand never waits behind a motion.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "protocol/methods/readings/drag_messages.h"
#include "server/calls/open_call.h"
#include "server/jobs/job_queue.h"
#include "server/methods/methods.h"

namespace selvage::server::methods {

class Drags {
 public:
  static constexpr std::size_t kMostPerSession = 16;

  // REQUIRES: all outlive the drags and every call.
  Drags(store::MarkerStore& store, Methods& methods, SumCache& sums, jobs::JobQueue& queue)
      : store_{store}, methods_{methods}, sums_{sums}, queue_{queue} {}

  // Answers the call, at once or when its turn came.  REQUIRES: the method is one of the drags'.
  void take(const std::string& method, const Json& params, const std::shared_ptr<calls::OpenCall>& call);
  [[nodiscard]] std::size_t count() const;

 private:
  struct Waiting {
    Vec to;
    std::shared_ptr<calls::OpenCall> call;
  };
  struct Held;

  [[nodiscard]] calls::Outcome begin(const Json& params, const std::shared_ptr<transport::access::Session>& session);
  void move(const Json& params, const std::shared_ptr<calls::OpenCall>& call);
  void end(const Json& params, const std::shared_ptr<calls::OpenCall>& call);

  // The session's drag of this id; null when there is none.
  [[nodiscard]] std::shared_ptr<Held> held(const std::string& id, std::uint64_t session) const;
  void schedule(const std::shared_ptr<Held>& drag);
  void serve(Held& drag, const std::stop_token& stop);
  [[nodiscard]] calls::Outcome finish(Held& drag, const protocol::methods::readings::DragEnd& wanted,
                                      const CallTurn& turn);

  store::MarkerStore& store_;
  Methods& methods_;
  SumCache& sums_;
  jobs::JobQueue& queue_;
  mutable std::mutex mutex_;
  std::uint64_t begun_{};
  std::map<std::string, std::shared_ptr<Held>> drags_;
};

}  // namespace selvage::server::methods
