#include "protocol/trade/aama/blocks/pattern_blocks.h"

#include <algorithm>
#include <string>
#include <utility>

#include "protocol/json/json_text.h"
#include "protocol/trade/aama/blocks/loose_pieces.h"

namespace selvage::protocol::trade::aama::blocks {
namespace {

// Paper space, the drawings of dimensions and the like; a block *U is one without a name.
bool is_anonymous(std::string_view name) {
  return name.starts_with('*') && !in_capitals(name).starts_with("*U");
}

class Gatherer {
 public:
  Gatherer(const dxf::DxfDrawing& drawing, BlockReading& reading) : drawing_{drawing}, reading_{reading} {}

  void gather(const BlockRoles& roles) {
    for (std::size_t k = 0; k < drawing_.blocks.size(); ++k) {
      const dxf::Block& block = drawing_.blocks[k];
      if (is_anonymous(block.name)) continue;
      if (roles.of[k] == BlockRole::kPart) {
        note(block, "is inserted in other blocks and read as a part of them");
      } else if (roles.of[k] == BlockRole::kCollection) {
        note(block, "only collects the pieces that it inserts");
      } else {
        PatternBlock read = read_pattern_block(block, reading_);
        if (read.boundary.empty())
          note(block, "has no boundary; left out");
        else
          pieces_.push_back(std::move(read));
      }
    }
  }

  std::vector<PatternBlock> take() { return std::move(pieces_); }

 private:
  void note(const dxf::Block& block, const std::string& what) {
    const std::string name = json::shortened(Json(decoded(block.name, reading_.encoding)));
    reading_.notes.push_back(note_at(block.line, "block " + name + " " + what));
  }

  const dxf::DxfDrawing& drawing_;
  BlockReading& reading_;
  std::vector<PatternBlock> pieces_;
};

// Lines on the boundary layer that no block contains, in a file with blocks.
void note_boundaries_outside(const dxf::DxfDrawing& drawing, std::vector<Note>& notes) {
  const auto bounds = [](const dxf::Entity& entity) { return draws_boundary(entity); };
  const auto first = std::find_if(drawing.entities.begin(), drawing.entities.end(), bounds);
  if (first == drawing.entities.end()) return;
  const auto count = std::count_if(first, drawing.entities.end(), bounds);
  notes.push_back(note_at(first->line, std::to_string(count) + " lines on layer 1 outside of blocks are not read"));
}

}  // namespace

Result<PatternBlocks> read_pattern_blocks(const dxf::DxfDrawing& drawing, double millimetre, BlockReading& reading) {
  dxf::strokes::Blocks inserted{drawing};
  BlockRoles roles = roles_of(drawing, inserted);
  reading.blocks = &inserted;
  Gatherer gatherer{drawing, reading};
  gatherer.gather(roles);
  PatternBlocks all{gatherer.take(), std::move(roles.inserts), false};
  if (all.pieces.empty()) {
    all = {read_loose_pieces(drawing, millimetre, reading), {}, true};
    if (!all.pieces.empty()) {
      reading.notes.push_back(note_at(all.pieces.front().boundary.front().line,
                                      "no block draws a piece: every outermost closed line on layer 1 is one"));
    }
  } else {
    note_boundaries_outside(drawing, reading.notes);
  }
  reading.blocks = nullptr;
  if (inserted.error()) return *inserted.error();
  if (const auto error = reading.flattening.error()) return *error;
  return all;
}

}  // namespace selvage::protocol::trade::aama::blocks
