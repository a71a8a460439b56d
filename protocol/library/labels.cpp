#include "protocol/library/labels.h"

#include <algorithm>
#include <vector>

#include "protocol/document/piece_label.h"

namespace selvage::protocol::library {
namespace {

// Bytes of characters beyond ASCII belong to words.
bool is_in_word(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         (static_cast<unsigned char>(c) & 0x80U) != 0;
}

std::vector<std::string_view> words_of(std::string_view name) {
  std::vector<std::string_view> words;
  for (std::size_t begin = 0; begin < name.size();) {
    std::size_t end = begin;
    while (end < name.size() && is_in_word(name[end])) ++end;
    if (end > begin) words.push_back(name.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

}  // namespace

matching::Label label_from(std::string_view name, std::string_view size) {
  matching::Label label{std::string{name}, std::string{size}};
  const std::vector<std::string_view> words = words_of(name);
  if (std::ranges::count(words, size) != 1) return label;
  const std::string_view word = *std::ranges::find(words, size);
  label.name.erase(static_cast<std::size_t>(word.data() - name.data()), word.size());
  return label;
}

matching::LabelledMarker labelled(const MarkerFile& file) {
  matching::LabelledMarker labelled{file.marker, {}};
  const std::size_t pieces = file.marker.pieces.size() + file.marker.unplaced.size();
  for (std::size_t position = 0; position < pieces; ++position) {
    labelled.labels.push_back(
        label_from(document::name_of_piece(file, position), document::size_of_piece(file, position)));
  }
  return labelled;
}

}  // namespace selvage::protocol::library
