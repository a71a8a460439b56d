// The methods of the library: library.add, .get, .list, .remove and .search.
#include <utility>

#include "core/marker/validity.h"
#include "protocol/json/json_text.h"
#include "protocol/methods/library/entries.h"
#include "server/calls/errors.h"
#include "server/methods/method_groups.h"

namespace selvage::server::methods {
namespace {

using protocol::methods::library::LibraryAddParams;
using protocol::methods::library::LibraryAddResult;
using protocol::methods::library::LibraryEntry;
using protocol::methods::library::LibraryGetResult;
using protocol::methods::library::LibraryIdParams;
using protocol::methods::library::LibraryListParams;
using protocol::methods::library::LibraryListResult;
using protocol::methods::library::LibraryRemoveResult;
using protocol::methods::library::LibrarySearchParams;
using protocol::methods::library::LibrarySearchResult;
using protocol::rpc::RpcCode;
using protocol::rpc::RpcError;

LibraryEntry described(const library::Entry& entry) {
  return {.id = id_of(entry),
          .name = entry.name,
          .style = entry.style,
          .unit = entry.signature.unit,
          .pieces = static_cast<std::size_t>(entry.signature.pieces),
          .width = entry.signature.width,
          .spacing = entry.signature.spacing,
          .length = entry.length,
          .utilisation = entry.utilisation};
}

RpcError unknown_stored(const std::string& id) {
  return protocol::rpc::rpc_error(Error{ErrorCode::kOutOfRange,
                                        protocol::json::shortened(Json(id)) + " is not in the library; the ids "
                                                                              "that library.list returns are allowed",
                                        "/id"});
}

calls::Outcome add_to_library(const LibraryAddParams& params, const ServerContext& server, calls::OpenCall& call) {
  const auto now = server.store.current(params.marker_id);
  if (!now) return calls::unknown_marker(server.store, params.marker_id);
  const Marker& marker = now->file->marker;
  if (piece_count(marker) < marker.pieces.size()) {
    return protocol::rpc::rpc_error(
        Error{ErrorCode::kOutOfRange,
              "the marker has zones, which describe one roll of cloth; only markers without zones can be stored",
              "/markerId"},
        RpcCode::kMotionRefused);
  }
  if (marker.pieces.empty() || !marker.unplaced.empty() || !is_valid(marker)) {
    return protocol::rpc::rpc_error(
        Error{ErrorCode::kOutOfRange, "only a valid marker with all of its pieces placed can be stored", "/markerId"},
        RpcCode::kMotionRefused);
  }
  if (call.abandoned() || !call.settle()) return calls::abandoned();
  const auto added = server.library.add(*now->file, params.style);
  if (const auto* why = std::get_if<library::NotAdded>(&added)) {
    if (*why == library::NotAdded::kLimit)
      return calls::limit_reached("too many stored markers", server.library.limit());
    return calls::not_written();
  }
  const auto& done = std::get<library::Added>(added);
  return protocol::schema::encode(LibraryAddResult{described(done.entry), done.fresh});
}

calls::Outcome get_from_library(const LibraryIdParams& params, const ServerContext& server, const calls::OpenCall&) {
  const auto number = library::number_of(params.id);
  const auto entry = number ? server.library.find(*number) : std::nullopt;
  if (!entry) return unknown_stored(params.id);
  const auto text = server.library.document(*number);
  auto document = text ? protocol::json::parse(*text) : Error{ErrorCode::kFile, "its row is damaged", ""};
  if (!document) {
    return RpcError{RpcCode::kInternalError, "the stored marker " + params.id + " is damaged in the store", {}};
  }
  return protocol::schema::encode(LibraryGetResult{described(*entry), {*std::move(document)}});
}

calls::Outcome list_library(const LibraryListParams& params, const ServerContext& server, const calls::OpenCall&) {
  LibraryListResult result{.count = server.library.count(), .markers = {}};
  for (const library::Entry& entry : server.library.list(params.offset, params.most)) {
    result.markers.push_back(described(entry));
  }
  return protocol::schema::encode(result);
}

calls::Outcome remove_from_library(const LibraryIdParams& params, const ServerContext& server, calls::OpenCall& call) {
  const auto number = library::number_of(params.id);
  if (!number || !server.library.find(*number)) return unknown_stored(params.id);
  if (call.abandoned() || !call.settle()) return calls::abandoned();
  switch (server.library.remove(*number)) {
    case library::Removed::kUnknown: return unknown_stored(params.id);
    case library::Removed::kNotWritten: return calls::not_written();
    case library::Removed::kDone: break;
  }
  return protocol::schema::encode(LibraryRemoveResult{params.id});
}

calls::Outcome search_library(const LibrarySearchParams& params, const ServerContext& server, const calls::OpenCall&) {
  const auto now = server.store.current(params.marker_id);
  if (!now) return calls::unknown_marker(server.store, params.marker_id);
  LibrarySearchResult result;
  for (const library::Near& near : server.library.search(now->file->marker, params.most)) {
    result.near.push_back({described(near.entry), near.distance});
  }
  return protocol::schema::encode(result);
}

}  // namespace

std::vector<HandledMethod> library_methods() {
  return {{"library.add", handle_with<LibraryAddParams, add_to_library>},
          {"library.get", handle_with<LibraryIdParams, get_from_library>},
          {"library.list", handle_with<LibraryListParams, list_library>},
          {"library.remove", handle_with<LibraryIdParams, remove_from_library>},
          {"library.search", handle_with<LibrarySearchParams, search_library>}};
}

}  // namespace selvage::server::methods
