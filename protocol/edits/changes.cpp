#include "protocol/edits/changes.h"

#include <unordered_map>
#include <utility>

#include "core/marker/figures.h"
#include "protocol/calls/method.h"

namespace selvage::protocol::edits {
namespace {

// True if only pieces differ.
bool same_frame(const MarkerFile& before, const MarkerFile& after) {
  Marker rest = before.marker;
  rest.pieces = after.marker.pieces;
  return rest == after.marker;
}

}  // namespace

MarkerFile with_marker(const MarkerFile& file, Marker next) {
  MarkerFile after{.marker = {}, .format = file.format, .notes = {}, .attributes = {}};
  after.attributes.whole = file.attributes.whole;
  after.attributes.shapes = file.attributes.shapes;
  std::unordered_map<std::string_view, const Json*> attributes;
  const auto list = [&attributes](const std::vector<Piece>& pieces, const std::vector<Json>& of_pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) attributes.emplace(pieces[i].id, &of_pieces[i]);
  };
  list(file.marker.pieces, file.attributes.pieces);
  list(file.marker.unplaced, file.attributes.unplaced);
  for (const Piece& piece : next.pieces) after.attributes.pieces.push_back(*attributes.at(piece.id));
  for (const Piece& piece : next.unplaced) after.attributes.unplaced.push_back(*attributes.at(piece.id));
  after.marker = std::move(next);
  return after;
}

Change change_between(const MarkerFile& before, const MarkerFile& after) {
  std::unordered_map<std::string_view, const Piece*> gone;
  for (const Piece& piece : before.marker.pieces) gone.emplace(piece.id, &piece);
  Change change;
  for (const Piece& piece : after.marker.pieces) {
    const auto found = gone.find(piece.id);
    if (found == gone.end() || *found->second != piece)
      change.placements.push_back(calls::state_of(after.marker, piece));
    if (found != gone.end()) gone.erase(found);
  }
  for (const Piece& piece : before.marker.pieces) {
    if (gone.contains(piece.id)) change.removed.push_back(piece.id);
  }
  if (!same_frame(before, after)) change.whole = true;
  const marker::Figures figures = figures_of(after.marker);
  change.name = after.marker.name;
  change.pieces = piece_count(after.marker);
  change.length = to_decimal(figures.length, after.marker.resolution);
  change.utilisation = figures.utilisation;
  change.valid = figures.valid;
  return change;
}

ApplyResult apply_result(const std::string& marker_id, Revision revision, const MarkerFile& before, MarkerFile& after) {
  Change change = change_between(before, after);
  const Revision next = change.none() ? revision : revision + 1;
  ApplyResult result{{{marker_id, next}, std::move(change)}, {}};
  if (!after.notes.empty()) result.notes = calls::notes_of(after.notes);
  after.notes.clear();
  return result;
}

calls::Method apply_method() {
  return calls::served_method<ApplyParams, ApplyResult>("marker.apply", calls::MethodKind::kStep,
                                                        "Applies operations to the marker, all or none.");
}

calls::Method undo_method() {
  return calls::served_method<ChangeParams, CommittedChange>("marker.undo", calls::MethodKind::kStep,
                                                             "Undoes the last change.");
}

calls::Method redo_method() {
  return calls::served_method<ChangeParams, CommittedChange>("marker.redo", calls::MethodKind::kStep,
                                                             "Redoes the last undone change.");
}

}  // namespace selvage::protocol::edits
