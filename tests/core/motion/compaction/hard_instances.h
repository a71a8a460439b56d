// Markers that are hard for compaction, after the constructions of [Li94 1.2.3, 8.1, 9.3, 9.4].
#pragma once

#include <vector>

#include "core/marker/marker.h"

namespace selvage::test {

inline constexpr Coord kUnit = 120'000;  // lattice units in one unit of a construction

// Rectangles of height 1 and the given lengths in a strip of width 2, corner to corner, alternately below and above.
// The choices at the corners decide how short the marker becomes, at best half the sum of the lengths [Li94 Theorems
// 1.1 and 8.1].
[[nodiscard]] Marker partition(const std::vector<int>& lengths);

// n U-shaped pieces stacked in the third of three slots that two bars make, over blocks; they would have to be lifted
// over the bars one by one, like the discs of the Towers of Hanoi [Li94 9.3].  In units of the U's walls; the slots are
// 2 n wide.  Departs: there is no slider under the blocks, which only matters once the U's have reached their goal.
[[nodiscard]] Marker u_shapes_and_bars(int n);

// The motion-propagation device [Li94 9.4] with n groups and k teeth.  The marker's end is a slide (A) that can move by
// k units.  It pulls a follower (B) through a zigzag channel, which rises and falls by 1 at each tooth and takes a
// lifter (C) along; a slot of slope 1/k in the lifter drives the next group's slide to and fro by k units each time.
// Departs from the thesis' figure: slots hold the pieces to each other, with a clearance of 1/50.
[[nodiscard]] Marker motion_propagation(int n, int k);

}  // namespace selvage::test
