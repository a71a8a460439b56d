#include "protocol/methods/daemon/engine.h"

#include "core/geometry/polygon.h"
#include "core/marker/marker.h"
#include "protocol/calls/method.h"
#include "protocol/json/json_text.h"
#include "protocol/rpc/json_rpc.h"

namespace selvage::protocol::methods::daemon {
namespace {

// The OpenRPC document of all methods.
struct DiscoverResult {
  std::string openrpc;
  calls::DocumentView info;
  std::vector<calls::DocumentView> methods;
  calls::DocumentView components;
  std::vector<calls::DocumentView> notifications;

  static void describe(auto& v, auto& self) {
    v.required("openrpc", self.openrpc, "The version of OpenRPC.");
    v.required("info", self.info, "Title and version.");
    v.required("methods", self.methods, "All methods.");
    v.required("components", self.components, "The types that the methods use.");
    v.required("x-notifications", self.notifications, "The notifications that the daemon sends.");
  }
};

template <class Enum>
std::vector<Enum> all_values() {
  std::vector<Enum> all;
  for (std::size_t k = 0; k < std::size(schema::Choices<Enum>::kWords); ++k) all.push_back(static_cast<Enum>(k));
  return all;
}

}  // namespace

Limits protocol_limits(std::size_t request_bytes) {
  Limits limits;
  limits.request_bytes = request_bytes;
  limits.batch = rpc::kMaxBatch;
  limits.depth = json::kMaxDepth;
  limits.values = json::most_values(request_bytes);
  limits.pieces = marker::kMaxPieces;
  limits.vertices = geometry::kMaxVertices;
  return limits;
}

EngineInfo engine_info(std::size_t request_bytes) {
  EngineInfo info;
  info.reads = {std::begin(files::kReadFormats), std::end(files::kReadFormats)};
  info.writes = all_values<files::FileFormat>();
  info.accuracies = all_values<motion::compaction::Accuracy>();
  info.limits = protocol_limits(request_bytes);
  return info;
}

calls::Method engine_info_method() {
  return calls::served_method<NoParams, EngineInfo>("engine.info", calls::MethodKind::kImmediate,
                                                    "Describes this server and its limits.");
}

calls::Method discover_method() {
  return calls::served_method<NoParams, DiscoverResult>("rpc.discover", calls::MethodKind::kImmediate,
                                                        "Returns this description.");
}

calls::Method cancel_method() {
  return calls::served_method<CancelParams, CancelResult>("$/cancelRequest", calls::MethodKind::kImmediate,
                                                          "Ends a call in progress.");
}

}  // namespace selvage::protocol::methods::daemon
