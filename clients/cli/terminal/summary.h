// What a motion came to, as one line of JSON for programs and a few lines for people.
#pragma once

#include <string>

#include "core/marker/validity.h"
#include "core/minkowski/cache.h"
#include "protocol/execution/stage_times.h"
#include "protocol/json/json_text.h"

namespace selvage::cli::terminal {

// One line, ending in a newline: the fields of a motion's answer but for the placements, named in snake_case,
// with the times and the cache's counts.
[[nodiscard]] std::string json_line(const Json& fields, const protocol::execution::StageTimes& times,
                                    const minkowski::CacheCounts& cache);
// The same for people.  REQUIRES: the fields of a motion's answer; `marker`: of it.
[[nodiscard]] std::string plain_summary(const Json& fields, const protocol::execution::StageTimes& times,
                                        const Marker& marker);

// A marker's own figures: "jeans: 120 pieces, length 7238 mm, utilisation 80.79 %".
[[nodiscard]] std::string plain_figures(const Marker& marker);
// The list of what is wrong, one line each; empty when valid.  REQUIRES: the fields of marker.check's answer.
[[nodiscard]] std::string plain_faults(const Marker& marker, const Json& validity);

// A revision of a watched marker: "revision 3: length 7174.72, utilisation 81.4991 %, valid; motion.compact".
// REQUIRES: what marker.changed tells, "by" aside.
[[nodiscard]] std::string plain_change(const Json& figures);

}  // namespace selvage::cli::terminal
