// What marker.nest and marker.nestSheets share on the wire: the budget of a search, and what pieces are worth.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/compaction/compact.h"
#include "protocol/calls/choices.h"
#include "protocol/calls/params.h"
#include "protocol/calls/parsed_call.h"
#include "protocol/calls/values.h"
#include "protocol/schema/visitors.h"

namespace selvage::protocol::methods::nesting {

inline constexpr double kMostMoves = 1e12, kMostSeconds = 24 * 3'600;

struct NestEffort {
  static constexpr std::string_view kGroup = "search";
  std::optional<motion::compaction::Accuracy> accuracy;
  std::optional<std::uint64_t> moves;
  std::optional<double> seconds;
  std::uint64_t seed{1};

  static void describe(auto& v, auto& self) {
    v.optional("accuracy", self.accuracy,
               "A budget in seconds by name: draft is 2 seconds, standard 20, fine 120.  Not together with seconds.");
    v.optional("moves", self.moves,
               "The budget of a search in moves of a piece; 20,000 when absent, without limit when a time is given.",
               {.range = {{0, kMostMoves}}});
    v.optional("seconds", self.seconds,
               "The budget of a search in seconds, 0 to 86,400. The result then depends on the machine.",
               {.range = {{0, kMostSeconds}}});
    v.optional("seed", self.seed, "The seed of the random choices.", {.range = {{0, calls::kMostSeed}}});
  }
};

struct NestBudget {
  std::uint64_t moves{};
  std::function<double()> elapsed;  // as in selvage::nesting::NestSettings; its clock starts when the budget is made
};
// Errors: kOutOfRange when an accuracy and seconds are given.
[[nodiscard]] Result<NestBudget> budget_of(const NestEffort& effort);

// Why a nesting ended: kDeadline when the time of its budget ran out, as when a deadline ends a motion.
[[nodiscard]] calls::StopCause cause_of_end(scene::StopReason reason, bool out_of_time,
                                            const calls::MethodContext& context);

struct PieceValue {
  static constexpr std::string_view kName = "PieceValue", kMeaning = "What a piece is worth.";
  calls::Id piece;
  double value{};

  static void describe(auto& v, auto& self) {
    v.required("piece", self.piece, "The piece's id.");
    v.required("value", self.value, "Comparable with areas in the square of the marker's unit; 0 to 1e18.",
               {.range = {{0, 1e18}}});
  }
};
inline constexpr std::string_view kValuesMeaning =
    "The values of pieces, if there is no room for all of them; by default a piece is worth its area.";

// By the pieces' ids, in square lattice units.  Errors: kOutOfRange for a piece that the marker does not have.
[[nodiscard]] Result<std::map<std::string, double, std::less<>>> values_of(
    const std::optional<std::vector<PieceValue>>& values, const Marker& marker);

}  // namespace selvage::protocol::methods::nesting
