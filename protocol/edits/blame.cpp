#include "protocol/edits/blame.h"

#include <utility>

namespace selvage::protocol::edits {

std::string pointer_of(std::size_t edit, std::string_view field) {
  return "/ops/" + std::to_string(edit) + std::string{field};
}

Error Blame::at_its_edit(Error error) const {
  const std::string field = std::exchange(error.field, {});
  const auto below = [&](std::string_view list, const std::vector<std::size_t>& by, std::string_view name) {
    if (!field.starts_with(list)) return false;
    const std::size_t index = std::stoul(field.substr(list.size()));
    const std::size_t edit = index < by.size() ? by[index] : kNoEdit;
    if (edit != kNoEdit) error.field = pointer_of(edit, name);
    return edit != kNoEdit;
  };
  if (below("/pieces/", pieces, "") || below("/shapes/", shapes, "/shape")) return error;
  if (field.starts_with("/spacing") && spacing != kNoEdit) {
    error.field = pointer_of(spacing, "/spacing");
  } else if (field.starts_with("/overlap") && overlap != kNoEdit) {
    error.field = pointer_of(overlap, "/overlap");
  } else if (field.starts_with("/shade") && shade != kNoEdit) {
    error.field = pointer_of(shade, "/shade");
  } else if (strip != kNoEdit && (field.starts_with("/strip") || field.starts_with("/pieces/"))) {
    error.field = pointer_of(strip);
  } else {
    error.field = "/ops";
  }
  return error;
}

}  // namespace selvage::protocol::edits
