#include "server/methods/drags.h"

#include <algorithm>
#include <utility>

#include "protocol/calls/codec.h"
#include "protocol/calls/motion.h"
#include "protocol/edits/changes.h"
#include "server/calls/refusals.h"

namespace selvage::server::methods {

struct Drags::Held {
  std::string id, marker_id;
  std::shared_ptr<transport::access::Session> session;
  store::Committed base;
  PieceId piece;
  motion::dragging::DragMode mode{};
  std::optional<Marker> latest{};  // where the pieces are for the hand; used in the drag's lane only

  std::mutex mutex{};
  std::optional<Waiting> mailbox{};
};

namespace {

protocol::rpc::RpcError unknown_drag(const std::string& id) {
  return protocol::rpc::rpc_error(
      Error{ErrorCode::kOutOfRange, protocol::json::shortened(Json(id)) + " is no drag of this connection", "/dragId"});
}

protocol::rpc::RpcError refused(jobs::Admission admission, const jobs::JobQueue& queue) {
  if (admission == jobs::Admission::kDraining) return calls::going_down();
  return {protocol::rpc::RpcCode::kBusy, "too many hands are dragging", Json{{"retryAfterMs", queue.retry_after_ms()}}};
}

}  // namespace

void Drags::take(const std::string& method, const Json& params, const std::shared_ptr<calls::OpenCall>& call) {
  if (method == "drag.begin") return call->answer(begin(params, call->session()));
  if (method == "drag.move") return move(params, call);
  end(params, call);
}

std::size_t Drags::count() const {
  const std::lock_guard lock{mutex_};
  return drags_.size();
}

std::shared_ptr<Drags::Held> Drags::held(const std::string& id, std::uint64_t session) const {
  const std::lock_guard lock{mutex_};
  const auto found = drags_.find(id);
  return found == drags_.end() || found->second->session->id != session ? nullptr : found->second;
}

calls::Outcome Drags::begin(const Json& params, const std::shared_ptr<transport::access::Session>& session) {
  const auto wanted = protocol::methods::readings::decode_drag_begin(params);
  if (!wanted) return protocol::rpc::rpc_error(wanted.error());
  auto base = store_.current(wanted->marker_id);
  if (!base) return calls::unknown_marker(wanted->marker_id);
  if (wanted->base_revision && *wanted->base_revision != base->revision) {
    return calls::revision_mismatch(wanted->marker_id, *wanted->base_revision, base->revision);
  }
  const Marker& marker = base->file->marker;
  const auto piece = protocol::calls::piece_of(marker, wanted->piece, "/piece");
  if (!piece) return protocol::rpc::rpc_error(piece.error());
  const Vec at = marker.pieces[piece->value].at;

  const std::lock_guard lock{mutex_};
  std::erase_if(drags_, [](const auto& entry) { return entry.second->session->gone.stop_requested(); });
  const auto own = std::count_if(drags_.begin(), drags_.end(),
                                 [&](const auto& entry) { return entry.second->session->id == session->id; });
  if (static_cast<std::size_t>(own) >= kMostPerSession) return calls::limit_reached("too many drags", kMostPerSession);
  std::string id = "d" + std::to_string(++begun_);
  const Json answer{{"dragId", id},
                    {"markerId", wanted->marker_id},
                    {"revision", base->revision},
                    {"piece", wanted->piece},
                    {"at", protocol::formats::point_json(at, marker.resolution)}};
  auto drag = std::make_shared<Held>();
  drag->id = id;
  drag->marker_id = wanted->marker_id;
  drag->session = session;
  drag->base = *std::move(base);
  drag->piece = *piece;
  drag->mode = wanted->mode;
  drags_.emplace(std::move(id), std::move(drag));
  return answer;
}

void Drags::move(const Json& params, const std::shared_ptr<calls::OpenCall>& call) {
  const auto wanted = protocol::methods::readings::decode_drag_move(params);
  if (!wanted) return call->answer(protocol::rpc::rpc_error(wanted.error()));
  const auto drag = held(wanted->drag_id, call->session()->id);
  if (!drag) return call->answer(unknown_drag(wanted->drag_id));
  const auto to = protocol::methods::readings::within_reach(wanted->to, drag->base.file->marker);
  if (!to) return call->answer(protocol::rpc::rpc_error(to.error()));
  Waiting newest{*to, call};
  std::optional<Waiting> superseded;
  {
    const std::lock_guard lock{drag->mutex};
    superseded = std::exchange(drag->mailbox, std::move(newest));
  }
  if (!superseded) return schedule(drag);
  superseded->call->answer(
      protocol::rpc::RpcError{protocol::rpc::RpcCode::kSuperseded, "a newer move of this drag took its place", {}});
}

// One job per move that found the mailbox empty: whoever supersedes it uses the same job.
void Drags::schedule(const std::shared_ptr<Held>& drag) {
  jobs::Job job{.session = drag->session->id,
                .lane = drag->id,
                .caller = drag->session->gone,
                .work = jobs::Work{[this, drag](const std::stop_token& stop) { serve(*drag, stop); }}};
  const jobs::Admission admission = queue_.submit(job);
  if (admission == jobs::Admission::kAccepted) return;
  std::optional<Waiting> refused_move;
  {
    const std::lock_guard lock{drag->mutex};
    refused_move = std::exchange(drag->mailbox, std::nullopt);
  }
  if (refused_move) refused_move->call->answer(refused(admission, queue_));
}

void Drags::serve(Held& drag, const std::stop_token& stop) {
  std::optional<Waiting> move;
  {
    const std::lock_guard lock{drag.mutex};
    move = std::exchange(drag.mailbox, std::nullopt);
  }
  if (!move || (move->call->left().stop_requested() && !move->call->settle())) return;
  const Marker& start = drag.base.file->marker;
  const auto laid_out = drag.base.laid_out->get([&] { return scene::LaidOut{start, sums_}; });
  motion::dragging::Drag now =
      methods_.engine().drag(start, *laid_out, drag.piece, move->to, drag.mode, {sums_, stop, {}});
  Json answer{{"dragId", drag.id}};
  answer.update(protocol::methods::readings::drag_json(start, *laid_out, now, drag.piece, move->to));
  // What was cancelled has not happened.
  if (!move->call->settle()) return;
  drag.latest = std::move(now.marker);
  move->call->answer(std::move(answer));
}

void Drags::end(const Json& params, const std::shared_ptr<calls::OpenCall>& call) {
  auto wanted = protocol::methods::readings::decode_drag_end(params);
  if (!wanted) return call->answer(protocol::rpc::rpc_error(wanted.error()));
  if (const auto again = methods_.replay(wanted->marker_id, wanted->op_id, "drag.end")) return call->answer(*again);
  const auto drag = held(wanted->drag_id, call->session()->id);
  if (!drag || drag->marker_id != wanted->marker_id) return call->answer(unknown_drag(wanted->drag_id));
  jobs::Job job{.session = call->session()->id,
                .lane = drag->id,
                .caller = call->stop(),
                .work = jobs::Work{[this, drag, call, wanted = *std::move(wanted)](const std::stop_token& stop) {
                  serve(*drag, stop);  // a move that is still in the mailbox
                  call->answer(finish(*drag, wanted, {*call, stop}));
                }}};
  // Out of the list first, so that it takes no move and no other end; back into it when there is no room for the end.
  {
    const std::lock_guard lock{mutex_};
    if (drags_.erase(drag->id) == 0) return call->answer(unknown_drag(drag->id));
  }
  const jobs::Admission admission = queue_.submit(job);
  if (admission == jobs::Admission::kAccepted) return;
  {
    const std::lock_guard lock{mutex_};
    drags_.emplace(drag->id, drag);
  }
  call->answer(refused(admission, queue_));
}

calls::Outcome Drags::finish(Held& drag, const protocol::methods::readings::DragEnd& wanted, const CallTurn& turn) {
  const Marker& start = drag.base.file->marker;
  const Marker& latest = drag.latest ? *drag.latest : start;
  MarkerFile after = protocol::edits::with_marker(*drag.base.file, latest);
  const Json fields = protocol::edits::change_json(*drag.base.file, after);
  if (!wanted.commit || latest == start) {
    if (turn.call.left().stop_requested() || !turn.call.settle()) return calls::nobody_waits();
    return methods_.unchanged("drag.end", drag.marker_id, wanted.op_id,
                              protocol::methods::result_json(drag.marker_id, drag.base.revision, fields));
  }
  return methods_.commit(
      {"drag.end", drag.marker_id, drag.base, std::move(after), store::Origin::kChange, wanted.op_id, fields}, turn);
}

}  // namespace selvage::server::methods
