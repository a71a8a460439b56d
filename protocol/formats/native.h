// Selvage's own marker JSON, version 1.  README.md explains every field; marker.schema.json is its schema.
//
// Unknown fields are errors, except inside "attributes", which are kept and written back.  Ids are strings;
// whole numbers are read as their digits.
#pragma once

#include "core/base/result.h"
#include "protocol/formats/format.h"

namespace selvage {

inline constexpr std::string_view kNativeName = "selvage-marker";
inline constexpr int kNativeVersion = 1;

[[nodiscard]] Result<MarkerFile> read_native(const Json& document);
[[nodiscard]] Json native_document(const MarkerFile& file);

}  // namespace selvage
