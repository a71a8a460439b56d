// Messages to JSON and back: the names on the wire (camelCase) and their checks.
//
// A decoder is given a call's params and refuses unknown fields, wrong types and values out of range, `field`
// pointing into the params ("/rounds", "/marker/shapes/0/outline").
#pragma once

#include "core/base/result.h"
#include "core/marker/validity.h"
#include "core/motion/repair/repair.h"
#include "protocol/calls/messages.h"
#include "protocol/execution/stage_times.h"
#include "protocol/json/json_text.h"

namespace selvage::protocol::calls {

// {"markerId"} alone, for the methods that take nothing else.
[[nodiscard]] Result<std::string> decode_marker_id(const Json& params);

struct NoParams {};
[[nodiscard]] Result<NoParams> decode_no_params(const Json& params);  // engine.info
[[nodiscard]] Result<MarkerOpen> decode_marker_open(const Json& params);
[[nodiscard]] Result<MarkerClose> decode_marker_close(const Json& params);

[[nodiscard]] Json encode(const EngineInfo& info);
[[nodiscard]] Json encode(const MarkerOpened& opened);
[[nodiscard]] Json encode(const MarkerClosed& closed);

// [{"first", "second", "witness": [x, y], "depth"}], pieces by their ids, distances in the marker's unit.
[[nodiscard]] Json overlaps_json(const Marker& marker, const std::vector<marker::Overlap>& overlaps);
// {"valid", "overlaps", "protrusions": [{"piece", "by"}]}
[[nodiscard]] Json validity_json(const Marker& marker, const marker::Validity& validity);

// [{"id", "at", "rotation", "flip", "tilt"}] of the pieces whose placement differs, or that are new.  Pieces that are
// gone are not told of.  REQUIRES: pieces in the same order.
[[nodiscard]] Json changed_placements(const Marker& before, const Marker& after);

// {"pairs", "protruding", "deepest", "farthestMove", "lengthened"}, lengths in the marker's unit.
[[nodiscard]] Json repair_json(const motion::repair::Repair& repair, Resolution resolution);

[[nodiscard]] Json encode(const minkowski::CacheCounts& cache);
[[nodiscard]] Json encode(const execution::StageTimes& times);
[[nodiscard]] Json encode(const std::vector<Note>& notes);

}  // namespace selvage::protocol::calls
