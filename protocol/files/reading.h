// Reads a marker from the text of a file, whose kind is recognised by its content.
#pragma once

#include <optional>
#include <string_view>

#include "core/base/result.h"
#include "protocol/document/marker_file.h"
#include "protocol/trade/options.h"

namespace selvage::protocol::files {

// The kinds of files that are distinguished.
enum class FileKind { kJson, kDxf, kCut, kHpgl, kSvg, kEsicup };

// Recognises a file by its first characters; returns none for an unknown kind.
[[nodiscard]] std::optional<FileKind> kind_of(std::string_view text);

// A file that is not JSON is read as a marker in millimetres, whose format is then the native one.  Errors:
// kUnknownFormat for a text of no known kind, and those of the kind's reader.
[[nodiscard]] Result<MarkerFile> read_file(std::string_view text, const trade::ReadingOptions& options = {});

}  // namespace selvage::protocol::files
