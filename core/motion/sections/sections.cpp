#include "core/motion/sections/sections.h"

#include <algorithm>
#include <limits>

namespace selvage::motion::sections {
namespace {

// The x of the cuts, from left to right: so far apart that no piece reaches from one to the layer of the next.
std::vector<Coord> cuts_of(const marker::PlacedPieces& pieces, const Cutting& cutting) {
  std::vector<Coord> ends;  // left ends of all pieces
  Coord longest = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Box box = pieces.box(i);
    ends.push_back(box.low.x);
    longest = std::max(longest, box.high.x - box.low.x);
  }
  std::sort(ends.begin(), ends.end());
  std::vector<Coord> cuts;
  const auto first = static_cast<std::size_t>(cutting.offset * static_cast<double>(cutting.pieces));
  for (std::size_t k = first; k < ends.size(); k += cutting.pieces) {
    // A section at an end of the marker has at least a quarter of the usual number of pieces.
    if (std::min(k, ends.size() - k) < cutting.pieces / 4) continue;
    if (cuts.empty() || ends[k] - cuts.back() > longest + cutting.layer) cuts.push_back(ends[k]);
  }
  return cuts;
}

}  // namespace

std::vector<Section> sections_of(const marker::PlacedPieces& pieces, const Cutting& cutting) {
  const std::vector<Coord> cuts = cuts_of(pieces, cutting);
  std::vector<Section> sections(cuts.size() + 1);
  for (std::size_t s = 0; s < cuts.size(); ++s) sections[s + 1].from = cuts[s] + cutting.layer / 2;
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    const Box box = pieces.box(i);
    // The last cut that is left of the piece's right end.
    const auto s = static_cast<std::size_t>(std::lower_bound(cuts.begin(), cuts.end(), box.high.x) - cuts.begin());
    if (s == 0 || box.low.x >= cuts[s - 1] + cutting.layer) {
      sections[s].free.push_back(i);
    } else {
      sections[s - 1].right.push_back(i);
      sections[s].left.push_back(i);
    }
  }
  return sections;
}

}  // namespace selvage::motion::sections
