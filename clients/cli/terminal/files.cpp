#include "clients/cli/terminal/files.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <utility>

#include "clients/cli/terminal/style.h"
#include "protocol/files/losses.h"
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

std::optional<Error> write_in_place(const std::string& path, std::string_view text) {
  std::ofstream file{path, std::ios::binary | std::ios::trunc};
  file << text << std::flush;
  if (!file) return file_error(path, "written");
  return std::nullopt;
}

// Whether a new file may replace what has this name.  Pipes, devices and links are written to instead.
bool replaces(const std::string& path) {
  std::error_code ignored;
  const auto status = std::filesystem::symlink_status(path, ignored);
  return !std::filesystem::exists(status) || std::filesystem::is_regular_file(status);
}

// Writes a new file beside the one with this name, and then renames it.  So the old file remains until the new one is
// complete, and also when the disk is full.
std::optional<Error> write_whole(const std::string& path, std::string_view text) {
  namespace fs = std::filesystem;
  std::error_code failed;
  const std::string draft = path + ".part";
  std::ofstream file{draft, std::ios::binary | std::ios::trunc};
  if (!file) return write_in_place(path, text);  // the folder takes no new files
  file << text << std::flush;
  int reason = errno;
  if (file) {
    file.close();
    const auto before = fs::status(path, failed);
    if (fs::exists(before)) fs::permissions(draft, before.permissions(), failed);
    fs::rename(draft, path, failed);
    if (!failed) return std::nullopt;
    reason = failed.value();
  }
  fs::remove(draft, failed);
  errno = reason;
  return file_error(path, "written");
}

// The whole name without links, also of a file that does not exist yet and to which a link leads.
std::filesystem::path resolved(const std::string& name) {
  namespace fs = std::filesystem;
  constexpr int kMostLinks = 40;
  std::error_code ignored;
  fs::path path = fs::absolute(name, ignored);
  for (int k = 0; k < kMostLinks && fs::is_symlink(path, ignored) && !fs::exists(path, ignored); ++k)
    path = path.parent_path() / fs::read_symlink(path, ignored);
  return fs::weakly_canonical(path, ignored);
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
  return replaces(path) ? write_whole(path, text) : write_in_place(path, text);
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

bool name_one_file(const std::string& first, const std::string& second) {
  if (first.empty() || second.empty() || first == kStandardStream || second == kStandardStream) return false;
  std::error_code ignored;
  const std::filesystem::path one = resolved(first);
  const auto status = std::filesystem::status(one, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) return false;
  return one == resolved(second);
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
  if (auto error = write_text(path, *text)) return error;
  print_notes(protocol::files::losses(file, format));
  return std::nullopt;
}

void print_notes(const std::vector<Note>& notes) {
  constexpr std::size_t kMostPrinted = 10;
  std::vector<std::pair<const Note*, std::size_t>> different;  // the first of each text, and how many there are
  std::map<std::string_view, std::size_t> known;
  for (const Note& note : notes) {
    const auto [place, fresh] = known.emplace(note.text, different.size());
    if (fresh) different.emplace_back(&note, 0);
    ++different[place->second].second;
  }
  const std::string head = Style{STDERR_FILENO}.faint("note:") + " ";
  for (std::size_t i = 0; i < std::min(kMostPrinted, different.size()); ++i) {
    const auto& [note, times] = different[i];
    std::cerr << head << (note->field.empty() ? "" : note->field + ": ") << note->text
              << (times > 1 ? " (" + std::to_string(times) + " times)" : "") << "\n";
  }
  if (different.size() > kMostPrinted) std::cerr << head << "and " << different.size() - kMostPrinted << " more\n";
}

}  // namespace selvage::cli::terminal
