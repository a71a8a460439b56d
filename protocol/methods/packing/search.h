// What the exact searches share on the wire: how much work they may do, and what they report of it.
#pragma once

#include <cstdint>
#include <optional>

#include "core/packing/branching/search.h"
#include "core/packing/contain.h"
#include "protocol/calls/motion.h"

namespace selvage::protocol::methods::packing {

inline constexpr double kMostNodes = 1e12;

struct SearchEffort {
  static constexpr std::string_view kGroup = "search";
  std::optional<std::uint64_t> nodes;
  bool turns{true};

  static void describe(auto& v, auto& self) {
    v.optional("nodes", self.nodes, "End the search after about this many nodes, 1 to 10^12; no limit when absent.",
               {.range = {{1, kMostNodes}}});
    v.optional("turns", self.turns, "Whether pieces may take other orientations that their shapes allow.");
  }
  [[nodiscard]] selvage::packing::branching::WorkLimits limits() const {
    selvage::packing::branching::WorkLimits limits;
    if (nodes) limits.nodes = *nodes;
    return limits;
  }
};

struct SearchReport {
  static constexpr std::string_view kGroup = "search";
  std::uint64_t nodes{}, pivots{};
  calls::RoundsResult rounds;

  static void describe(auto& v, auto& self) {
    v.required("nodes", self.nodes, "Number of nodes searched.");
    v.required("pivots", self.pivots, "Number of simplex pivots.");
    v.part(self.rounds);
  }
};
[[nodiscard]] inline SearchReport report_of(const selvage::packing::branching::Work& work, int rounds,
                                            calls::StopCause stop) {
  return {work.nodes, work.pivots, {rounds, stop}};
}

}  // namespace selvage::protocol::methods::packing

namespace selvage::protocol::schema {

template <>
struct Choices<packing::Verdict> {
  static constexpr std::string_view kName = "Verdict";
  static constexpr std::string_view kMeaning =
      "Whether pieces fit: found, impossible (proved), or undecided when the search ended early.";
  static constexpr std::string_view kWords[] = {"found", "impossible", "undecided"};
};

}  // namespace selvage::protocol::schema
