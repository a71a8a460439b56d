#include "clients/cli/library/folder.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <utility>

#include "clients/cli/library/folder_index.h"
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

IndexedFile read_afresh(const std::filesystem::path& path, const FileState& state) {
  IndexedFile indexed{path.filename().string(), state, {}};
  const auto file = terminal::load_marker(path.string());
  if (file && !file->marker.pieces.empty()) {
    indexed.figures = protocol::library::stored_figures_of(file->marker);
  } else {
    indexed.defect = file ? "it has no pieces on the cloth" : terminal::message_of(file.error());
  }
  return indexed;
}

// The files of the folder, sorted by name, without hidden ones.  Errors: kFile.
Result<std::vector<std::filesystem::path>> paths_in(const std::string& folder) {
  std::error_code failed;
  std::vector<std::filesystem::path> paths;
  for (std::filesystem::directory_iterator at{folder, failed}, end; !failed && at != end; at.increment(failed)) {
    if (at->is_regular_file(failed) && at->path().filename().string().front() != '.') paths.push_back(at->path());
  }
  if (failed) return Error{ErrorCode::kFile, folder + ": " + failed.message(), ""};
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace

Result<std::vector<StoredFile>> list_folder(const std::string& folder) {
  const auto paths = paths_in(folder);
  if (!paths) return paths.error();
  std::map<std::string, IndexedFile> known = read_index(folder);
  std::vector<IndexedFile> files;
  bool changed = false;
  for (const std::filesystem::path& path : *paths) {
    const auto state = state_of(path.string());
    if (!state) continue;  // removed in the meantime
    const auto found = known.find(path.filename().string());
    const bool same = found != known.end() && found->second.state == *state;
    files.push_back(same ? std::move(found->second) : read_afresh(path, *state));
    changed = changed || !same;
  }
  if (changed || files.size() != known.size()) (void)write_index(folder, files);
  std::vector<StoredFile> stored;
  for (IndexedFile& indexed : files) {
    const std::filesystem::path path = std::filesystem::path{folder} / indexed.file;
    if (indexed.figures) {
      stored.push_back({path.stem().string(), path.string(), *std::move(indexed.figures)});
    } else {
      std::cerr << "selvage: " << path.string() << " is skipped: " << indexed.defect << "\n";
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

Result<std::vector<NearMarker>> nearest_in(const std::vector<StoredFile>& stored, const Marker& order,
                                           std::size_t count) {
  std::vector<matching::Signature> signatures;
  for (const StoredFile& one : stored) signatures.push_back(one.figures.signature);
  std::vector<NearMarker> near;
  for (const std::size_t k : nearest(matching::signature_of(order), signatures, count)) {
    auto file = terminal::load_marker(stored[k].path);
    if (!file) return file.error();
    near.push_back({stored[k].name, *std::move(file)});
  }
  return near;
}

Result<Json> documents_of(const std::vector<NearMarker>& markers) {
  Json documents = Json::array();
  for (const NearMarker& one : markers) {
    auto document = protocol::files::marker_document(one.file, protocol::files::FileFormat::kNative);
    if (!document) return document.error();
    documents.push_back(*std::move(document));
  }
  return documents;
}

}  // namespace selvage::cli::library
