// What a compaction came to, as one line of JSON for programs and a few lines for people.
#pragma once

#include <string>

#include "core/marker/validity.h"
#include "protocol/messages.h"

namespace selvage {

// One line, ending in a newline: the fields of `selvage compact --json`.
[[nodiscard]] std::string json_line(const CompactionFigures& figures);
[[nodiscard]] std::string plain_summary(const CompactionFigures& figures, const Marker& marker);

// A marker's own figures: "jeans: 120 pieces, length 7238 mm, utilisation 80.79 %".
[[nodiscard]] std::string plain_figures(const Marker& marker);
// The list of what is wrong, one line each; empty when valid.
[[nodiscard]] std::string plain_faults(const Marker& marker, const Validity& validity);

}  // namespace selvage
