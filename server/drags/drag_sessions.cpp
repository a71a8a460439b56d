#include "server/drags/drag_sessions.h"

#include <algorithm>
#include <utility>

#include "protocol/calls/values.h"
#include "protocol/edits/changes.h"
#include "server/calls/errors.h"
#include "server/memory/weights.h"

namespace selvage::server::drags {

struct DragSessions::Drag {
  explicit Drag(memory::HeldBytes of_latest) : held{std::move(of_latest)} {}

  std::string id, marker_id;
  std::shared_ptr<transport::access::Session> session;
  store::Committed base;
  PieceId piece;
  motion::dragging::DragMode mode{};
  Vec at{};                        // of the piece, after the last move; protected by the mutex of all drags
  std::optional<Marker> latest{};  // the marker after the last move; used in the drag's lane only
  const memory::HeldBytes held;    // for it

  std::mutex mutex{};
  std::optional<WaitingMove> mailbox{};

  // Destroyed while the mutex of all drags is not held, because the callback may be waiting for it.
  std::optional<std::stop_callback<std::function<void()>>> on_gone{};
};

namespace {

constexpr const char* kBusy = "too many drag calls are waiting";

protocol::rpc::RpcError unknown_drag(const std::string& id) {
  return protocol::rpc::rpc_error(Error{
      ErrorCode::kOutOfRange, protocol::json::shortened(Json(id)) + " is not a drag of this connection", "/dragId"});
}

}  // namespace

DragFunction drag_function() {
  return [](auto&&... given) { return motion::dragging::drag(std::forward<decltype(given)>(given)...); };
}

std::size_t DragSessions::count() const {
  const std::lock_guard lock{mutex_};
  return drags_.size();
}

std::shared_ptr<DragSessions::Drag> DragSessions::find(const std::string& id, std::uint64_t session) const {
  const std::lock_guard lock{mutex_};
  const auto found = drags_.find(id);
  return found == drags_.end() || found->second->session->id != session ? nullptr : found->second;
}

calls::Outcome DragSessions::begin(const protocol::methods::dragging::BeginParams& params,
                                   const std::shared_ptr<transport::access::Session>& session) {
  auto base = store_.current(params.marker_id);
  if (!base) return calls::unknown_marker(store_, params.marker_id);
  if (params.base_revision && *params.base_revision != base->revision) {
    return calls::revision_mismatch(params.marker_id, *params.base_revision, base->revision);
  }
  const Marker& marker = base->file->marker;
  const auto piece = protocol::calls::piece_of(marker, params.piece.text, "/piece");
  if (!piece) return protocol::rpc::rpc_error(piece.error());
  const Vec at = marker.pieces[piece->value].at;

  std::unique_lock lock{mutex_};
  const auto own = std::count_if(drags_.begin(), drags_.end(),
                                 [&](const auto& entry) { return entry.second->session->id == session->id; });
  if (static_cast<std::size_t>(own) >= kMaxPerConnection) {
    return calls::limit_reached("too many drags", kMaxPerConnection);
  }
  memory::HeldBytes held{store_.room().account};
  if (!held.try_add(memory::bytes_of(marker))) return calls::no_room(store_);
  std::string id = "d" + std::to_string(++begun_);
  const protocol::methods::dragging::BeginResult result{
      id, {params.marker_id, base->revision}, params.piece.text, protocol::calls::point_of(at, marker.resolution)};
  const auto drag = std::make_shared<Drag>(std::move(held));
  drag->id = id;
  drag->marker_id = params.marker_id;
  drag->session = session;
  drag->base = *std::move(base);
  drag->piece = *piece;
  drag->mode = params.mode;
  drag->at = at;
  drags_.emplace(id, drag);
  notify_watchers(*drag);
  lock.unlock();
  drag->on_gone.emplace(session->gone, [this, id] { abandon(id); });
  return protocol::schema::encode(result);
}

void DragSessions::abandon(const std::string& id) {
  std::shared_ptr<Drag> drag;
  {
    const std::lock_guard lock{mutex_};
    const auto found = drags_.find(id);
    if (found == drags_.end()) return;
    drag = std::move(found->second);
    drags_.erase(found);
    notify_watchers(*drag);
  }
  // Freed by a worker: this may be the last reference to its revision, and freeing the many pieces of a revision would
  // block the I/O thread for some tenths of a millisecond.
  jobs::Job job{.session = drag->session->id,
                .lane = {},
                .caller = {},
                .work = jobs::Work{[gone = drag](auto&&) mutable { gone.reset(); }}};
  drag.reset();
  (void)queue_.submit(job);  // a job that is not accepted is freed here
}

bool DragSessions::others_drag(const std::string& marker, std::uint64_t session) const {
  return std::ranges::any_of(drags_, [&](const auto& entry) {
    return entry.second->marker_id == marker && entry.second->session->id != session;
  });
}

std::string DragSessions::dragged_message(const std::string& marker, std::uint64_t session) const {
  protocol::methods::dragging::DraggedNotification now{marker, {}};
  for (const auto& [id, drag] : drags_) {
    if (drag->marker_id != marker || drag->session->id == session) continue;
    const Marker& start = drag->base.file->marker;
    now.pieces.push_back({start.pieces[drag->piece.value].id, protocol::calls::point_of(drag->at, start.resolution)});
  }
  return protocol::json::to_text(protocol::rpc::notification("marker.dragged", protocol::schema::encode(now)));
}

void DragSessions::notify_watchers(const Drag& drag) const {
  watchers_.notify_others(drag.marker_id, drag.session->id,
                          [&](std::uint64_t session) { return dragged_message(drag.marker_id, session); });
}

void DragSessions::notify(const std::string& marker, const transport::access::Session& session) const {
  const std::lock_guard lock{mutex_};
  if (others_drag(marker, session.id)) session.notify(dragged_message(marker, session.id));
}

void DragSessions::move(const protocol::methods::dragging::MoveParams& params,
                        const std::shared_ptr<calls::OpenCall>& call) {
  const auto drag = find(params.drag_id, call->session()->id);
  if (!drag) return call->answer(unknown_drag(params.drag_id));
  const auto to = protocol::methods::dragging::within_reach(params.to, drag->base.file->marker);
  if (!to) return call->answer(protocol::rpc::rpc_error(to.error()));
  WaitingMove newest{*to, call};
  std::optional<WaitingMove> superseded;
  {
    const std::lock_guard lock{drag->mutex};
    superseded = std::exchange(drag->mailbox, std::move(newest));
  }
  if (!superseded) return schedule(drag);
  superseded->call->answer(
      protocol::rpc::RpcError{protocol::rpc::RpcCode::kSuperseded, "a newer move of this drag replaced it", {}});
}

// Queues one job for each move that found the mailbox empty.  A move that replaces it there uses the same job.
void DragSessions::schedule(const std::shared_ptr<Drag>& drag) {
  jobs::Job job{.session = drag->session->id,
                .lane = drag->id,
                .quick = true,
                .caller = drag->session->gone,
                .work = jobs::Work{[this, drag](const std::stop_token& stop) { execute_waiting_move(*drag, stop); }}};
  const jobs::Admission admission = queue_.submit(job);
  if (admission == jobs::Admission::kAccepted) return;
  std::optional<WaitingMove> refused;
  {
    const std::lock_guard lock{drag->mutex};
    refused = std::exchange(drag->mailbox, std::nullopt);
  }
  if (refused) refused->call->answer(calls::not_admitted(admission, queue_, kBusy));
}

void DragSessions::execute_waiting_move(Drag& drag, const std::stop_token& stop) {
  std::optional<WaitingMove> move;
  {
    const std::lock_guard lock{drag.mutex};
    move = std::exchange(drag.mailbox, std::nullopt);
  }
  if (!move || (move->call->abandoned() && !move->call->settle())) return;
  const Marker& start = drag.base.file->marker;
  const auto laid_out = drag.base.laid_out->get([&] { return scene::LaidOut{start, sums_}; });
  motion::dragging::Drag moved = drag_(start, *laid_out, drag.piece, move->to, drag.mode, {sums_, stop, {}});
  const auto result = protocol::methods::dragging::moved(drag.id, start, *laid_out, moved, drag.piece, move->to);
  // A move that was cancelled has no effect.
  if (!move->call->settle()) return;
  drag.latest = std::move(moved.marker);
  {
    const std::lock_guard lock{mutex_};
    drag.at = drag.latest->pieces[drag.piece.value].at;
    if (drags_.contains(drag.id)) notify_watchers(drag);
  }
  move->call->answer(protocol::schema::encode(result));
}

void DragSessions::end(const protocol::methods::dragging::EndParams& params,
                       const std::shared_ptr<calls::OpenCall>& call) {
  if (const auto earlier = committer_.earlier_answer(params.marker_id, params.op_id, "drag.end", *call)) {
    return call->answer(*earlier);
  }
  const auto drag = find(params.drag_id, call->session()->id);
  if (!drag || drag->marker_id != params.marker_id) return call->answer(unknown_drag(params.drag_id));
  jobs::Job job{.session = call->session()->id,
                .lane = drag->id,
                .quick = true,
                .caller = call->stop(),
                .work = jobs::Work{[this, drag, call, params](const std::stop_token& stop) {
                  execute_waiting_move(*drag, stop);
                  call->answer(finish(*drag, params, *call));
                }}};
  // Removed first, so that the drag accepts no move and no second end.  Restored if the queue has no room for the end.
  {
    const std::lock_guard lock{mutex_};
    if (drags_.erase(drag->id) == 0) return call->answer(unknown_drag(drag->id));
    notify_watchers(*drag);
  }
  const jobs::Admission admission = queue_.submit(job);
  if (admission == jobs::Admission::kAccepted) return;
  {
    const std::lock_guard lock{mutex_};
    drags_.emplace(drag->id, drag);
    notify_watchers(*drag);
  }
  call->answer(calls::not_admitted(admission, queue_, kBusy));
}

calls::Outcome DragSessions::finish(Drag& drag, const protocol::methods::dragging::EndParams& params,
                                    calls::OpenCall& call) {
  const Marker& start = drag.base.file->marker;
  const Marker& latest = drag.latest ? *drag.latest : start;
  MarkerFile after = protocol::edits::with_marker(*drag.base.file, latest);
  protocol::edits::CommittedChange result{{drag.marker_id, drag.base.revision},
                                          protocol::edits::change_between(*drag.base.file, after)};
  if (!params.commit || latest == start) {
    if (call.abandoned() || !call.settle()) return calls::abandoned();
    return committer_.keep_unchanged("drag.end", drag.marker_id, params.op_id, protocol::schema::encode(result), call);
  }
  ++result.at.revision;
  return committer_.commit({"drag.end", drag.marker_id, drag.base, std::move(after), store::Origin::kChange,
                            params.op_id, protocol::schema::encode(result)},
                           call);
}

}  // namespace selvage::server::drags
