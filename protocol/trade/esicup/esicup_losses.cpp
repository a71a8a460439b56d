#include <algorithm>
#include <cmath>
#include <vector>

#include "protocol/document/xml_text.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/json/json_text.h"
#include "protocol/trade/esicup/esicup.h"

namespace selvage::protocol::trade::esicup {
namespace {

// The shapes that are written: those with a copy that is not a zone.
std::vector<const Shape*> written_shapes(const Marker& marker) {
  std::vector<bool> used(marker.shapes.size());
  for (const auto* pieces : {&marker.pieces, &marker.unplaced}) {
    for (const Piece& piece : *pieces) {
      if (!piece.rules.zone) used[piece.shape.value] = true;
    }
  }
  std::vector<const Shape*> shapes;
  for (std::size_t k = 0; k < used.size(); ++k) {
    if (used[k]) shapes.push_back(&marker.shapes[k]);
  }
  return shapes;
}

std::string length_text(Coord length, const Marker& marker) {
  return json::number_text(to_decimal(length, marker.resolution)) + " " + marker.unit;
}

void add_overlap(const Marker& marker, std::vector<Note>& notes) {
  Coord most = 0;
  for (const Piece& piece : marker.pieces) {
    if (!piece.rules.zone) most = std::max(most, piece.overlap.value_or(marker.overlap));
  }
  if (most == 0) return;
  notes.push_back({"", "overlap allowances, of " + length_text(most, marker) +
                           " at most, are left out: pieces that overlap are not valid when the file is read"});
}

void add_turning(const std::vector<const Shape*>& shapes, std::vector<Note>& notes) {
  const auto free =
      std::count_if(shapes.begin(), shapes.end(), [](const Shape* one) { return one->rotations.empty(); });
  if (free > 0) {
    notes.push_back({"", "shapes that may be rotated freely, " + std::to_string(free) +
                             " in all, are written with only the angles at which their pieces lie: ESICUP XML lists "
                             "single angles"});
  }
  const auto tilting =
      std::count_if(shapes.begin(), shapes.end(), [](const Shape* one) { return one->tilt_limit.degrees > 0; });
  if (tilting > 0) notes.push_back({"", "tilt limits are left out, " + std::to_string(tilting) + " in all"});
}

// Whether the numbers that are written lead their reader to the marker's own resolution.
bool states_resolution(const Marker& marker) {
  if (converts_unit(marker)) return false;
  Marker bare;
  bare.resolution = marker.resolution;
  bare.strip.width = marker.strip.width;
  bare.shapes = marker.shapes;
  for (const Piece& piece : marker.pieces) {
    if (piece.rules.zone) continue;
    Piece& added = bare.pieces.emplace_back();
    added.shape = piece.shape;
    added.orientation = piece.orientation;
    added.at = piece.at;
  }
  return formats::resolution_chosen_for(bare) == marker.resolution;
}

// A turn that is no multiple of 90 degrees is rounded to the lattice.
void add_resolution(const Marker& marker, std::vector<Note>& notes) {
  const bool rounded = std::any_of(marker.pieces.begin(), marker.pieces.end(), [](const Piece& piece) {
    const double degrees = piece.orientation.rotation.degrees + piece.orientation.tilt.degrees;
    return !piece.rules.zone && std::fmod(degrees, 90.0) != 0;
  });
  if (!rounded || states_resolution(marker)) return;
  notes.push_back({"", "ESICUP XML states no resolution: corners of turned pieces, which are rounded to multiples of " +
                           length_text(1, marker) + ", may lie that far away when the file is read"});
}

void add_characters(const Marker& marker, const std::vector<const Shape*>& shapes, std::vector<Note>& notes) {
  std::vector<const std::string*> changed;
  const auto add = [&](const std::string& text) {
    if (document::xml_text(text) != text) changed.push_back(&text);
  };
  add(marker.name);
  for (const Shape* const shape : shapes) add(shape->id);
  if (changed.empty()) return;
  notes.push_back({"", std::to_string(changed.size()) + (changed.size() == 1 ? " text has" : " texts have") +
                           " characters that XML does not have, and which are replaced; the first is " +
                           json::shortened(Json(*changed.front()))});
}

}  // namespace

std::vector<Note> esicup_losses(const Marker& marker) {
  const auto shapes = written_shapes(marker);
  std::vector<Note> notes;
  if (auto note = unit_note(marker)) notes.push_back(*std::move(note));
  add_overlap(marker, notes);
  add_turning(shapes, notes);
  add_resolution(marker, notes);
  add_characters(marker, shapes, notes);
  return notes;
}

}  // namespace selvage::protocol::trade::esicup
