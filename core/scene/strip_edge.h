// The edges of the strip.
#pragma once

namespace selvage::scene {

enum class StripEdge { kLeft, kRight, kBottom, kTop };  // bottom is y = 0, the right edge is where the marker ends

}  // namespace selvage::scene

// Basic types: also available in namespace selvage, so that every folder can use them unqualified.
namespace selvage {
using scene::StripEdge;
}  // namespace selvage
