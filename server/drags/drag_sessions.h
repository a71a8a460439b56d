// Drag sessions: drag.begin, drag.move and drag.end.
//
// A drag works on the revision at which it began and belongs to the connection that began it.  Each drag has a mailbox
// for one move: a newer move replaces one that has not started, which is then answered as superseded.  Nothing is
// committed before the drag ends, but sessions that watch the marker are notified which pieces others drag and where
// these are: after every begin, move and end, when a connection ends, and when a session begins to watch.  All work is
// done in a separate queue, in the drag's lane, so that a drag never waits behind a motion.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>

#include "core/motion/dragging/drag.h"
#include "protocol/methods/dragging/drag_messages.h"
#include "server/calls/open_call.h"
#include "server/changes/committer.h"
#include "server/changes/watchers.h"
#include "server/jobs/job_queue.h"
#include "server/store/marker_store.h"

namespace selvage::server::drags {

// The function that computes one move of a drag; tests replace it.
using DragFunction = std::function<motion::dragging::Drag(const Marker&, const scene::LaidOut&, PieceId, Vec to,
                                                          motion::dragging::DragMode, const scene::Run&)>;
[[nodiscard]] DragFunction drag_function();

class DragSessions {
 public:
  static constexpr std::size_t kMaxPerConnection = 16;

  // REQUIRES: all references outlive the drag sessions and every call.
  DragSessions(store::MarkerStore& store, changes::Committer& committer, changes::Watchers& watchers, SumCache& sums,
               jobs::JobQueue& queue, DragFunction drag = drag_function())
      : store_{store}, committer_{committer}, watchers_{watchers}, sums_{sums}, queue_{queue}, drag_{std::move(drag)} {}

  [[nodiscard]] calls::Outcome begin(const protocol::methods::dragging::BeginParams& params,
                                     const std::shared_ptr<transport::access::Session>& session);
  // These two answer the call, immediately or when the drag's turn comes.
  void move(const protocol::methods::dragging::MoveParams& params, const std::shared_ptr<calls::OpenCall>& call);
  void end(const protocol::methods::dragging::EndParams& params, const std::shared_ptr<calls::OpenCall>& call);
  [[nodiscard]] std::size_t count() const;
  // Notifies a connection that begins to watch a marker which pieces others drag, if there are any.
  void notify(const std::string& marker, const transport::access::Session& session) const;

 private:
  struct WaitingMove {
    Vec to;
    std::shared_ptr<calls::OpenCall> call;
  };
  struct Drag;

  // The connection's drag of this id, or null.
  [[nodiscard]] std::shared_ptr<Drag> find(const std::string& id, std::uint64_t session) const;
  void schedule(const std::shared_ptr<Drag>& drag);
  void execute_waiting_move(Drag& drag, const std::stop_token& stop);
  // Ends a drag whose connection has ended.
  void abandon(const std::string& id);
  // The functions below REQUIRE that the caller holds the mutex, so that notifications are sent in the order of the
  // events that they report.
  void notify_watchers(const Drag& drag) const;
  [[nodiscard]] std::string dragged_message(const std::string& marker, std::uint64_t session) const;
  [[nodiscard]] bool others_drag(const std::string& marker, std::uint64_t session) const;
  [[nodiscard]] calls::Outcome finish(Drag& drag, const protocol::methods::dragging::EndParams& params,
                                      calls::OpenCall& call);

  store::MarkerStore& store_;
  changes::Committer& committer_;
  changes::Watchers& watchers_;
  SumCache& sums_;
  jobs::JobQueue& queue_;
  const DragFunction drag_;
  mutable std::mutex mutex_;
  std::uint64_t begun_{};
  std::map<std::string, std::shared_ptr<Drag>> drags_;
};

}  // namespace selvage::server::drags
