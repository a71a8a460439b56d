// A DXF file as its tags: pairs of lines, a group code and a value.
//
// Only ASCII DXF is read: pattern files are ASCII by their standard.  We use our own reader, because the available
// libraries lose the group codes 39 and 50 of a POINT, which contain the width and angle of a notch in pattern files.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace selvage::protocol::trade::dxf {

struct Tag {
  int code{};
  std::uint32_t line{};   // of the value; 1 is the first
  std::string_view text;  // without blanks at its ends, in the file's own encoding
};

// Whether the text begins as an ASCII DXF file does: with a section, or with comments before one.
[[nodiscard]] bool looks_like_dxf(std::string_view text);

// The tags up to EOF, comments (999) left out.  REQUIRES: the text outlives the tags.
// Errors: kUnknownFormat (binary DXF), kSyntax (a group code that is no number, with its line).
[[nodiscard]] Result<std::vector<Tag>> read_tags(std::string_view text);

}  // namespace selvage::protocol::trade::dxf
