// Calls about markers as a whole: opening, listing, reading, watching and closing.
#include <utility>

#include "core/marker/validity.h"
#include "protocol/calls/codec.h"
#include "protocol/edits/changes.h"
#include "protocol/methods/readings/reading.h"
#include "server/calls/refusals.h"
#include "server/methods/methods.h"

namespace selvage::server::methods {
namespace {

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

// What moved after a revision; nothing when more than moves has changed since.
std::optional<Json> placements_since(const store::Committed& now, Revision since) {
  if (since < now.stamps->whole || since > now.revision) return std::nullopt;
  const Marker& marker = now.file->marker;
  Json placements = Json::array();
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
    if (now.stamps->pieces[i] > since) placements.push_back(protocol::edits::placement_json(marker, marker.pieces[i]));
  }
  return placements;
}

// Written in some 10 ms.
constexpr std::size_t kManyVertices = 20'000;

}  // namespace

bool Methods::large(const Json& params) const {
  const auto id = params.is_object() ? params.find("markerId") : params.end();
  if (id == params.end() || !id->is_string()) return false;
  const auto now = store_.current(id->get<std::string>());
  if (!now) return false;
  const Marker& marker = now->file->marker;
  std::size_t vertices = 0;
  for (const Piece& piece : marker.pieces) vertices += marker.shapes[piece.shape.value].outline.size();
  return vertices > kManyVertices;
}

calls::Outcome Methods::marker_open(const Json& params, const CallTurn& turn) {
  auto wanted = protocol::calls::decode_marker_open(params);
  if (!wanted) return protocol::rpc::rpc_error(wanted.error());
  if (const auto again = replay("", wanted->op_id, "marker.open")) return *again;
  if (turn.call.left().stop_requested() || !turn.call.settle()) return calls::nobody_waits();
  Json result;
  const auto opened =
      store_.open(std::move(wanted->file), [&](const store::OpenMarker& marker) -> std::optional<store::KeptAnswer> {
        result = opened_json(marker);
        if (!wanted->op_id) return std::nullopt;
        return store::KeptAnswer{*wanted->op_id, "marker.open",
                                 std::make_shared<const std::string>(protocol::json::to_text(result))};
      });
  if (const auto* why = std::get_if<store::NotOpened>(&opened)) {
    if (*why == store::NotOpened::kLimit) return calls::limit_reached("too many open markers", store_.limit());
    return calls::not_written();
  }
  return result;
}

calls::Outcome Methods::marker_list(const Json& params, const CallTurn&) {
  if (const auto none = protocol::calls::decode_no_params(params); !none) return protocol::rpc::rpc_error(none.error());
  Json markers = Json::array();
  for (const store::OpenMarker& open : store_.all()) markers.push_back(listed_json(open));
  return Json{{"markers", std::move(markers)}};
}

calls::Outcome Methods::marker_get(const Json& params, const CallTurn& turn) {
  const auto wanted = protocol::methods::readings::decode_marker_get(params);
  if (!wanted) return protocol::rpc::rpc_error(wanted.error());
  const auto now = store_.current(wanted->marker_id);
  if (!now) return calls::unknown_marker(wanted->marker_id);
  if (wanted->format != Format::kNative)
    return call_on_marker(*protocol::methods::find_marker_method("marker.get"), params, turn);
  if (wanted->since) {
    if (auto placements = placements_since(*now, *wanted->since)) {
      return Json{{"markerId", wanted->marker_id},
                  {"revision", now->revision},
                  {"since", *wanted->since},
                  {"placements", *std::move(placements)}};
    }
  }
  return now->text->get([&] {
    return protocol::json::to_text(
        protocol::methods::result_json(wanted->marker_id, now->revision,
                                       {{"format", name_of(Format::kNative)},
                                        {"marker", *protocol::formats::marker_document(*now->file, Format::kNative)}}));
  });
}

calls::Outcome Methods::marker_close(const Json& params, const CallTurn& turn) {
  const auto wanted = protocol::calls::decode_marker_close(params);
  if (!wanted) return protocol::rpc::rpc_error(wanted.error());
  const std::string& id = wanted->marker_id;
  const auto text = std::make_shared<const std::string>(
      protocol::json::to_text(protocol::calls::encode(protocol::calls::MarkerClosed{id})));
  if (const auto again = replay("", wanted->op_id, "marker.close")) {
    const auto* kept = std::get_if<store::SharedText>(&*again);
    if (!kept || **kept == *text) return *again;
    return protocol::rpc::rpc_error(
        Error{ErrorCode::kOutOfRange,
              protocol::json::shortened(Json(*wanted->op_id)) + " was the opId of another marker's closing", "/opId"});
  }
  if (turn.call.left().stop_requested() || !turn.call.settle()) return calls::nobody_waits();
  std::optional<store::KeptAnswer> answer;
  if (wanted->op_id) answer = store::KeptAnswer{*wanted->op_id, "marker.close", text};
  const auto tell = [&] {
    watchers_.tell_and_forget(
        id, protocol::json::to_text(protocol::rpc::notification("marker.closed", {{"markerId", id}})));
  };
  if (!store_.close(id, answer, tell)) return calls::unknown_marker(id);
  return text;
}

calls::Outcome Methods::marker_watch(const Json& params, const CallTurn& turn) {
  const auto id = protocol::calls::decode_marker_id(params);
  if (!id) return protocol::rpc::rpc_error(id.error());
  const auto& session = turn.call.session();
  if (!session->notify) return calls::no_notifications();
  if (!store_.current(*id)) return calls::unknown_marker(*id);
  // First watched, then looked at: no revision falls between the two.
  watchers_.watch(*id, session);
  const auto now = store_.current(*id);
  if (!now) {
    (void)watchers_.unwatch(*id, session->id);
    return calls::unknown_marker(*id);
  }
  return Json{{"markerId", *id}, {"revision", now->revision}, {"watching", true}};
}

calls::Outcome Methods::marker_unwatch(const Json& params, const CallTurn& turn) {
  const auto id = protocol::calls::decode_marker_id(params);
  if (!id) return protocol::rpc::rpc_error(id.error());
  const bool did = watchers_.unwatch(*id, turn.call.session()->id);
  return Json{{"markerId", *id}, {"watching", false}, {"watched", did}};
}

}  // namespace selvage::server::methods
