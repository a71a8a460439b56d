// What the messages of the exact searches share: limits, pieces and room, and figures about the
// search.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/marker/marker.h"
#include "core/packing/branching/search.h"
#include "protocol/calls/motion.h"

namespace selvage::protocol::methods::packing {

inline constexpr double kMostNodes = 1e12;
inline constexpr std::uint64_t kStandardNodes = 1'000'000;

// Parameters of every exact search.
struct SearchEffort {
  static constexpr std::string_view kGroup = "search";
  std::optional<std::uint64_t> nodes;
  bool turns{true};

  static void describe(auto& v, auto& self) {
    v.optional("nodes", self.nodes,
               "The largest number of nodes of the search; 1,000,000 when absent, without limit when time is limited.",
               {.range = {{1, kMostNodes}}});
    v.optional("turns", self.turns, "False: pieces keep their orientations.");
  }
};
[[nodiscard]] selvage::packing::branching::WorkLimits limits_of(const SearchEffort& effort,
                                                                const calls::CommonParams& call);

// The pieces of these ids, placed or unplaced (core/packing/bodies/on_cloth.h); all unplaced ones when there is no
// list. Errors: kOutOfRange when the marker has no such piece, or no unplaced one.
[[nodiscard]] Result<std::vector<PieceId>> chosen_pieces(const Marker& marker,
                                                         const std::optional<std::vector<calls::Id>>& ids);

// Errors: kTooManyPieces if there are too many pieces for an exact search.
[[nodiscard]] std::optional<Error> too_many(std::size_t pieces, std::string_view what, std::string_view field);

}  // namespace selvage::protocol::methods::packing
