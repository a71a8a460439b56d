// The edges of the strip.
#pragma once

namespace selvage::scene {

enum class StripEdge { kLeft, kRight, kBottom, kTop };  // bottom is y = 0, the right edge is where the marker ends

}  // namespace selvage::scene

// Vocabulary: named in selvage itself as well, so that every room may use it unqualified.
namespace selvage {
using scene::StripEdge;
}  // namespace selvage
