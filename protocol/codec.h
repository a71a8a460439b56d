// Messages to JSON and back: the names on the wire (camelCase) and their checks.
//
// A decoder is given a call's params and refuses unknown fields, wrong types and values out of range, `field`
// pointing into the params ("/rounds", "/marker/shapes/0/outline").
#pragma once

#include "core/base/result.h"
#include "protocol/json_text.h"
#include "protocol/messages.h"

namespace selvage {

struct NoParams {};
[[nodiscard]] Result<NoParams> decode_no_params(const Json& params);  // engine.info
[[nodiscard]] Result<MarkerOpen> decode_marker_open(const Json& params);
[[nodiscard]] Result<MarkerGet> decode_marker_get(const Json& params);
[[nodiscard]] Result<MarkerCheck> decode_marker_check(const Json& params);
[[nodiscard]] Result<MarkerClose> decode_marker_close(const Json& params);
[[nodiscard]] Result<MotionCompact> decode_motion_compact(const Json& params);
[[nodiscard]] Result<MotionPush> decode_motion_push(const Json& params);
[[nodiscard]] Result<MotionGravity> decode_motion_gravity(const Json& params);
[[nodiscard]] Result<MotionBump> decode_motion_bump(const Json& params);

[[nodiscard]] Json encode(const EngineInfo& info);
[[nodiscard]] Json encode(const MarkerOpened& opened);
[[nodiscard]] Json encode(const MarkerClosed& closed);

// {"valid", "overlaps": [{"first", "second", "witness": [x, y], "depth"}], "protrusions": [{"piece", "by"}]},
// pieces by their ids, distances in the marker's unit.
[[nodiscard]] Json validity_json(const Marker& marker, const Validity& validity);

// [{"id", "at", "rotation", "flip", "tilt"}] of the pieces whose placement differs.  REQUIRES: the same
// pieces.
[[nodiscard]] Json changed_placements(const Marker& before, const Marker& after);

// {"pairs", "protruding", "deepest", "farthestMove", "lengthened"}, lengths in the marker's unit.
[[nodiscard]] Json healing_json(const Healing& healing, Resolution resolution);

[[nodiscard]] Json encode(const CacheCounts& cache);
[[nodiscard]] Json encode(const StageTimes& times);
[[nodiscard]] Json encode(const std::vector<Note>& notes);

}  // namespace selvage
