#include "protocol/edits/blame.h"

#include <utility>

namespace selvage::protocol::edits {
namespace {

// A pointer, relative to a piece in the native format, to the field if the edit gave it; otherwise empty.
std::string given_at(const Edit& edit, const std::string& field) {
  if (std::holds_alternative<AddPiece>(edit) && !field.empty()) return "/piece" + field;
  const bool same = (std::holds_alternative<RulesOfPiece>(edit) && field.starts_with("/rules")) ||
                    (std::holds_alternative<BufferPiece>(edit) && field == "/buffer") ||
                    (std::holds_alternative<OverlapPiece>(edit) && field == "/overlap");
  return same ? field : "";
}

// The same for a field of the strip.
bool gives(const SetStrip& edit, std::string_view field) {
  return (field.starts_with("/width") && edit.width) || (field.starts_with("/longest") && edit.longest) ||
         (field.starts_with("/margin") && edit.margin) || (field.starts_with("/below") && edit.below) ||
         (field.starts_with("/above") && edit.above) || (field.starts_with("/repeat") && edit.repeat) ||
         (field.starts_with("/tube") && edit.tube);
}

std::string pointer_into_strip(std::size_t last, std::span<const Edit> edits, const std::string& field) {
  for (std::size_t k = last + 1; k-- > 0;) {
    const auto* const edit = std::get_if<SetStrip>(&edits[k]);
    if (edit != nullptr && gives(*edit, field)) return pointer_of(k, field);
  }
  return pointer_of(last);
}

}  // namespace

std::string pointer_of(std::size_t edit, std::string_view field) {
  return "/ops/" + std::to_string(edit) + std::string{field};
}

Error Blame::at_its_edit(Error error, std::span<const Edit> edits) const {
  constexpr std::string_view kPieces = "/pieces/", kShapes = "/shapes/", kStrip = "/strip";
  const std::string field = std::exchange(error.field, {});
  // The index after the name of a list, and the rest of the pointer.
  const auto below = [&](std::string_view list) {
    const std::size_t end = std::min(field.find('/', list.size()), field.size());
    return std::pair{std::stoul(field.substr(list.size(), end - list.size())), field.substr(end)};
  };
  if (field.starts_with(kPieces)) {
    const auto [index, rest] = below(kPieces);
    const bool by_rules = rest.starts_with("/rules") && index < rules.size() && rules[index] != kNoEdit;
    const std::size_t edit = by_rules ? rules[index] : index < pieces.size() ? pieces[index] : kNoEdit;
    if (edit != kNoEdit) error.field = pointer_of(edit, given_at(edits[edit], rest));
  } else if (field.starts_with(kShapes)) {
    const auto [index, rest] = below(kShapes);
    const std::size_t edit = index < shapes.size() ? shapes[index] : kNoEdit;
    if (edit != kNoEdit) error.field = pointer_of(edit, "/shape" + rest);
  }
  if (!error.field.empty()) return error;
  if (field.starts_with("/spacing") && spacing != kNoEdit) {
    error.field = pointer_of(spacing, "/spacing");
  } else if (field.starts_with("/overlap") && overlap != kNoEdit) {
    error.field = pointer_of(overlap, "/overlap");
  } else if (field.starts_with("/shade") && shade != kNoEdit) {
    error.field = pointer_of(shade, "/shade");
  } else if (strip != kNoEdit && field.starts_with(kStrip)) {
    error.field = pointer_into_strip(strip, edits, field.substr(kStrip.size()));
  } else if (strip != kNoEdit && field.starts_with(kPieces)) {
    error.field = pointer_of(strip);
  } else {
    error.field = "/ops";
  }
  return error;
}

}  // namespace selvage::protocol::edits
