// The constraints of a piece: locks, its rigid group, its buffer, its overlap allowance and cloth's rules.  The native
// and the sparrow format have the same fields:
//   "locked": true, or the list of what is: "x", "y", "tilt"; "group": a name; "buffer": a length;
//   "overlap": a length, absent when the marker's holds; "rules": an object (DecimalRules), absent when there are none.
#pragma once

#include "protocol/formats/decimal_marker.h"
#include "protocol/json/fields.h"

namespace selvage::protocol::formats {

inline constexpr std::string_view kLockNames[] = {"x", "y", "tilt"};

// Without these fields the piece is free.
void read_constraints(json::Fields& fields, json::Mistake& mistake, DecimalPiece& piece);
// Writes only values that differ from the default.
void write_constraints(Json& json, const Marker& marker, const Piece& piece);

// A value of "locked".
[[nodiscard]] Locks locks_from(const Json& value, const std::string& at, json::Mistake& mistake);
// The shortest equivalent value of "locked".
[[nodiscard]] Json locks_json(const Locks& locks);

}  // namespace selvage::protocol::formats
