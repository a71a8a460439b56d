// How a motion reports its progress, for callers that measure times or show a progress bar.  The core itself has no
// clock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "core/geometry/lattice.h"
#include "core/lp/linear_program.h"
#include "core/marker/marker.h"

namespace selvage::scene {

enum class Stage { kDecomposition, kSums, kRows, kSolve, kVerify, kOther };

struct Round {
  int number{};    // 1, 2, ...
  Coord length{};  // of the marker after the round
  // Of searches of all layouts: no marker is shorter, which is proved; and how many nodes were searched so far.
  std::optional<Coord> bound{};
  std::optional<std::uint64_t> nodes{};
  const Marker* marker{};  // of nesting: the marker after the round, as long as on_round() runs; else null
};

// How large a linear program is.
struct ProgramSize {
  int columns{}, rows{};
  std::size_t nonzeros{};
};
[[nodiscard]] inline ProgramSize size_of(const lp::LinearProgram& program) {
  return {program.columns(), program.rows(), program.entries.size()};
}

struct Observer {
  std::function<void(Stage)> on_stage = [](Stage) {};  // a stage begins
  std::function<void(const Round&)> on_round = [](const Round&) {};
  std::function<void(const lp::LinearProgram&)> on_program = [](const lp::LinearProgram&) {};  // about to be solved
};

}  // namespace selvage::scene
