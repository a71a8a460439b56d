#include "protocol/methods/marker_methods.h"

#include <algorithm>
#include <vector>

#include "protocol/calls/codec.h"
#include "protocol/methods/motions/families.h"
#include "protocol/methods/readings/families.h"

namespace selvage::protocol::methods {
namespace {

std::vector<calls::MarkerMethod> all_families() {
  std::vector<calls::MarkerMethod> all;
  for (const auto family : {readings::reading_methods(), readings::holding_methods(), readings::region_methods(),
                            motions::compaction_methods(), motions::pushing_methods(), motions::bumping_methods(),
                            motions::placing_methods(), motions::separation_methods(), motions::floating_methods(),
                            motions::gap_methods(), motions::tilting_methods(), motions::baseline_methods()}) {
    all.insert(all.end(), family.begin(), family.end());
  }
  return all;
}

}  // namespace

std::span<const calls::MarkerMethod> marker_methods() {
  static const std::vector<calls::MarkerMethod> kAll = all_families();
  return kAll;
}

const calls::MarkerMethod* find_marker_method(std::string_view name) {
  const auto all = marker_methods();
  const auto found =
      std::find_if(all.begin(), all.end(), [name](const calls::MarkerMethod& method) { return method.name == name; });
  return found == all.end() ? nullptr : &*found;
}

Json result_json(const std::string& marker_id, Revision revision, const Json& fields) {
  Json result{{"markerId", marker_id}, {"revision", revision}};
  result.update(fields);
  return result;
}

void tell_times(Json& fields, const execution::StageTimes& times, const minkowski::CacheCounts& cache) {
  fields["ms"] = calls::encode(times);
  fields["cache"] = calls::encode(cache);
}

rpc::RpcCode code_of_run(const calls::MarkerMethod& method, const Error& error) {
  constexpr int kFirstOfShapes = 1100;  // below it are the mistakes of parameters
  const bool refused = method.motion() && static_cast<int>(error.code) >= kFirstOfShapes;
  return refused || error.code == ErrorCode::kStoppedEarly ? rpc::RpcCode::kMotionRefused
                                                           : rpc::RpcCode::kInvalidParams;
}

}  // namespace selvage::protocol::methods
