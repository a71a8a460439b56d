#include "protocol/trade/aama/inserts.h"

#include <cmath>
#include <map>
#include <string>

#include "protocol/json/json_text.h"
#include "protocol/trade/aama/finishing.h"
#include "protocol/trade/aama/piece_texts.h"

namespace selvage::protocol::trade::aama {
namespace {

struct Insertions {
  int as_drawn{}, mirrored{};
  double scale{};  // of the first; 0: its axes are scaled differently
  bool agree{true};
};

void count(const dxf::strokes::Insertion& insert, Insertions& insertions) {
  const double scale = insert.scales_evenly() ? insert.scale() : 0;
  const bool first = insertions.as_drawn + insertions.mirrored == 0;
  if (first) insertions.scale = scale;
  insertions.agree = insertions.agree && std::abs(scale - insertions.scale) <= 1e-9 * scale;
  ++(insert.mirrors() ? insertions.mirrored : insertions.as_drawn);
}

void follow(const Insertions& insertions, PatternBlock& block, std::vector<Note>& notes) {
  const auto note = [&](const std::string& what) {
    notes.push_back(note_at(block.line, "block " + in_quotes(block.name) + what));
  };
  block.inserted = insertions.as_drawn;
  block.inserted_mirrored = insertions.mirrored;
  if (!insertions.agree || !(insertions.scale > 0)) {
    note(" is inserted at different scales, or scaled differently along its axes; read as drawn");
  } else if (insertions.scale != 1) {
    scale(block, insertions.scale);
    note(" is inserted at the scale " + json::number_text(insertions.scale) + ", which is applied");
  }
  if (insertions.as_drawn == 0) note(" is inserted mirrored, and its piece is read so");
  if (insertions.as_drawn > 0 && insertions.mirrored > 0) note(" is inserted as drawn and mirrored");
  const int times = insertions.as_drawn + insertions.mirrored;
  if (times > 1) note(" is inserted " + std::to_string(times) + " times; its quantity counts");
}

}  // namespace

void follow_inserts(const std::vector<blocks::PieceInsert>& inserts, Encoding encoding,
                    std::vector<PatternBlock>& blocks, std::vector<Note>& notes) {
  std::map<std::string, Insertions, std::less<>> inserted;
  for (const blocks::PieceInsert& insert : inserts) {
    const std::string name = decoded(insert.name, encoding);
    if (!insert.block) {
      notes.push_back(note_at(insert.line, "INSERT of block " + in_quotes(name) + ", which is not in the file"));
    }
    count(insert.insertion, inserted[in_capitals(name)]);
  }
  if (inserted.empty()) return;
  for (PatternBlock& block : blocks) {
    const auto insertions = inserted.find(in_capitals(block.name));
    if (insertions != inserted.end()) {
      follow(insertions->second, block, notes);
    } else {
      notes.push_back(note_at(block.line, "block " + in_quotes(block.name) + " is never inserted; read all the same"));
    }
  }
}

}  // namespace selvage::protocol::trade::aama
