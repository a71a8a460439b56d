// A library of the command line, which is a folder of marker files.
//
// Each file is a marker, in any format that Selvage reads; its name without the suffix is the marker's name in the
// library.  Users can view, copy and version a folder without Selvage, and other programs add to it by writing a file.
// An index (folder_index.h) stores what is known about the files, so that only files that have changed are read.  Files
// that are not markers are skipped, with a line on stderr.
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

// The markers of the folder, sorted by name.  Errors: kFile.
[[nodiscard]] Result<std::vector<StoredFile>> list_folder(const std::string& folder);

// Writes the marker as NAME.json, in the native format, into the folder, which is created if it does not exist.
// Errors: kFile if it cannot be written, or if the library has another marker with that name; kMarkerOverlaps,
// kOutsideStrip or kEmptyMarker for a marker that is not valid, or that does not have all of its pieces on the cloth.
[[nodiscard]] std::optional<Error> add_to_folder(const std::string& folder, const std::string& name,
                                                 const MarkerFile& file);

inline constexpr std::size_t kConsidered = 20;  // number of nearest markers that searches and remaking consider

// A marker of a library with its document.
struct NearMarker {
  std::string name;
  MarkerFile file;
};
// The nearest of the stored markers to the order (core/matching/signature.h), at most `count`, nearest first.
// Errors: those of reading a file.
[[nodiscard]] Result<std::vector<NearMarker>> nearest_in(const std::vector<StoredFile>& stored, const Marker& order,
                                                         std::size_t count);

// As a method takes stored markers: a list of native documents.  Errors: those of writing a marker.
[[nodiscard]] Result<Json> documents_of(const std::vector<NearMarker>& markers);

}  // namespace selvage::cli::library
