// Files by name; "-" is standard input or output.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "protocol/formats/format.h"

namespace selvage::cli::terminal {

inline constexpr std::string_view kStandardStream = "-";

// Errors: kFile; kOutOfRange for more than kMaxFileBytes.
[[nodiscard]] Result<std::string> read_text(const std::string& path);
// Errors: kFile.
[[nodiscard]] std::optional<Error> write_text(const std::string& path, std::string_view text);

// read_text and read_marker.
[[nodiscard]] Result<MarkerFile> load_marker(const std::string& path);
// write_marker and write_text.
[[nodiscard]] std::optional<Error> save_marker(const std::string& path, const MarkerFile& file, Format format);

// Tells the notes of a reader on stderr, the first few of them.
void tell_notes(const std::vector<Note>& notes);

}  // namespace selvage::cli::terminal
