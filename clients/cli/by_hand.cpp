#include "clients/cli/by_hand.h"

#include <utility>

#include "protocol/changes.h"
#include "protocol/codec.h"

namespace selvage {
namespace {

Result<MarkerCall> read_apply(const Json& params) {
  auto read = decode_marker_apply(params);
  if (!read) return read.error();
  MarkerCall call;
  call.about.marker_id = std::move(read->call.marker_id);
  call.about.base_revision = read->call.base_revision;
  return call;
}

}  // namespace

const MarkerMethod& apply_method() {
  static const MarkerMethod method{.name = "marker.apply", .read = &read_apply};
  return method;
}

std::variant<Ran, Refusal> apply_here(const Task& task) {
  const auto wanted = decode_marker_apply(task.params);
  if (!wanted) return refusal_of(wanted.error());
  auto after = apply_edits(task.file, wanted->edits);
  if (!after) return refusal_of(after.error());
  Json fields = change_json(task.file, *after);
  if (!after->notes.empty()) fields["notes"] = encode(after->notes);
  const bool changed = !fields["placements"].empty() || !fields["removed"].empty() || fields.contains("whole");
  return Ran{task.call.about.marker_id,
             changed ? kFirstRevision + 1 : kFirstRevision,
             std::move(fields),
             StageTimes{},
             CacheCounts{},
             *std::move(after)};
}

}  // namespace selvage
