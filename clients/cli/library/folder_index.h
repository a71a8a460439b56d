// The index of a library folder: what is known of every file in it, so that a search reads no marker but those that it
// returns.
//
// It is the file .selvage-index in the folder, one line of JSON for each file.  It may be deleted at any time; it is
// made again.  A line counts only while the file has the size and the time of its last change that the line names, and
// only if the file was older than the index: a file that changed twice within a tick of the clock is read again.  Where
// the index cannot be written, as in a folder of somebody else's, every file is read each time.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "protocol/library/stored_figures.h"

namespace selvage::cli::library {

// How a file was when it was read.
struct FileState {
  std::uint64_t bytes{};
  std::int64_t changed{};  // nanoseconds; by the clock of the file system
  friend bool operator==(const FileState&, const FileState&) = default;
};

// A file of the folder, whether it is a marker or not.
struct IndexedFile {
  std::string file;  // its name with the suffix
  FileState state;
  std::optional<protocol::library::StoredFigures> figures;  // none: it is no marker of a library,
  std::string defect{};                                     // because of this
  friend bool operator==(const IndexedFile&, const IndexedFile&) = default;
};

// By file; those that may have changed since are left out.  Empty when there is no index, or when it is not one.
[[nodiscard]] std::map<std::string, IndexedFile> read_index(const std::string& folder);
// In place of the index that there is; another process sees the old one or the new one.  False when it cannot be
// written.
[[nodiscard]] bool write_index(const std::string& folder, const std::vector<IndexedFile>& files);

// Nothing when there is no such file.
[[nodiscard]] std::optional<FileState> state_of(const std::string& path);

}  // namespace selvage::cli::library
