#include "protocol/marker_methods.h"

#include <algorithm>
#include <vector>

#include "protocol/codec.h"
#include "protocol/methods/families.h"

namespace selvage {
namespace {

std::vector<MarkerMethod> all_families() {
  std::vector<MarkerMethod> all;
  for (const auto family : {reading_methods(), holding_methods(), region_methods(), compaction_methods(),
                            pushing_methods(), bumping_methods(), placing_methods(), separation_methods(),
                            floating_methods(), gap_methods(), tilting_methods(), baseline_methods()}) {
    all.insert(all.end(), family.begin(), family.end());
  }
  return all;
}

}  // namespace

std::span<const MarkerMethod> marker_methods() {
  static const std::vector<MarkerMethod> kAll = all_families();
  return kAll;
}

const MarkerMethod* find_marker_method(std::string_view name) {
  const auto all = marker_methods();
  const auto found =
      std::find_if(all.begin(), all.end(), [name](const MarkerMethod& method) { return method.name == name; });
  return found == all.end() ? nullptr : &*found;
}

Json result_json(const std::string& marker_id, Revision revision, const Json& fields) {
  Json result{{"markerId", marker_id}, {"revision", revision}};
  result.update(fields);
  return result;
}

void tell_times(Json& fields, const StageTimes& times, const CacheCounts& cache) {
  fields["ms"] = encode(times);
  fields["cache"] = encode(cache);
}

RpcCode code_of_run(const MarkerMethod& method, const Error& error) {
  constexpr int kFirstOfShapes = 1100;  // below it are the mistakes of parameters
  const bool refused = method.motion() && static_cast<int>(error.code) >= kFirstOfShapes;
  return refused || error.code == ErrorCode::kStoppedEarly ? RpcCode::kMotionRefused : RpcCode::kInvalidParams;
}

}  // namespace selvage
