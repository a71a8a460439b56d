// What a marker loses when it is written in a format.
#pragma once

#include <vector>

#include "protocol/document/marker_file.h"
#include "protocol/files/file_format.h"

namespace selvage::protocol::files {

// Notes about unplaced pieces that the format does not list, letters and attributes that it does not have, and a unit
// that it does not know.
[[nodiscard]] std::vector<Note> losses(const MarkerFile& file, FileFormat format);

}  // namespace selvage::protocol::files
