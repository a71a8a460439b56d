// A library as the command line has it: a folder of marker files.
//
// Each file is a marker, in any format that Selvage reads; its name without the suffix is the marker's name in the
// library.  A folder needs no program to be looked at, copied, or kept under version control, and other programs add to
// it by writing a file.  Files in it that are no markers are passed over, with a line on stderr.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "protocol/document/marker_file.h"

namespace selvage::cli::library {

struct StoredFile {
  std::string name;
  MarkerFile file;
};

// The markers of the folder, by name.  Errors: kFile.
[[nodiscard]] Result<std::vector<StoredFile>> read_folder(const std::string& folder);

// Writes the marker into the folder, which is made if there is none, as NAME.json in the native format.
// Errors: kFile when it cannot be written, or when the library has another marker of that name; kMarkerOverlaps,
// kOutsideStrip or kEmptyMarker for a marker that is not valid, or that does not have all of its pieces on the cloth.
[[nodiscard]] std::optional<Error> add_to_folder(const std::string& folder, const std::string& name,
                                                 const MarkerFile& file);

// The nearest of them to the order (core/matching/signature.h), at most `count`, nearest first.
[[nodiscard]] std::vector<StoredFile> nearest_in(std::vector<StoredFile> stored, const Marker& order,
                                                 std::size_t count);

}  // namespace selvage::cli::library
