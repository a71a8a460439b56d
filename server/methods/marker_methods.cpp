// The methods about markers as a whole: marker.open, marker.list, marker.get and marker.close.
#include <optional>
#include <utility>

#include "protocol/calls/answer.h"
#include "protocol/calls/piece_state.h"
#include "protocol/files/writing.h"
#include "protocol/methods/daemon/engine.h"
#include "protocol/methods/daemon/markers.h"
#include "protocol/methods/readings/get.h"
#include "server/calls/errors.h"
#include "server/methods/method_groups.h"

namespace selvage::server::methods {
namespace {

namespace daemon = protocol::methods::daemon;
namespace schema = protocol::schema;
using protocol::methods::readings::GetParams;

// The answer to a call that opens a connection's marker is not kept: sent again on another connection, it opens a new
// one.
calls::Outcome open(daemon::OpenParams& params, const ServerContext& server, calls::OpenCall& call) {
  const bool of_connection = params.close_with_connection;
  if (of_connection && !call.session()->notify) return calls::no_connection_to_close_with();
  if (of_connection) params.op_id.reset();
  if (const auto earlier = server.committer.earlier_answer("", params.op_id, "marker.open", call)) return *earlier;
  if (call.abandoned() || !call.settle()) return calls::abandoned();
  Json result;
  const auto opened = server.store.open(
      std::move(params.file),
      [&](const store::OpenMarker& marker) -> std::optional<store::KeptAnswer> {
        result = schema::encode(daemon::opened(marker.id, marker.now.revision, *marker.now.file));
        if (!params.op_id) return std::nullopt;
        return changes::Committer::kept_answer(
            *params.op_id, "marker.open", std::make_shared<const std::string>(protocol::json::to_text(result)), call);
      },
      of_connection ? store::Owner::kConnection : store::Owner::kDaemon);
  if (const auto* why = std::get_if<store::NotOpened>(&opened)) {
    switch (*why) {
      case store::NotOpened::kTooLarge: return calls::marker_too_large(server.store);
      case store::NotOpened::kNoRoom: return calls::no_room(server.store);
      case store::NotOpened::kNotWritten: return calls::not_written();
    }
  }
  if (of_connection) server.connection_markers.add(std::get<store::OpenMarker>(opened).id, *call.session());
  return result;
}

daemon::ListedMarker listed(store::ListedMarker open) {
  const store::Summary& summary = open.summary;
  return {.at = {std::move(open.id), open.revision},
          .name = summary.name,
          .pieces = summary.pieces,
          .unplaced = summary.unplaced == 0 ? std::nullopt : std::optional{summary.unplaced},
          .length = summary.length,
          .utilisation = summary.utilisation};
}

calls::Outcome list(const daemon::NoParams&, const ServerContext& server, const calls::OpenCall&) {
  daemon::ListResult result;
  for (store::ListedMarker& open : server.store.all()) result.markers.push_back(listed(std::move(open)));
  return schema::encode(result);
}

// The pieces that moved after a revision.  Returns nothing if anything other than placements has changed since then.
std::optional<Json> placements_since(const store::Committed& now, Revision since) {
  if (since < now.stamps->whole || since > now.revision) return std::nullopt;
  const Marker& marker = now.file->marker;
  std::vector<protocol::calls::PieceState> placements;
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
    if (now.stamps->pieces[i] > since) placements.push_back(protocol::calls::state_of(marker, marker.pieces[i]));
  }
  return schema::Wire<decltype(placements)>::write(placements);
}

Json document_json(const std::string& id, Revision revision, protocol::files::FileFormat format, Json document) {
  return protocol::calls::result_json(id, revision,
                                      {{"format", schema::word_of(format)}, {"marker", std::move(document)}});
}

calls::Outcome get(const GetParams& params, const ServerContext& server, const calls::OpenCall& call) {
  const std::string& id = params.marker_id;
  const auto now = server.store.current(id);
  if (!now) return calls::unknown_marker(server.store, id);
  if (params.format != protocol::files::FileFormat::kNative) {
    if (call.abandoned()) return calls::abandoned();
    auto document = protocol::files::marker_document(*now->file, params.format);
    if (!document) return protocol::rpc::rpc_error(document.error());
    Json json = document_json(id, now->revision, params.format, *std::move(document));
    const auto lost = protocol::methods::readings::notes_on_losses(*now->file, params.format);
    if (!lost.empty()) json["notes"] = schema::Wire<std::vector<protocol::calls::Note>>::write(lost);
    return json;
  }
  if (params.since) {
    if (auto placements = placements_since(*now, *params.since)) {
      return protocol::calls::result_json(id, now->revision,
                                          {{"since", *params.since}, {"placements", *std::move(placements)}});
    }
  }
  return now->text->get([&] {
    return protocol::json::to_text(
        document_json(id, now->revision, protocol::files::FileFormat::kNative,
                      *protocol::files::marker_document(*now->file, protocol::files::FileFormat::kNative)));
  });
}

calls::Outcome close(const daemon::CloseParams& params, const ServerContext& server, calls::OpenCall& call) {
  const std::string& id = params.marker_id;
  const auto text =
      std::make_shared<const std::string>(protocol::json::to_text(schema::encode(daemon::CloseResult{id})));
  if (const auto earlier = server.committer.earlier_answer("", params.op_id, "marker.close", call)) return *earlier;
  if (call.abandoned() || !call.settle()) return calls::abandoned();
  std::optional<store::KeptAnswer> answer;
  if (params.op_id) answer = changes::Committer::kept_answer(*params.op_id, "marker.close", text, call);
  switch (changes::close_marker(server.store, server.watchers, id, answer)) {
    case store::Closed::kUnknown: return calls::unknown_marker(server.store, id);
    case store::Closed::kNotWritten: return calls::not_written();
    case store::Closed::kDone: break;
  }
  server.connection_markers.remove(id);
  return text;
}

}  // namespace

std::vector<HandledMethod> marker_methods() {
  return {{"marker.open", handle_with<daemon::OpenParams, open>, FileUse::kWrites},
          {"marker.list", handle_with<daemon::NoParams, list>},
          {"marker.get", handle_with<GetParams, get>},
          {"marker.close", handle_with<daemon::CloseParams, close>, FileUse::kWrites}};
}

}  // namespace selvage::server::methods
