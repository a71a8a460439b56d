#include "clients/cli/run/by_hand.h"

#include <utility>

#include "protocol/calls/codec.h"
#include "protocol/edits/changes.h"

namespace selvage::cli::run {
namespace {

Result<protocol::calls::MarkerCall> read_apply(const Json& params) {
  auto read = protocol::edits::decode_marker_apply(params);
  if (!read) return read.error();
  protocol::calls::MarkerCall call;
  call.about.marker_id = std::move(read->call.marker_id);
  call.about.base_revision = read->call.base_revision;
  return call;
}

}  // namespace

const protocol::calls::MarkerMethod& apply_method() {
  static const protocol::calls::MarkerMethod method{.name = "marker.apply", .read = &read_apply};
  return method;
}

std::variant<Ran, Refusal> apply_here(const Task& task) {
  const auto wanted = protocol::edits::decode_marker_apply(task.params);
  if (!wanted) return refusal_of(wanted.error());
  auto after = apply_edits(task.file, wanted->edits);
  if (!after) return refusal_of(after.error());
  Json fields = protocol::edits::change_json(task.file, *after);
  if (!after->notes.empty()) fields["notes"] = protocol::calls::encode(after->notes);
  const bool changed = !fields["placements"].empty() || !fields["removed"].empty() || fields.contains("whole");
  return Ran{task.call.about.marker_id, changed ? kFirstRevision + 1 : kFirstRevision,
             std::move(fields),         protocol::execution::StageTimes{},
             minkowski::CacheCounts{},  *std::move(after)};
}

}  // namespace selvage::cli::run
