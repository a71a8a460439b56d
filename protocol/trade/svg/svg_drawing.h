// The lines that an SVG drawing shows: its paths and basic shapes, with all transforms, <use> and nested views
// resolved.
//
// Units: millimetres, y upwards.  What is not read is reported in notes.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/trade/loops.h"
#include "protocol/trade/options.h"
#include "protocol/trade/style.h"

namespace selvage::protocol::trade::svg {

struct Drawn {
  std::string classes, name;
  std::vector<Run> runs;
  bool grain{}, fold{};
  bool used{};  // by <use>, as FreeSewing draws notches, buttons and its logo
};

// Whether the word is one of those in the text, which blanks separate.
[[nodiscard]] bool has_word(std::string_view text, std::string_view word);

// `bytes`: of the file, which limits how finely its curves are flattened (flattening.h).  Errors: kOutOfRange when that
// does not suffice, and when <use> repeats so much that more than 200,000 elements and points would be drawn.
[[nodiscard]] Result<std::vector<Drawn>> drawn_lines(const pugi::xml_node& svg, std::size_t bytes,
                                                     const ReadingOptions& options, std::vector<Note>& notes);

}  // namespace selvage::protocol::trade::svg
