// Selvage's own marker JSON, version 1.  protocol/README.md explains every field; marker.schema.json is its schema.
//
// Unknown fields are errors, except inside "attributes", which are kept and written back.  Ids are strings;
// whole numbers are read as their digits.
#pragma once

#include "core/base/result.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/formats/format.h"

namespace selvage::protocol::formats {

inline constexpr std::string_view kNativeName = "selvage-marker";
inline constexpr int kNativeVersion = 1;

[[nodiscard]] Result<MarkerFile> read_native(const Json& document);
[[nodiscard]] Json native_document(const MarkerFile& file);

// One shape and one piece of such a document, for those who write and read markers in parts.  `at` is the JSON pointer
// of the value; what it says in "attributes" goes there.
[[nodiscard]] DecimalShape read_native_shape(const Json& value, const std::string& at, json::Mistake& mistake,
                                             Json& attributes);
[[nodiscard]] DecimalPiece read_native_piece(const Json& value, const std::string& at, json::Mistake& mistake,
                                             Json& attributes);
[[nodiscard]] Json native_piece(const Marker& marker, const Piece& piece, const Json& attributes);

}  // namespace selvage::protocol::formats
