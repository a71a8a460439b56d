// The content of a marker file: the marker itself, the format it was read from, what the reader had to repair or round,
// and the fields that Selvage keeps without interpreting them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/marker/marker.h"
#include "protocol/json/json_text.h"

namespace selvage::protocol::document {

enum class Format { kNative, kSparrow, kOutlines, kSvg };
inline constexpr std::string_view kFormatNames[] = {"native", "sparrow", "outlines", "svg"};  // by Format
inline constexpr Format kReadableFormats[] = {Format::kNative, Format::kSparrow};             // all are written
[[nodiscard]] std::string_view name_of(Format format);

// Something that the reader repaired, rounded or interpreted differently from what was written.
struct Note {
  std::string field;  // JSON pointer into the document that was read
  std::string text;
  friend bool operator==(const Note&, const Note&) = default;
};

// The fields of a file that do not belong to the marker itself.  Every entry is an object, which may be empty.
struct Attributes {
  Json whole = Json::object();
  std::vector<Json> shapes, pieces, unplaced;  // one per shape, one per placed piece, one per unplaced piece
};

struct MarkerFile {
  Marker marker;
  Format format{};  // the format it was read from
  std::vector<Note> notes;
  Attributes attributes;
};

}  // namespace selvage::protocol::document

// Also declared in the namespace selvage, so that every folder may use the names unqualified.
namespace selvage {
using protocol::document::Format;
using protocol::document::MarkerFile;
using protocol::document::Note;
}  // namespace selvage
