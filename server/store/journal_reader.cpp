#include "server/store/journal_reader.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "protocol/formats/native.h"

namespace selvage::server::store {
namespace {

Result<Format> format_named(const std::string& name) {
  const auto* const found =
      std::find(std::begin(protocol::document::kFormatNames), std::end(protocol::document::kFormatNames), name);
  if (found == std::end(protocol::document::kFormatNames)) {
    return Error{ErrorCode::kWrongType, "an unknown format", ""};
  }
  return static_cast<Format>(found - std::begin(protocol::document::kFormatNames));
}

// A document as the journal wrote it.
Result<MarkerFile> read_document(const std::string& format, const std::string& document) {
  auto file = protocol::formats::read_marker(document);
  if (!file) return file;
  const auto read_from = format_named(format);
  if (!read_from) return read_from.error();
  file->format = *read_from;
  file->notes.clear();
  return file;
}

// A step of the history that leads away from `marker`.
Result<History::Back> read_back(const std::string& format, const std::string& text, const Marker& marker) {
  if (!format.empty()) {
    auto file = read_document(format, text);
    if (!file) return file.error();
    return History::Back{std::make_shared<const MarkerFile>(*std::move(file))};
  }
  const auto list = protocol::json::parse(text);
  if (!list) return list.error();
  auto moves = protocol::edits::read_moves(*list, marker);
  if (!moves) return moves.error();
  return History::Back{*std::move(moves)};
}

}  // namespace

Restored JournalReader::restore() {
  Restored all;
  tables_.read_opened.with();
  if (tables_.read_opened.step()) all.opened = static_cast<std::uint64_t>(tables_.read_opened.integer(0));
  tables_.read_opened.with();  // ends the reading
  all.answers = answers_of("");
  Statement& row = tables_.read_snapshots;
  row.with();
  while (row.step()) {
    auto marker = restore_marker(row.text(0), static_cast<Revision>(row.integer(1)), row.text(2), row.text(3));
    if (marker) all.markers.push_back(*std::move(marker));
  }
  row.with();  // ends the reading
  return all;
}

std::vector<KeptAnswer> JournalReader::answers_of(const std::string& id) {
  std::vector<KeptAnswer> answers;
  Statement& row = tables_.read_answers;
  row.with(id, std::uint64_t{KeptAnswers::kMost});
  while (row.step()) {
    answers.push_back({row.text(0), row.text(1), std::make_shared<const std::string>(row.text(2))});
  }
  std::reverse(answers.begin(), answers.end());
  return answers;
}

std::optional<RestoredMarker> JournalReader::restore_marker(const std::string& id, Revision revision,
                                                            const std::string& format, const std::string& document) {
  auto file = read_document(format, document);
  if (!file) {
    spdlog::error("the store: marker {} cannot be read and is left out: {}", id, file.error().message);
    return std::nullopt;
  }
  RestoredMarker marker{id, revision, *std::move(file), answers_of(id)};
  budget_.begin(id, document.size());
  apply_steps(marker);
  marker.history = {history_of(marker, UndoDirection::kUndo), history_of(marker, UndoDirection::kRedo)};
  return marker;
}

// Applies the steps since the snapshot, up to the first one that cannot be read or leaves out a revision.
void JournalReader::apply_steps(RestoredMarker& marker) {
  Statement& row = tables_.read_steps;
  row.with(marker.id, marker.revision);
  while (row.step()) {
    const auto revision = static_cast<Revision>(row.integer(0));
    const std::string text = row.text(1);
    const auto list = protocol::json::parse(text);
    const auto moves =
        list ? protocol::edits::read_moves(*list, marker.file.marker) : Result<protocol::edits::Moves>{list.error()};
    if (!moves || revision != marker.revision + 1) {
      remove_later_steps(marker, moves ? "a revision is missing" : moves.error().message);
      return;
    }
    marker.file = moved(std::move(marker.file), *moves);
    marker.revision = revision;
    (void)budget_.use(marker.id, text.size());
  }
}

void JournalReader::remove_later_steps(const RestoredMarker& marker, const std::string& reason) {
  spdlog::warn("the store: the revisions of marker {} after {} cannot be read and were removed: {}", marker.id,
               marker.revision, reason);
  tables_.read_steps.with(marker.id, marker.revision);  // ends the reading
  tables_.delete_steps_after.with(marker.id, marker.revision).run();
  tables_.delete_history.with(marker.id).run();  // it leads back from the revisions that were removed
}

// Oldest first.  Each step is read from the marker that the next newer one leads to.
std::vector<History::Step> JournalReader::history_of(const RestoredMarker& marker, UndoDirection direction) {
  std::vector<History::Step> steps;
  MarkerFile at = marker.file;
  Statement& row = tables_.read_history;
  row.with(marker.id, column_value(direction));
  while (row.step()) {
    const auto serial = static_cast<std::uint64_t>(row.integer(0));
    auto back = read_back(row.text(1), row.text(2), at.marker);
    if (!back) {
      spdlog::warn("the store: {} steps of marker {} beyond the last {} cannot be read and were removed: {}",
                   direction == UndoDirection::kUndo ? "undo" : "redo", marker.id, steps.size(), back.error().message);
      row.with(marker.id, column_value(direction));  // ends the reading
      tables_.delete_history_until.with(marker.id, column_value(direction), serial).run();
      break;
    }
    at = after_step(*back, std::move(at));
    steps.push_back({serial, *std::move(back)});
  }
  std::reverse(steps.begin(), steps.end());
  return steps;
}

}  // namespace selvage::server::store
