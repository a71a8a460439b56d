// The notification $/progress: sent to the caller of a motion with a progress token, after each round.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "core/geometry/lattice.h"
#include "core/scene/observer.h"
#include "protocol/calls/params.h"

namespace selvage::protocol::methods::daemon {

struct Progress {
  calls::ProgressToken token;
  int round{};
  double length{};
  std::optional<double> bound{};
  std::optional<std::uint64_t> nodes{};

  static void describe(auto& v, auto& self) {
    v.required("token", self.token, "The call's progressToken.");
    v.required("round", self.round, "The number of the round.");
    v.required("length", self.length, "The marker's length after the round.");
    v.optional("bound", self.bound,
               "Only from motion.pack: a proved lower bound on the length of any marker of these pieces with their "
               "present tilts.");
    v.optional("nodes", self.nodes, "Only from exact searches: number of nodes searched so far.");
  }
};

[[nodiscard]] inline Progress progress_of(calls::ProgressToken token, const scene::Round& round,
                                          Resolution resolution) {
  Progress progress{std::move(token), round.number, to_decimal(round.length, resolution), std::nullopt, round.nodes};
  if (round.bound) progress.bound = to_decimal(*round.bound, resolution);
  return progress;
}

}  // namespace selvage::protocol::methods::daemon
