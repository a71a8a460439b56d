#include "protocol/trade/aama/inserts.h"

#include <cmath>
#include <map>
#include <set>
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

// The absolute value of the scale; 0 when the axes differ.
double scale_of(const dxf::Entity& insert) {
  const double x = std::abs(insert.number(41).value_or(1)), y = std::abs(insert.number(42).value_or(1));
  return std::abs(x - y) <= 1e-6 * x ? x : 0;
}

void count(const dxf::Entity& insert, Insertions& insertions) {
  const double scale = scale_of(insert);
  const bool first = insertions.as_drawn + insertions.mirrored == 0;
  if (first) insertions.scale = scale;
  insertions.agree = insertions.agree && scale == insertions.scale;
  const bool mirrored = insert.number(41).value_or(1) * insert.number(42).value_or(1) < 0;
  ++(mirrored ? insertions.mirrored : insertions.as_drawn);
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

void follow_inserts(const dxf::DxfDrawing& drawing, Encoding encoding, std::vector<PatternBlock>& blocks,
                    std::vector<Note>& notes) {
  const auto name_of = [&](std::string_view name) { return in_capitals(decoded(name, encoding)); };
  std::set<std::string, std::less<>> known;
  std::map<std::string, Insertions, std::less<>> inserted;
  for (const dxf::Block& block : drawing.blocks) known.insert(name_of(block.name));
  for (const dxf::Entity& entity : drawing.entities) {
    if (entity.type != "INSERT") continue;
    if (!known.contains(name_of(entity.text(2)))) {
      notes.push_back(note_at(entity.line, "INSERT of block " + in_quotes(decoded(entity.text(2), encoding)) +
                                               ", which is not in the file"));
    }
    count(entity, inserted[name_of(entity.text(2))]);
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
