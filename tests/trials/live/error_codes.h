// The error codes that answers of a daemon may have (protocol/README.md), as a client knows them.
#pragma once

namespace selvage::trials {

inline constexpr int kRefused = -32000, kBusy = -32010, kTooLarge = -32011, kUnknownMarker = -32012, kNoRoom = -32013;
inline constexpr int kCancelled = -32800, kMoved = -32801, kSuperseded = -32802;

}  // namespace selvage::trials
