#include "server/store/restored_marker.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "protocol/edits/moves.h"
#include "protocol/formats/native.h"
#include "protocol/json/json_text.h"
#include "server/memory/weights.h"

namespace selvage::server::store {
namespace {

using Account = std::shared_ptr<memory::ByteAccount>;

Result<Format> format_named(const std::string& name) {
  const auto* const found =
      std::find(std::begin(protocol::document::kFormatNames), std::end(protocol::document::kFormatNames), name);
  if (found == std::end(protocol::document::kFormatNames)) {
    return Error{ErrorCode::kWrongType, "an unknown format", ""};
  }
  return static_cast<Format>(found - std::begin(protocol::document::kFormatNames));
}

// Reads a document that the journal wrote.
Result<MarkerFile> read_document(const std::string& format, const std::string& document) {
  auto file = protocol::formats::read_marker(document);
  if (!file) return file;
  const auto read_from = format_named(format);
  if (!read_from) return read_from.error();
  file->format = *read_from;
  file->notes.clear();
  return file;
}

Result<protocol::edits::Moves> read_moves_text(const std::string& text, const Marker& marker) {
  const auto list = protocol::json::parse(text);
  if (!list) return list.error();
  return protocol::edits::read_moves(*list, marker);
}

// Reads a step of the history that starts from `marker`.
Result<History::Back> read_back(const disk::StoredStep& step, const Marker& marker, const Account& account) {
  if (!step.format.empty()) {
    auto file = read_document(step.format, step.step);
    if (!file) return file.error();
    const std::size_t bytes = memory::bytes_of(*file);
    return History::Back{memory::weighed(*std::move(file), memory::HeldBytes{account, bytes})};
  }
  auto moves = read_moves_text(step.step, marker);
  if (!moves) return moves.error();
  return History::Back{*std::move(moves)};
}

// Returns the steps, oldest first.  Each step is read relative to the marker that the next newer step leads to.
Result<std::vector<History::Step>> history_of(const disk::StoredMarker& stored, const MarkerFile& now,
                                              UndoDirection direction, const Account& account) {
  std::vector<History::Step> steps;
  MarkerFile at = now;
  for (std::size_t k = stored.history.size(); k-- > 0;) {
    const disk::StoredStep& step = stored.history[k];
    if (step.way != way_of(direction)) continue;
    auto back = read_back(step, at.marker, account);
    if (!back) return back.error();
    at = after_step(*back, std::move(at));
    steps.push_back({step.serial, *std::move(back)});
  }
  std::reverse(steps.begin(), steps.end());
  return steps;
}

}  // namespace

Result<RestoredMarker> restore_marker(const disk::StoredMarker& stored, const Account& account) {
  auto snapshot = read_document(stored.format, stored.document);
  if (!snapshot) return snapshot.error();
  MarkerFile file = *std::move(snapshot);
  for (const std::string& step : stored.steps) {
    const auto moves = read_moves_text(step, file.marker);
    if (!moves) return moves.error();
    file = moved(std::move(file), *moves);
  }
  auto undo = history_of(stored, file, UndoDirection::kUndo, account);
  if (!undo) return undo.error();
  auto redo = history_of(stored, file, UndoDirection::kRedo, account);
  if (!redo) return redo.error();
  return RestoredMarker{std::move(file), {*std::move(undo), *std::move(redo)}};
}

std::size_t bytes_of(const disk::StoredMarker& stored) {
  std::size_t bytes = sizeof stored + stored.summary.size() + stored.document.size();
  for (const std::string& step : stored.steps) bytes += sizeof(std::string) + step.size();
  for (const disk::StoredStep& step : stored.history) bytes += sizeof step + step.format.size() + step.step.size();
  return bytes;
}

KeptAnswers restore_answers(const std::vector<disk::StoredAnswer>& stored) {
  KeptAnswers answers;
  for (const disk::StoredAnswer& answer : stored) {
    answers.keep({.op_id = answer.op,
                  .method = answer.method,
                  .result = std::make_shared<const std::string>(answer.result),
                  .client = answer.client,
                  .params = answer.params,
                  .serial = answer.serial});
  }
  return answers;
}

}  // namespace selvage::server::store
