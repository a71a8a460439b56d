#include "clients/cli/library/folder.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <utility>

#include "clients/cli/terminal/failure.h"
#include "clients/cli/terminal/files.h"
#include "core/marker/validity.h"
#include "core/matching/signature.h"
#include "protocol/files/writing.h"

namespace selvage::cli::library {
namespace {

std::optional<Error> defect_of(const Marker& marker) {
  if (marker.pieces.empty() || !marker.unplaced.empty()) {
    return Error{ErrorCode::kEmptyMarker, "not all of its pieces lie on the cloth; nest it first", ""};
  }
  if (!is_valid(marker)) {
    return Error{ErrorCode::kMarkerOverlaps, "it is not valid; `selvage check` lists what is wrong with it", ""};
  }
  return std::nullopt;
}

}  // namespace

Result<std::vector<StoredFile>> read_folder(const std::string& folder) {
  std::error_code failed;
  std::vector<std::filesystem::path> paths;
  for (std::filesystem::directory_iterator at{folder, failed}, end; !failed && at != end; at.increment(failed)) {
    if (at->is_regular_file(failed) && at->path().filename().string().front() != '.') paths.push_back(at->path());
  }
  if (failed) return Error{ErrorCode::kFile, folder + ": " + failed.message(), ""};
  std::sort(paths.begin(), paths.end());
  std::vector<StoredFile> stored;
  for (const std::filesystem::path& path : paths) {
    auto file = terminal::load_marker(path.string());
    if (file && !file->marker.pieces.empty()) {
      stored.push_back({path.stem().string(), *std::move(file)});
    } else {
      const std::string why = file ? "it has no pieces on the cloth" : terminal::message_of(file.error());
      std::cerr << "selvage: " << path.string() << " is passed over: " << why << "\n";
    }
  }
  return stored;
}

std::optional<Error> add_to_folder(const std::string& folder, const std::string& name, const MarkerFile& file) {
  if (auto defect = defect_of(file.marker)) return defect;
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) return Error{ErrorCode::kFile, folder + ": " + failed.message(), ""};
  const std::string path = (std::filesystem::path{folder} / (name + ".json")).string();
  auto text = protocol::files::write_marker(file, protocol::files::FileFormat::kNative);
  if (!text) return text.error();
  if (std::filesystem::exists(path, failed)) {
    const auto present = terminal::read_text(path);
    if (present && *present == *text) return std::nullopt;
    return Error{ErrorCode::kFile, path + " exists and is another marker; give the file another name", ""};
  }
  return terminal::write_text(path, *text);
}

std::vector<StoredFile> nearest_in(std::vector<StoredFile> stored, const Marker& order, std::size_t count) {
  std::vector<matching::Signature> signatures;
  for (const StoredFile& one : stored) signatures.push_back(matching::signature_of(one.file.marker));
  std::vector<StoredFile> near;
  for (const std::size_t k : nearest(matching::signature_of(order), signatures, count)) {
    near.push_back(std::move(stored[k]));
  }
  return near;
}

}  // namespace selvage::cli::library
