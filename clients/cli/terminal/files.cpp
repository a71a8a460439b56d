#include "clients/cli/terminal/files.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "clients/cli/terminal/style.h"
#include "protocol/files/writing.h"
#include "protocol/json/fields.h"
#include "protocol/json/json_text.h"

namespace selvage::cli::terminal {
namespace {

Error file_error(const std::string& path, const std::string& what) {
  const std::string reason = errno != 0 ? std::string{": "} + std::strerror(errno) : "";
  return {ErrorCode::kFile, path + " cannot be " + what + reason, ""};
}

// Stops reading when the limit is exceeded.
bool read_all(std::istream& stream, std::string& text) {
  constexpr std::size_t kChunk = std::size_t{1} << 16;
  while (text.size() <= protocol::json::kMaxFileBytes && stream) {
    const std::size_t had = text.size();
    text.resize(had + kChunk);
    stream.read(text.data() + had, static_cast<std::streamsize>(kChunk));
    text.resize(had + static_cast<std::size_t>(stream.gcount()));
  }
  return !stream.bad();
}

}  // namespace

Result<std::string> read_text(const std::string& path) {
  std::string text;
  errno = 0;
  if (path == kStandardStream) {
    if (!read_all(std::cin, text)) return file_error("standard input", "read");
    return text;
  }
  std::ifstream file{path, std::ios::binary};
  if (!file || !read_all(file, text)) return file_error(path, "read");
  return text;
}

std::optional<Error> write_text(const std::string& path, std::string_view text) {
  errno = 0;
  if (path == kStandardStream) {
    std::cout << text << std::flush;
    if (!std::cout) return file_error("standard output", "written");
    return std::nullopt;
  }
  std::ofstream file{path, std::ios::binary | std::ios::trunc};
  file << text << std::flush;
  if (!file) return file_error(path, "written");
  return std::nullopt;
}

std::optional<Error> why_not_writable(const std::string& path) {
  if (path == kStandardStream) return std::nullopt;
  namespace fs = std::filesystem;
  std::error_code ignored;
  errno = 0;
  if (fs::is_directory(path, ignored)) {
    errno = EISDIR;
    return file_error(path, "written");
  }
  const fs::path folder = fs::path{path}.has_parent_path() ? fs::path{path}.parent_path() : fs::path{"."};
  const bool exists = fs::exists(path, ignored);
  if (access(exists ? path.c_str() : folder.c_str(), exists ? W_OK : W_OK | X_OK) == 0) return std::nullopt;
  return file_error(path, "written");
}

Result<MarkerFile> load_marker(const std::string& path, const protocol::trade::ReadingOptions& options) {
  const auto text = read_text(path);
  if (!text) return text.error();
  auto file = protocol::files::read_file(*text, options);
  if (file) return file;
  const std::string name = path == kStandardStream ? "standard input" : path;
  return Error{file.error().code, name + ": " + protocol::json::describe(file.error()), ""};
}

std::optional<Error> save_marker(const std::string& path, const MarkerFile& file, protocol::files::FileFormat format) {
  const auto text = protocol::files::write_marker(file, format);
  if (!text) return text.error();
  return write_text(path, *text);
}

void print_notes(const std::vector<Note>& notes) {
  constexpr std::size_t kMostPrinted = 5;
  for (std::size_t i = 0; i < std::min(kMostPrinted, notes.size()); ++i) {
    std::cerr << Style{STDERR_FILENO}.faint("note:") << " " << (notes[i].field.empty() ? "" : notes[i].field + ": ")
              << notes[i].text << "\n";
  }
  if (notes.size() > kMostPrinted)
    std::cerr << Style{STDERR_FILENO}.faint("note:") << " and " << notes.size() - kMostPrinted << " more\n";
}

}  // namespace selvage::cli::terminal
