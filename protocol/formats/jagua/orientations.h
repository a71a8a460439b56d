// The rotations that an item of a jagua-rs instance may have: the list `allowed_orientations`, or, from version 0.9 on,
// the object `orientation` (ExtOrientation; github.com/JeroenGar/jagua-rs).
//
// The reflections that it may permit as well are not read: a solution could not say which pieces are reflected.
// Units: degrees.
#pragma once

#include <vector>

#include "core/geometry/orientation.h"
#include "protocol/json/fields.h"

namespace selvage::protocol::formats::jagua {

inline constexpr const char* kOrientation = "orientation";
inline constexpr int kMostSteps = 3'600;

// Reads the fields of an item; empty: any rotation is allowed.
// Mistakes: kMissingField and kWrongType; kOutOfRange for both forms together, for angles beyond a turn, and for a step
// that is no part of a turn or that makes more than kMostSteps rotations.
[[nodiscard]] std::vector<Angle> read_orientations(json::Fields& item, json::Mistake& mistake);
// Whether the item permits reflections.
[[nodiscard]] bool permits_reflections(const Json& item);

[[nodiscard]] Json angles_json(const std::vector<Angle>& angles);
// The object as it was read, with these rotations.
[[nodiscard]] Json orientation_json(Json as_read, const std::vector<Angle>& rotations);

}  // namespace selvage::protocol::formats::jagua
