// A marker as a file holds it: the marker itself, the form it was read from, what reading had to repair or round, and
// the fields of the file that Selvage keeps without reading them.
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

// Something that a reader repaired, rounded or read differently than written.
struct Note {
  std::string field;  // JSON pointer into the document that was read
  std::string text;
  friend bool operator==(const Note&, const Note&) = default;
};

// What a file contains besides the marker itself; every entry is an object, empty when there is nothing.
struct Attributes {
  Json whole = Json::object();
  std::vector<Json> shapes, pieces, unplaced;  // one per shape, one per placed piece, one per unplaced piece
};

struct MarkerFile {
  Marker marker;
  Format format{};  // the form it was read from
  std::vector<Note> notes;
  Attributes attributes;
};

}  // namespace selvage::protocol::document

// Vocabulary: named in selvage itself as well, so that every room may use it unqualified.
namespace selvage {
using protocol::document::Format;
using protocol::document::MarkerFile;
using protocol::document::Note;
}  // namespace selvage
