#include "clients/cli/library/folder_index.h"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <utility>

#include "protocol/json/json_text.h"

namespace selvage::cli::library {
namespace {

constexpr const char* kIndexName = ".selvage-index";
constexpr const char* kHeading = R"({"format":"selvage-library-index","version":1})";

std::string path_of_index(const std::string& folder) {
  return (std::filesystem::path{folder} / kIndexName).string();
}

// Integers that a double cannot represent exactly are written as text.
std::string line_of(const IndexedFile& indexed) {
  Json line = indexed.figures ? figures_document(*indexed.figures) : Json::object();
  line["file"] = indexed.file;
  line["bytes"] = std::to_string(indexed.state.bytes);
  line["changed"] = std::to_string(indexed.state.changed);
  if (!indexed.figures) line["defect"] = indexed.defect;
  return protocol::json::to_text(line);
}

std::optional<std::string> text_in(const Json& line, const char* name) {
  if (!line.contains(name) || !line[name].is_string()) return std::nullopt;
  return line[name].get<std::string>();
}

std::optional<IndexedFile> read_line(const std::string& text) {
  const auto line = protocol::json::parse(text);
  if (!line || !line->is_object()) return std::nullopt;
  const auto file = text_in(*line, "file"), bytes = text_in(*line, "bytes"), changed = text_in(*line, "changed");
  if (!file || !bytes || !changed) return std::nullopt;
  IndexedFile indexed{*file, {}, protocol::library::read_stored_figures(*line)};
  const auto defect = text_in(*line, "defect");
  if (indexed.figures.has_value() == defect.has_value()) return std::nullopt;
  if (defect) indexed.defect = *defect;
  indexed.state = {std::strtoull(bytes->c_str(), nullptr, 10), std::strtoll(changed->c_str(), nullptr, 10)};
  return indexed;
}

}  // namespace

std::optional<FileState> state_of(const std::string& path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) return std::nullopt;
  constexpr std::int64_t kSecond = 1'000'000'000;
  return FileState{static_cast<std::uint64_t>(found.st_size),
                   static_cast<std::int64_t>(found.st_mtim.tv_sec) * kSecond + found.st_mtim.tv_nsec};
}

std::map<std::string, IndexedFile> read_index(const std::string& folder) {
  std::map<std::string, IndexedFile> files;
  const std::string path = path_of_index(folder);
  const auto own = state_of(path);
  std::ifstream in{path, std::ios::binary};
  std::string line;
  if (!own || !std::getline(in, line) || line != kHeading) return files;
  while (std::getline(in, line)) {
    auto indexed = read_line(line);
    if (!indexed || indexed->state.changed >= own->changed) continue;
    std::string file = indexed->file;
    files.emplace(std::move(file), *std::move(indexed));
  }
  return files;
}

bool write_index(const std::string& folder, const std::vector<IndexedFile>& files) {
  const std::string path = path_of_index(folder);
  const std::string fresh = path + "." + std::to_string(::getpid());
  std::error_code failed;
  {
    std::ofstream out{fresh, std::ios::binary | std::ios::trunc};
    out << kHeading << "\n";
    for (const IndexedFile& indexed : files) out << line_of(indexed) << "\n";
    out.flush();
    if (out) {
      std::filesystem::rename(fresh, path, failed);
      if (!failed) return true;
    }
  }
  std::filesystem::remove(fresh, failed);
  return false;
}

}  // namespace selvage::cli::library
