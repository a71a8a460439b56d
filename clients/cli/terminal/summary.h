// The result of a command as text: one line of JSON for programs, or a few lines for people.
#pragma once

#include <string>

#include "clients/cli/terminal/style.h"
#include "core/marker/validity.h"
#include "core/minkowski/cache.h"
#include "protocol/execution/stage_times.h"
#include "protocol/json/json_text.h"

namespace selvage::cli::terminal {

// One line, ending in a newline: the fields of a motion's result without the placements, with names in snake_case,
// followed by the times and the cache's counts.
[[nodiscard]] std::string json_line(const Json& fields, const protocol::execution::StageTimes& times,
                                    const minkowski::CacheCounts& cache);
// The same in a few readable lines.  REQUIRES: `fields` is the result of a motion on `marker`.
[[nodiscard]] std::string plain_summary(const Json& fields, const protocol::execution::StageTimes& times,
                                        const Marker& marker, const Style& style);

// The figures of a marker: "jeans: 120 pieces, length 7238 mm, utilisation 80.79 %".
[[nodiscard]] std::string plain_figures(const Marker& marker);
// One line for each overlap and protrusion; empty when the marker is valid.  REQUIRES: `validity` is the result of
// marker.check.
[[nodiscard]] std::string plain_violations(const Marker& marker, const Json& validity);

// A revision of a watched marker: "revision 3: length 7174.72, utilisation 81.50 %, valid; motion.compact".
// REQUIRES: the fields of marker.changed; "by" may be absent.
[[nodiscard]] std::string plain_change(const Json& figures);

}  // namespace selvage::cli::terminal
