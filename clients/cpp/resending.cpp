#include "clients/cpp/resending.h"

#include <algorithm>
#include <array>

namespace selvage::client {
namespace {

constexpr std::array<std::string_view, 7> kChanges{"marker.open", "marker.close", "marker.apply", "marker.undo",
                                                   "marker.redo", "marker.nest",  "drag.end"};
constexpr std::array<std::string_view, 8> kReadings{"engine.info", "marker.list",    "marker.get",   "marker.check",
                                                    "marker.hold", "marker.regions", "marker.watch", "marker.unwatch"};

}  // namespace

bool takes_op_id(std::string_view method) {
  return method.starts_with("motion.") || std::find(kChanges.begin(), kChanges.end(), method) != kChanges.end();
}

bool may_resend(std::string_view method) {
  return takes_op_id(method) || std::find(kReadings.begin(), kReadings.end(), method) != kReadings.end();
}

void add_op_id(std::string_view method, Json& params, const std::string& op_id) {
  if (params.is_object() && !params.contains("opId") && takes_op_id(method)) params["opId"] = op_id;
}

}  // namespace selvage::client
