#include "server/memory/weights.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace selvage::server::memory {
namespace {

constexpr std::size_t kAllocation = 16;                       // that the allocator adds to a block, on average
constexpr std::size_t kInline = sizeof(std::string) / 2 - 1;  // characters of a text that take no block of their own

std::size_t block(std::size_t bytes) {
  return bytes == 0 ? 0 : bytes + kAllocation;
}

// Besides the string itself.
std::size_t bytes_in(const std::string& text) {
  return text.capacity() > kInline ? block(text.capacity() + 1) : 0;
}

template <class Element>
std::size_t bytes_in(const std::vector<Element>& elements) {
  return block(elements.capacity() * sizeof(Element));
}

// Besides the value itself.
std::size_t bytes_in(const Json& value) {
  std::size_t bytes = 0;
  if (value.is_string()) {
    bytes = block(sizeof(std::string)) + bytes_in(value.text());
  } else if (value.is_array()) {
    bytes = block(sizeof(Json::Array)) + block(value.size() * sizeof(Json));
    for (const Json& element : value) bytes += bytes_in(element);
  } else if (value.is_object()) {
    bytes = block(sizeof(Json::Object)) + block(value.size() * sizeof(Json::Object::value_type));
    for (const auto& [key, field] : value.items()) bytes += bytes_in(key) + bytes_in(field);
  }
  return bytes;
}

std::size_t bytes_in(const Piece& piece) {
  return bytes_in(piece.id) + bytes_in(piece.group) + bytes_in(piece.rules.shade) +
         (piece.rules.part ? bytes_in(piece.rules.part->outline) : 0);
}

template <class Element>
std::size_t bytes_in_all(const std::vector<Element>& elements) {
  std::size_t bytes = bytes_in(elements);
  for (const Element& element : elements) bytes += bytes_in(element);
  return bytes;
}

std::size_t bytes_in(const protocol::document::Attributes& attributes) {
  return bytes_in(attributes.whole) + bytes_in_all(attributes.shapes) + bytes_in_all(attributes.pieces) +
         bytes_in_all(attributes.unplaced);
}

// Counts blocks of at most 255 characters in a variable of one byte, so that the compiler vectorises the loop.
std::size_t count_of(char wanted, std::string_view text) {
  constexpr std::size_t kMost = 255;
  std::size_t count = 0;
  for (; !text.empty(); text.remove_prefix(std::min(text.size(), kMost))) {
    std::uint8_t found = 0;
    for (const char byte : text.substr(0, kMost)) found = static_cast<std::uint8_t>(found + (byte == wanted ? 1 : 0));
    count += found;
  }
  return count;
}

}  // namespace

std::size_t bytes_of(const Json& value) {
  return sizeof(Json) + bytes_in(value);
}

std::size_t bytes_of(const Marker& marker) {
  std::size_t bytes = sizeof(Marker) + bytes_in(marker.name) + bytes_in(marker.unit) + bytes_in(marker.shapes) +
                      bytes_in_all(marker.pieces) + bytes_in_all(marker.unplaced);
  for (const Shape& shape : marker.shapes)
    bytes += bytes_in(shape.id) + bytes_in(shape.outline) + bytes_in(shape.rotations);
  return bytes;
}

std::size_t bytes_of(const MarkerFile& file) {
  std::size_t bytes = sizeof(MarkerFile) + bytes_of(file.marker) + bytes_in(file.notes) + bytes_in(file.attributes);
  for (const Note& note : file.notes) bytes += bytes_in(note.field) + bytes_in(note.text);
  return bytes;
}

std::size_t bytes_of(const protocol::edits::Moves& moves) {
  std::size_t bytes = sizeof(protocol::edits::Moves) + bytes_in(moves);
  for (const protocol::edits::Move& move : moves) bytes += bytes_in(move.piece);
  return bytes;
}

std::size_t bytes_for_readers(const MarkerFile& file) {
  constexpr std::size_t kTextOfVertex = 24, kTextOfPiece = 120, kLaidOutPiece = 200;
  constexpr std::size_t kTurned = 4;  // orientations in which an untilted shape usually lies
  const Marker& marker = file.marker;
  std::vector<std::size_t> copies(marker.shapes.size());  // outlines of tilted pieces, which are not shared
  std::vector<std::size_t> untilted(marker.shapes.size());
  for (const Piece& piece : marker.pieces) {
    if (piece.orientation.tilt == Angle{}) {
      ++untilted[piece.shape.value];
    } else {
      ++copies[piece.shape.value];
    }
  }
  std::size_t bytes = (marker.pieces.size() + marker.unplaced.size()) * (kTextOfPiece + kLaidOutPiece);
  for (std::size_t k = 0; k < marker.shapes.size(); ++k) {
    const std::size_t outlines = copies[k] + std::min(untilted[k], kTurned);
    bytes += marker.shapes[k].outline.size() * (kTextOfVertex + outlines * sizeof(Vec));
  }
  return bytes + bytes_in(file.attributes);
}

std::size_t bytes_to_read(std::string_view message) {
  constexpr std::size_t kElement = 2 * sizeof(Json);  // including the spare capacity of a growing array
  constexpr std::size_t kContainer = sizeof(Json::Array) + kAllocation + kElement;
  constexpr std::size_t kField = 2 * sizeof(Json::Object::value_type) - kElement;
  constexpr std::size_t kHalfAText = (sizeof(std::string) + kAllocation) / 2;
  return 2 * message.size() + count_of(',', message) * kElement +
         (count_of('[', message) + count_of('{', message)) * kContainer + count_of(':', message) * kField +
         count_of('"', message) * kHalfAText;
}

}  // namespace selvage::server::memory
