// The index of a library folder, which describes every file in it, so that a search reads only the markers that it
// returns.
//
// It is the file .selvage-index in the folder, with one line of JSON for each file.  It may be deleted at any time and
// is then made again.  A line is valid only while the file has the size and the modification time that the line states,
// and only if the file was older than the index: a file that changed twice within a tick of the clock is read again.
// If the index cannot be written, for example in another user's folder, every file is read each time.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "protocol/library/stored_figures.h"

namespace selvage::cli::library {

// The state of a file when it was read.
struct FileState {
  std::uint64_t bytes{};
  std::int64_t changed{};  // modification time in nanoseconds, by the clock of the file system
  friend bool operator==(const FileState&, const FileState&) = default;
};

// A file of the folder, whether it is a marker or not.
struct IndexedFile {
  std::string file;  // its name with the suffix
  FileState state;
  std::optional<protocol::library::StoredFigures> figures;  // none if the file is not a valid marker,
  std::string defect{};                                     // for this reason
  friend bool operator==(const IndexedFile&, const IndexedFile&) = default;
};

// Reads the entries, by file name, without those of files that may have changed since.  Empty if there is no readable
// index.
[[nodiscard]] std::map<std::string, IndexedFile> read_index(const std::string& folder);
// Replaces the index atomically: another process sees either the old one or the new one.  Returns false if it cannot be
// written.
[[nodiscard]] bool write_index(const std::string& folder, const std::vector<IndexedFile>& files);

// The state of the file; nothing if it does not exist.
[[nodiscard]] std::optional<FileState> state_of(const std::string& path);

}  // namespace selvage::cli::library
