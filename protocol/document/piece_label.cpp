#include "protocol/document/piece_label.h"

#include <string>
#include <vector>

#include "protocol/json/fields.h"

namespace selvage::protocol::document {
namespace {

std::string text_in(const std::vector<Json>& attributes, std::size_t at, const char* key) {
  if (at >= attributes.size() || !attributes[at].is_object()) return {};
  const auto found = attributes[at].find(key);
  if (found == attributes[at].end()) return {};
  if (found->is_string()) return found->get<std::string>();
  const auto number = json::whole_number(*found);
  return number ? std::to_string(*number) : std::string{};
}

std::string text_of_piece(const MarkerFile& file, std::size_t position, const char* key) {
  const std::size_t placed = file.marker.pieces.size();
  const bool is_placed = position < placed;
  const Piece& piece = is_placed ? file.marker.pieces[position] : file.marker.unplaced[position - placed];
  std::string text = is_placed ? text_in(file.attributes.pieces, position, key)
                               : text_in(file.attributes.unplaced, position - placed, key);
  return text.empty() ? text_in(file.attributes.shapes, piece.shape.value, key) : text;
}

}  // namespace

std::string name_of_piece(const MarkerFile& file, std::size_t position) {
  return text_of_piece(file, position, "name");
}

std::string size_of_piece(const MarkerFile& file, std::size_t position) {
  return text_of_piece(file, position, "size");
}

}  // namespace selvage::protocol::document
