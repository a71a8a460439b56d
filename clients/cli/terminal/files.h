// Reads and writes files; the name "-" is standard input or output.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "protocol/files/file_format.h"
#include "protocol/files/reading.h"
#include "protocol/formats/format.h"

namespace selvage::cli::terminal {

inline constexpr std::string_view kStandardStream = "-";

// Reads at most one byte more than kMaxFileBytes, so that the parser can report that the text is too long.
// Errors: kFile.
[[nodiscard]] Result<std::string> read_text(const std::string& path);
// Errors: kFile.
[[nodiscard]] std::optional<Error> write_text(const std::string& path, std::string_view text);

// Checks, without writing, whether the file can be written, and returns the error if it cannot.  Errors: kFile.
[[nodiscard]] std::optional<Error> why_not_writable(const std::string& path);

// Whether both names are those of one file, or of one that is yet to be written; links are followed.  Never so for
// standard streams, pipes and devices, which several results may share.
[[nodiscard]] bool name_one_file(const std::string& first, const std::string& second);

// read_text followed by read_file; the errors of both, with the file's name in the message.
[[nodiscard]] Result<MarkerFile> load_marker(const std::string& path,
                                             const protocol::trade::ReadingOptions& options = {});
// write_marker followed by write_text; the errors of both.
[[nodiscard]] std::optional<Error> save_marker(const std::string& path, const MarkerFile& file,
                                               protocol::files::FileFormat format);

// Prints the notes of a reader to stderr: the first few different ones, and how many more there are.  Notes of the same
// text are printed once, with their number.
void print_notes(const std::vector<Note>& notes);

}  // namespace selvage::cli::terminal
