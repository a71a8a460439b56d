// Which blocks of a pattern file are pieces, and how they are inserted.
//
// By the standard every block is a piece, and ENTITIES inserts it.  Some writers build a piece of several blocks, or
// collect all pieces of a style in one block.  A block that has neither an outline nor a Piece Name of its own and
// inserts pieces only collects them; any other block is a piece with all that it inserts, and a block that is inserted
// only in a piece is a part of it.
#pragma once

#include <string>
#include <vector>

#include "protocol/trade/dxf/drawing.h"
#include "protocol/trade/dxf/strokes/insertion.h"

namespace selvage::protocol::trade::aama::blocks {

enum class BlockRole { kPiece, kPart, kCollection };

// An INSERT of a piece: one of ENTITIES, or of a collection that they insert.
struct PieceInsert {
  const dxf::Block* block{};          // null: it is not in the file
  dxf::strokes::Insertion insertion;  // in the file's unit; of the first copy, if it is an array
  std::string_view name;              // of the block, in the file's encoding
  std::size_t line{};
};

struct BlockRoles {
  std::vector<BlockRole> of;  // by the positions of the drawing's blocks
  std::vector<PieceInsert> inserts;
};

// Check the error of `blocks` afterwards.
[[nodiscard]] BlockRoles roles_of(const dxf::DxfDrawing& drawing, dxf::strokes::Blocks& blocks);

// Whether the entity draws a line on the boundary layer; `inherited`: the layer of the INSERT that it is in, if any.
[[nodiscard]] bool draws_boundary(const dxf::Entity& entity, std::string_view inherited = {});

}  // namespace selvage::protocol::trade::aama::blocks
