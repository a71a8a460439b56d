// Pins: figures that a test measured when they were last recorded, such as the size of a linear program or the length
// that a preset reaches.  They do not say what is right; they make a change of these figures visible.  A figure may
// become smaller, but it may exceed its pin only by the slack.
//
// The pins are in this folder's text files, one figure per line.  After an intended change `./dev pins` records them
// anew, and the difference is reviewed with the change.
#pragma once

#include <string>

namespace selvage::test {

// How far a figure may exceed its pin, as a part of it.  The last digits of floating-point results differ between
// compilers, and so do the neighbourhoods that motions consider.
inline constexpr double kPinSlack = 0.03;

// Expects `measured` to be at most the pin `key` of `file`, which is a file of this folder without its ending; fails
// when there is no such pin.  With SELVAGE_RECORD_PINS in the environment it records the figure instead.
void expect_pinned(const std::string& file, const std::string& key, double measured, double slack = kPinSlack);

}  // namespace selvage::test
