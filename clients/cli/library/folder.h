// A library as the command line has it: a folder of marker files.
//
// Each file is a marker, in any format that Selvage reads; its name without the suffix is the marker's name in the
// library.  A folder needs no program to be looked at, copied, or kept under version control, and other programs add to
// it by writing a file.  What is known of the files is kept in an index (folder_index.h), so that only files that have
// changed are read.  Files in it that are no markers are passed over, with a line on stderr.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "protocol/document/marker_file.h"
#include "protocol/library/stored_figures.h"

namespace selvage::cli::library {

struct StoredFile {
  std::string name;
  std::string path;
  protocol::library::StoredFigures figures;
};

// The markers of the folder, by name.  Errors: kFile.
[[nodiscard]] Result<std::vector<StoredFile>> list_folder(const std::string& folder);

// Writes the marker into the folder, which is made if there is none, as NAME.json in the native format.
// Errors: kFile when it cannot be written, or when the library has another marker of that name; kMarkerOverlaps,
// kOutsideStrip or kEmptyMarker for a marker that is not valid, or that does not have all of its pieces on the cloth.
[[nodiscard]] std::optional<Error> add_to_folder(const std::string& folder, const std::string& name,
                                                 const MarkerFile& file);

inline constexpr std::size_t kConsidered = 20;  // of the nearest markers, by searches and remaking

// A marker of a library with its document.
struct NearMarker {
  std::string name;
  MarkerFile file;
};
// The nearest of the stored markers to the order (core/matching/signature.h), at most `count`, nearest first.
// Errors: those of reading a file.
[[nodiscard]] Result<std::vector<NearMarker>> nearest_in(const std::vector<StoredFile>& stored, const Marker& order,
                                                         std::size_t count);

}  // namespace selvage::cli::library
