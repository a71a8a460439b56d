// Marker files: which forms there are, and one way to read and write any of them.
//
// Read and written: Selvage's own form (native.h) and the jagua-rs / sparrow solution (sparrow.h).  Written
// only: placed outlines (outlines.h) and a drawing (svg.h).  All coordinates pass through the lattice exactly
// when the input's decimals fit it; what reading had to mend or round is said in the notes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/marker/marker.h"
#include "protocol/json_text.h"

namespace selvage {

enum class Format { kNative, kSparrow, kOutlines, kSvg };
inline constexpr std::string_view kFormatNames[] = {"native", "sparrow", "outlines", "svg"};  // by Format
[[nodiscard]] std::string_view name_of(Format format);

// Something a reader mended, rounded or took differently than written, worth saying.
struct Note {
  std::string field;  // JSON pointer into the document that was read
  std::string text;
  friend bool operator==(const Note&, const Note&) = default;
};

// What a file says beside the marker itself; every entry is an object, empty when there is nothing.
struct Attributes {
  Json whole = Json::object();
  std::vector<Json> shapes, pieces;  // one per shape, one per piece
};

struct MarkerFile {
  Marker marker;
  Format format{};  // the form it was read from
  std::vector<Note> notes;
  Attributes attributes;
};

// Errors: those of parse; kUnknownFormat; every 10xx, 11xx and 12xx a reader or make_marker finds, `field`
// pointing into the document.  The marker read is well formed but need not be valid (pieces may overlap).
[[nodiscard]] Result<MarkerFile> read_marker(std::string_view text, std::size_t max_bytes = kMaxFileBytes);
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

}  // namespace selvage
