// What a marker loses when it is written in a format.
#pragma once

#include <vector>

#include "protocol/document/marker_file.h"
#include "protocol/files/file_format.h"

namespace selvage::protocol::files {

// Notes about unplaced pieces that the format does not list, letters and attributes that it does not have, a unit that
// it does not know, and what ESICUP XML cannot say of a layout.
[[nodiscard]] std::vector<Note> losses(const MarkerFile& file, FileFormat format);

}  // namespace selvage::protocol::files
