// Writing a marker in any format.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "protocol/document/marker_file.h"
#include "protocol/files/file_format.h"

namespace selvage::protocol::files {

// The document of a format: an object for the JSON formats, a string for the others.
// Errors: kOrientationNotAllowed for a flipped piece in the sparrow form, which has no word for it; kOutOfRange for a
// marker in a unit that DXF has no word for.
[[nodiscard]] Result<Json> marker_document(const MarkerFile& file, FileFormat format);
// The text of a format, ending in a newline.
[[nodiscard]] Result<std::string> write_marker(const MarkerFile& file, FileFormat format);

// The format that a file's name asks for by its suffix, such as ".dxf"; none when the suffix is of no format.  JSON has
// several: that of the file when it is one of them, else the native one.
[[nodiscard]] std::optional<FileFormat> format_of_name(std::string_view name, FileFormat of_file);

}  // namespace selvage::protocol::files
