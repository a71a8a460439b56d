// Writing a marker in any format.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "protocol/document/marker_file.h"
#include "protocol/files/file_format.h"

namespace selvage::protocol::files {

// The document of a format: an object for the JSON formats, a string for the others.  Errors: kOrientationNotAllowed
// for a flipped piece, which the sparrow format cannot express; kOutOfRange for a marker in a unit that DXF does not
// have.
[[nodiscard]] Result<Json> marker_document(const MarkerFile& file, FileFormat format);
// The text of a format, ending in a newline.
[[nodiscard]] Result<std::string> write_marker(const MarkerFile& file, FileFormat format);

// The format that belongs to the suffix of a file's name, such as ".dxf"; none for an unknown suffix.  For JSON, it is
// the format of the file that was read if that is JSON, otherwise the native one.
[[nodiscard]] std::optional<FileFormat> format_of_name(std::string_view name, FileFormat of_file);

}  // namespace selvage::protocol::files
