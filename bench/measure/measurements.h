// What this program measures.  Every function prints comma-separated lines under a heading, `cores` a Markdown table.
#pragma once

#include <string>
#include <vector>

namespace selvage::bench::measure {

using Paths = std::vector<std::string>;

// Time against length for every setting of compaction, refinement and tilting.
void settings(const Paths& paths);

// Simplification of pieces with many vertices, with an empty cache of sums and with a full one.
void digitised(const Paths& paths);

// The best length at a deadline.
void anytime(const Paths& paths);

// How much shorter than `standard` the search of `fine` makes each marker in 1, 10 and 60 s.
void searched(const Paths& paths);

// The size of each motion's programs, on tiles of the first marker.
void scene(const Paths& paths);

// How time grows with the number of pieces, by stages, on tiles of each marker.
void growth(const Paths& paths);

// The gain from a second thread.
void cores(const Paths& paths);

}  // namespace selvage::bench::measure
