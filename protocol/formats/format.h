// Marker files: the formats, and how to read and write any of them.
//
// Read and written: Selvage's native format (native.h) and the jagua-rs / sparrow solution (sparrow.h).  Only written:
// placed outlines (outlines.h) and a drawing (svg.h).  Coordinates are exact when the input's decimals fit the lattice;
// repairs and rounding are listed in the notes.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "protocol/document/marker_file.h"

namespace selvage::protocol::formats {

// Errors: those of parse; kUnknownFormat; every 10xx, 11xx and 12xx a reader or make_marker finds, `field`
// pointing into the document.  The marker read is well formed but need not be valid (pieces may overlap).
[[nodiscard]] Result<MarkerFile> read_marker(std::string_view text, std::size_t max_bytes = json::kMaxFileBytes);
// The same, of a document that is already parsed (such as a call's parameter).
[[nodiscard]] Result<MarkerFile> read_document(const Json& document);

// The document of any form: an object, for kSvg a string.
// Errors: kOrientationNotAllowed for a flipped piece in the sparrow form, which has no word for it.
[[nodiscard]] Result<Json> marker_document(const MarkerFile& file, Format format);
// The text of any form, ending in a newline.
[[nodiscard]] Result<std::string> write_marker(const MarkerFile& file, Format format);

// The file with another least distance between pieces, in the marker's unit.
// Errors: kOutOfRange (negative, not finite, wider than the strip), kBeyondLattice.
[[nodiscard]] Result<MarkerFile> with_spacing(MarkerFile file, double spacing);

// The file with another overlap allowance, in the marker's unit; pieces keep those of their own.  The errors are those
// of with_spacing, at "/overlap".
[[nodiscard]] Result<MarkerFile> with_overlap(MarkerFile file, double overlap);

}  // namespace selvage::protocol::formats
