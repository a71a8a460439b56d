// Files of this repository that tests read: markers of examples/, golden exchanges, pages.
#pragma once

#include <string>

namespace selvage::test {

// The absolute path of a file or folder, given by its path from the root of the repository.
[[nodiscard]] std::string repository_path(const std::string& path);

// The bytes of a file.  Throws std::runtime_error when it cannot be read.
[[nodiscard]] std::string repository_text(const std::string& path);

// The document of the garment marker with this name: examples/markers/NAME.json.
[[nodiscard]] std::string garment_text(const std::string& name);

}  // namespace selvage::test
