#include "clients/cli/run/marker_apply.h"

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

std::variant<Outcome, terminal::Failure> apply_locally(const Invocation& invocation) {
  const auto wanted = protocol::edits::decode_marker_apply(invocation.params);
  if (!wanted) return terminal::failure_of(wanted.error());
  auto after = apply_edits(invocation.file, wanted->edits);
  if (!after) return terminal::failure_of(after.error());
  Json fields = protocol::edits::change_json(invocation.file, *after);
  if (!after->notes.empty()) fields["notes"] = protocol::calls::encode(after->notes);
  const bool changed = !fields["placements"].empty() || !fields["removed"].empty() || fields.contains("whole");
  return Outcome{invocation.call.about.marker_id,
                 changed ? kFirstRevision + 1 : kFirstRevision,
                 std::move(fields),
                 protocol::execution::StageTimes{},
                 minkowski::CacheCounts{},
                 *std::move(after)};
}

}  // namespace selvage::cli::run
