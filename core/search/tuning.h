// The tuning constants of refinement and of the swaps that it tries.  Where no other source is named, the values were
// tuned on the example markers (docs/measurements/trade.md).
#pragma once

#include <cstddef>
#include <cstdint>

namespace selvage::search {

struct SwapTuning {
  unsigned turns_one_in{5};       // one trial in this many turns a piece, the others swap two
  unsigned jumps_one_in{2};       // of a piece that is matched to the cloth: one in this many moves it by a repeat
  std::size_t partners{8};        // partners of a piece that are drawn from: those that fit its place best
  double distance_weight{0.02};   // of the distance along the strip, relative to the difference of the boxes' sides
  double deepest{0.16};           // part of the width: when pieces overlap by more in total after a swap,
  unsigned deep_one_in{8};        // one such swap in this many is tried: where few pieces are large, only these gain
  int separation_rounds{4};       // of separation after a swap: what takes longer hardly ever ends shorter
  double separation_growth{0.1};  // part of the width by which separation may lengthen the marker
  unsigned any_one_in{3};         // one trial in this many begins with any piece, the others with a critical one
  friend bool operator==(const SwapTuning&, const SwapTuning&) = default;
};

struct RenestingTuning {
  std::uint64_t moves{100};  // of nesting, for each piece; with a limit in time, it goes on after these
  double until{0.7};         // until this part of the time is used up, while as many more moves gain more
  double least_gain{1e-5};   // than this part of the length: otherwise swaps get its time
  double work_of_move{6};    // in pieces of a program, as effort counts
  friend bool operator==(const RenestingTuning&, const RenestingTuning&) = default;
};

struct RefineTuning {
  int compaction_rounds{2};        // of compaction after a swap: they gain most of what can be gained
  int tilt_rounds{4};              // of tilting after a swap in a tilted marker,
  double tilt_within{4e-3};        // if it is longer than the best by at most this part of the length;
  double hope{3};                  // its rounds end when more than this many times what the last one gained is missing
  std::uint64_t turn{20'000};      // work after which swaps in the straight and in the tilted marker take turns
  double least_room{1e-6};         // part of the marker's area: a marker with less is full
  std::uint64_t idle_trials{500};  // consecutive trials that solve no program end the swaps: none is worth trying
  SwapTuning swap{};
  RenestingTuning renesting{};
  friend bool operator==(const RefineTuning&, const RefineTuning&) = default;
};

}  // namespace selvage::search
