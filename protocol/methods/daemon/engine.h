// engine.info, rpc.discover and $/cancelRequest: about the daemon itself and its calls.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/calls/results.h"
#include "protocol/files/file_format.h"

namespace selvage::protocol::methods::daemon {

struct NoParams {
  static void describe(auto&, auto&) {}
};

struct Limits {
  static constexpr std::string_view kName = "Limits", kMeaning = "The limits of this server.";
  std::size_t request_bytes{}, batch{}, depth{}, values{}, pieces{}, vertices{};
  std::size_t markers_bytes{}, marker_bytes{}, waiting_motions{}, waiting_reads{}, waiting_moves{};
  std::int64_t call_ms{};
  std::size_t drags_per_connection{}, connections{}, calls_per_connection{};

  static void describe(auto& v, auto& self) {
    v.required("requestBytes", self.request_bytes, "Size of a request.");
    v.required("batch", self.batch, "Calls in a batch.");
    v.required("depth", self.depth, "Levels of nesting in a request.");
    v.required("values", self.values, "Numbers, strings, arrays and so on in a request.");
    v.required("pieces", self.pieces, "Pieces of a marker.");
    v.required("vertices", self.vertices, "Vertices of a shape.");
    v.required("markersBytes", self.markers_bytes,
               "Memory for all markers, with their histories and the answers kept for retries.");
    v.required("markerBytes", self.marker_bytes, "Memory of one marker, without these.");
    v.required("waitingMotions", self.waiting_motions, "Motions in the queue.");
    v.required("waitingReads", self.waiting_reads, "Reads in the queue.");
    v.required("waitingMoves", self.waiting_moves, "Moves of drag sessions in the queue.");
    v.required("callMs", self.call_ms,
               "Milliseconds from the arrival of a call that may take long: then it returns its best result so far.");
    v.required("dragsPerConnection", self.drags_per_connection, "Drag sessions of a connection.");
    v.required("connections", self.connections, "Connections.");
    v.required("callsPerConnection", self.calls_per_connection, "Unanswered calls of a connection.");
  }
};
// The limits of the protocol; the server adds its own.
[[nodiscard]] Limits protocol_limits(std::size_t request_bytes);

// The first number changes when clients of an earlier version may break, the second when something is added.
inline constexpr std::string_view kProtocolVersion = "0.3";

struct EngineInfo {
  std::string name{"selvage"}, version;
  std::string_view protocol_version{kProtocolVersion};
  std::vector<std::string_view> methods;
  std::vector<files::FileFormat> reads, writes;
  std::vector<motion::compaction::Accuracy> accuracies;
  std::size_t workers{}, markers{};
  bool durable{};
  std::string instance;
  Limits limits;
  calls::CacheCounts cache;

  static void describe(auto& v, auto& self) {
    v.required("name", self.name, "selvage");
    v.required("version", self.version, "The daemon's version.");
    v.required("protocolVersion", self.protocol_version, "The version of the protocol.");
    v.required("methods", self.methods, "Names of all methods.");
    v.required("reads", self.reads, "Document formats that it reads.");
    v.required("writes", self.writes, "Document formats that it writes.");
    v.required("accuracies", self.accuracies, "The accuracies of motions.");
    v.required("workers", self.workers, "Threads for motions.");
    v.required("markers", self.markers, "Number of open markers.");
    v.required("durable", self.durable, "Whether markers survive the end of the daemon.");
    v.required(
        "instance", self.instance,
        "As long as this is the same, an id names the same marker. It is kept in the store; without a store it is "
        "another one after each start.");
    v.required("limits", self.limits, "The limits of this server.");
    v.required("cache", self.cache, "The cache of Minkowski sums.");
  }
};
// Filled with what the protocol knows: formats, accuracies, methods and its limits.
[[nodiscard]] EngineInfo engine_info(std::size_t request_bytes);

struct CancelParams {
  calls::CallId id;

  static void describe(auto& v, auto& self) {
    v.required("id", self.id, "The id of a call in progress on this connection.");
  }
};
struct CancelResult {
  bool cancelled{};

  static void describe(auto& v, auto& self) {
    v.required("cancelled", self.cancelled, "Whether the request arrived in time.");
  }
};

}  // namespace selvage::protocol::methods::daemon
