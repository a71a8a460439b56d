// One block of a pattern file: a piece as its writer drew it, sorted by the layers of ASTM D6673.
//
// Units: the file's, in the file's own orientation.  Fields that the block does not contain stay empty: AccuMark
// writes quantity, material and "NM" only into the block of the sample size, and the style gives them to the other
// sizes (pattern_file.h).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "protocol/trade/dxf/drawing.h"
#include "protocol/trade/dxf/strokes/insertion.h"
#include "protocol/trade/flattening.h"
#include "protocol/trade/loops.h"
#include "protocol/trade/style.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::aama::blocks {

using Texts = std::map<std::string, std::string>;  // key -> value

// A point that moves with the size: "# 12".
struct GradedPoint {
  int rule{};
  Spot at;
  std::size_t line{};
};

struct PatternBlock {
  std::string name;           // of the block
  Texts texts;                // "QUANTITY" -> "1,1"; keys in capitals
  std::vector<Run> boundary;  // layer 1
  document::Annotations annotations;
  std::vector<bool> mirrored;          // of each of the annotations' lines: drawn on both halves of a folded piece
  std::vector<Spot> unmirrored_spots;  // the positions of "NM"
  std::vector<std::pair<Spot, Spot>> grains, mirror_lines, grade_references;  // layers 7, 6, 5
  std::vector<GradedPoint> graded_points;
  int inserted{}, inserted_mirrored{};  // how often, as drawn and mirrored; inserts.h
  std::size_t line{};

  [[nodiscard]] const std::string* text(const std::string& key) const;
};

// What the blocks of a file have in common, and the collection of their oddities.
struct BlockReading {
  Encoding encoding{};
  Flattening flattening;                             // in the file's unit
  std::map<std::string, std::size_t> passed_over{};  // a layer that is not read -> the first line of it
  std::vector<Note> notes{};
  dxf::strokes::Blocks* blocks{};  // that the block may insert; null: INSERTs are not followed
};

// Reads the block with those that it inserts, which belong to the same piece; its own texts take precedence over
// theirs.
// Check the error of reading.blocks afterwards.
[[nodiscard]] PatternBlock read_pattern_block(const dxf::Block& block, BlockReading& reading);

// Depths of less than a millimetre in all blocks of a file are centimetres, because Browzwear writes them so.  Returns
// whether there are such depths.  Units: millimetres.
bool enlarge_shallow_notches(std::vector<PatternBlock>& blocks);

// "Piece Name: FRONT", or with = for the colon, as its key in capitals and its value; none if the text is not such a
// pair with a known key.
[[nodiscard]] std::optional<std::pair<std::string, std::string>> key_and_value(std::string_view text);

}  // namespace selvage::protocol::trade::aama::blocks

namespace selvage::protocol::trade::aama {
using blocks::PatternBlock;
using blocks::Texts;
}  // namespace selvage::protocol::trade::aama
