// Reads a nest that Selvage wrote to DXF (protocol/plots/dxf_file.h) back as the same marker, to the lattice unit.
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "protocol/document/marker_file.h"

namespace selvage::protocol::trade::aama {

// Whether the text is such a nest, which states the width of its marker.
[[nodiscard]] bool is_nest(std::string_view text);

// Errors: those of read_tags, read_drawing and on_lattice; kMissingField and kUnknownShape for a nest that was damaged.
[[nodiscard]] Result<MarkerFile> read_nest(std::string_view text);

}  // namespace selvage::protocol::trade::aama
