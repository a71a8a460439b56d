#include "server/changes/committer.h"

#include <memory>
#include <utility>

#include "protocol/edits/changes.h"
#include "server/calls/errors.h"

namespace selvage::server::changes {
namespace {

std::string changed_message(const ReadyChange& change, const MarkerFile& before, const store::Committed& after) {
  const protocol::edits::ChangedNotification params{{change.marker_id, after.revision},
                                                    std::string{change.method},
                                                    protocol::edits::change_between(before, *after.file)};
  return protocol::json::to_text(protocol::rpc::notification("marker.changed", protocol::schema::encode(params)));
}

}  // namespace

std::optional<calls::Outcome> Committer::earlier_answer(const std::string& marker_id,
                                                        const std::optional<std::string>& op_id,
                                                        std::string_view method, const calls::OpenCall& call) const {
  if (!op_id) return std::nullopt;
  const auto kept = store_.answer(marker_id, *op_id);
  if (!kept) return std::nullopt;
  // Stores of earlier versions have no checksum of the parameters.
  const bool same_params = kept->params == 0 || kept->params == call.params();
  if (kept->method == method && same_params) return kept->result;
  const std::string with = kept->method == method ? " with other parameters" : "";
  return protocol::rpc::rpc_error(
      Error{ErrorCode::kOutOfRange,
            protocol::json::shortened(Json(*op_id)) + " was the opId of a call of " + kept->method + with, "/opId"});
}

store::KeptAnswer Committer::kept_answer(const std::string& op_id, std::string_view method, store::SharedText result,
                                         const calls::OpenCall& call) {
  const transport::access::Session& session = *call.session();
  // Each connection from an address has a port of its own, so the port is left out.
  std::string client = session.peer.substr(0, session.peer.rfind(':'));
  client += store::KeptAnswers::kConnection + std::to_string(session.id);
  return {.op_id = op_id,
          .method = std::string{method},
          .result = std::move(result),
          .client = std::move(client),
          .params = call.params()};
}

calls::Outcome Committer::commit(ReadyChange change, calls::OpenCall& call) {
  const Revision base = change.before.revision;
  const auto text = std::make_shared<const std::string>(protocol::json::to_text(change.result));
  store::NextRevision next{std::move(change.after), change.origin, {}, {}};
  if (change.op_id) next.answer = kept_answer(*change.op_id, change.method, text, call);
  next.on_committed = [&](const store::Committed& after) {
    if (!watchers_.any(change.marker_id)) return;
    watchers_.notify(change.marker_id, changed_message(change, *change.before.file, after));
  };
  if (call.abandoned() || !call.settle()) return calls::abandoned();
  const store::Commit commit = store_.commit(change.marker_id, base, std::move(next));
  switch (commit.outcome) {
    case store::Commit::Outcome::kClosed: return calls::unknown_marker(store_, change.marker_id);
    case store::Commit::Outcome::kMismatch: return calls::revision_mismatch(change.marker_id, base, commit.revision);
    case store::Commit::Outcome::kTooLarge: return calls::marker_too_large(store_);
    case store::Commit::Outcome::kNoRoom: return calls::no_room(store_);
    case store::Commit::Outcome::kNotWritten: return calls::not_written();
    case store::Commit::Outcome::kDone: break;
  }
  return text;
}

calls::Outcome Committer::keep_unchanged(std::string_view method, const std::string& marker_id,
                                         const std::optional<std::string>& op_id, Json result,
                                         const calls::OpenCall& call) {
  if (!op_id) return result;
  const auto text = std::make_shared<const std::string>(protocol::json::to_text(result));
  switch (store_.keep(marker_id, kept_answer(*op_id, method, text, call))) {
    case store::Kept::kNoRoom: return calls::no_room(store_);
    case store::Kept::kNotWritten: return calls::not_written();
    case store::Kept::kDone: break;
  }
  return text;
}

}  // namespace selvage::server::changes
