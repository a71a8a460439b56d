// The methods about markers as a whole: marker.open, marker.list, marker.get and marker.close.
#include <utility>

#include "core/marker/validity.h"
#include "protocol/calls/codec.h"
#include "protocol/edits/changes.h"
#include "protocol/methods/marker_methods.h"
#include "protocol/methods/readings/reading.h"
#include "server/calls/errors.h"
#include "server/methods/method_groups.h"

namespace selvage::server::methods {
namespace {

using protocol::calls::MarkerClose;
using protocol::calls::MarkerOpen;
using protocol::methods::readings::MarkerGet;

Json opened_json(const store::OpenMarker& opened) {
  const MarkerFile& file = *opened.now.file;
  protocol::calls::MarkerOpened answer;
  answer.marker_id = opened.id;
  answer.revision = opened.now.revision;
  answer.pieces = file.marker.pieces.size();
  answer.length = to_decimal(length_of(file.marker), file.marker.resolution);
  answer.utilisation = utilisation_of(file.marker);
  answer.valid = is_valid(file.marker);
  answer.notes = file.notes;
  return protocol::calls::encode(answer);
}

Json listed_json(const store::OpenMarker& open) {
  const Marker& marker = open.now.file->marker;
  return {{"markerId", open.id},
          {"revision", open.now.revision},
          {"name", marker.name},
          {"pieces", marker.pieces.size()},
          {"length", to_decimal(length_of(marker), marker.resolution)},
          {"utilisation", utilisation_of(marker)}};
}

// The pieces that moved after a revision.  Nothing if more than placements has changed since.
std::optional<Json> placements_since(const store::Committed& now, Revision since) {
  if (since < now.stamps->whole || since > now.revision) return std::nullopt;
  const Marker& marker = now.file->marker;
  Json placements = Json::array();
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
    if (now.stamps->pieces[i] > since) placements.push_back(protocol::edits::placement_json(marker, marker.pieces[i]));
  }
  return placements;
}

// A marker that takes about 10 ms and more to write.
bool is_large(const store::MarkerStore& store, const std::string& id) {
  constexpr std::size_t kManyVertices = 20'000;
  const auto now = store.current(id);
  if (!now) return false;
  const Marker& marker = now->file->marker;
  std::size_t vertices = 0;
  for (const Piece& piece : marker.pieces) vertices += marker.shapes[piece.shape.value].outline.size();
  return vertices > kManyVertices;
}

calls::Outcome open(MarkerOpen& request, const ServerContext& server, calls::OpenCall& call) {
  if (const auto earlier = server.committer.earlier_answer("", request.op_id, "marker.open")) return *earlier;
  if (call.abandoned() || !call.settle()) return calls::abandoned();
  Json result;
  const auto opened = server.store.open(
      std::move(request.file), [&](const store::OpenMarker& marker) -> std::optional<store::KeptAnswer> {
        result = opened_json(marker);
        if (!request.op_id) return std::nullopt;
        return store::KeptAnswer{*request.op_id, "marker.open",
                                 std::make_shared<const std::string>(protocol::json::to_text(result))};
      });
  if (const auto* why = std::get_if<store::NotOpened>(&opened)) {
    if (*why == store::NotOpened::kLimit) return calls::limit_reached("too many open markers", server.store.limit());
    return calls::not_written();
  }
  return result;
}

calls::Outcome list(const protocol::calls::NoParams&, const ServerContext& server, const calls::OpenCall&) {
  Json markers = Json::array();
  for (const store::OpenMarker& open : server.store.all()) markers.push_back(listed_json(open));
  return Json{{"markers", std::move(markers)}};
}

Json document_json(const std::string& id, Revision revision, Format format, Json document) {
  return protocol::methods::result_json(id, revision, {{"format", name_of(format)}, {"marker", std::move(document)}});
}

calls::Outcome get(const MarkerGet& request, const ServerContext& server, const calls::OpenCall& call) {
  const std::string& id = request.marker_id;
  const auto now = server.store.current(id);
  if (!now) return calls::unknown_marker(id);
  if (request.format != Format::kNative) {
    if (call.abandoned()) return calls::abandoned();
    auto document = protocol::formats::marker_document(*now->file, request.format);
    if (!document) return protocol::rpc::rpc_error(document.error());
    return document_json(id, now->revision, request.format, *std::move(document));
  }
  if (request.since) {
    if (auto placements = placements_since(*now, *request.since)) {
      return Json{{"markerId", id},
                  {"revision", now->revision},
                  {"since", *request.since},
                  {"placements", *std::move(placements)}};
    }
  }
  return now->text->get([&] {
    return protocol::json::to_text(document_json(id, now->revision, Format::kNative,
                                                 *protocol::formats::marker_document(*now->file, Format::kNative)));
  });
}

calls::Outcome close(const MarkerClose& request, const ServerContext& server, calls::OpenCall& call) {
  const std::string& id = request.marker_id;
  const auto text = std::make_shared<const std::string>(
      protocol::json::to_text(protocol::calls::encode(protocol::calls::MarkerClosed{id})));
  if (const auto earlier = server.committer.earlier_answer("", request.op_id, "marker.close")) {
    const auto* kept = std::get_if<store::SharedText>(&*earlier);
    if (!kept || **kept == *text) return *earlier;
    return protocol::rpc::rpc_error(
        Error{ErrorCode::kOutOfRange,
              protocol::json::shortened(Json(*request.op_id)) + " was the opId of a call that closed another marker",
              "/opId"});
  }
  if (call.abandoned() || !call.settle()) return calls::abandoned();
  std::optional<store::KeptAnswer> answer;
  if (request.op_id) answer = store::KeptAnswer{*request.op_id, "marker.close", text};
  const auto on_closed = [&] {
    server.watchers.notify_and_remove(
        id, protocol::json::to_text(protocol::rpc::notification("marker.closed", {{"markerId", id}})));
  };
  if (!server.store.close(id, answer, on_closed)) return calls::unknown_marker(id);
  return text;
}

Result<ParsedCall> decode_get(const Json& params, const ServerContext& server) {
  auto call = decode_and_run<protocol::methods::readings::decode_marker_get, get>(params, server);
  if (call) call->on_large_marker = is_large(server.store, call->marker_id);
  return call;
}

}  // namespace

std::vector<Method> marker_methods() {
  using namespace protocol::calls;
  return {{"marker.open", Schedule::kRead, decode_and_run<decode_marker_open, open>},
          {"marker.list", Schedule::kRead, decode_and_run<decode_no_params, list>},
          {"marker.get", Schedule::kRead, decode_get},
          {"marker.close", Schedule::kRead, decode_and_run<decode_marker_close, close>}};
}

}  // namespace selvage::server::methods
