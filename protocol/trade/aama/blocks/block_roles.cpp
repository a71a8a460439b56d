#include "protocol/trade/aama/blocks/block_roles.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "protocol/trade/aama/blocks/pattern_block.h"
#include "protocol/trade/dxf/text_lines.h"

namespace selvage::protocol::trade::aama::blocks {
namespace {

using dxf::Block;
using dxf::Entity;

bool is_text(const Entity& entity) {
  return entity.type == "TEXT" || entity.type == "MTEXT" || entity.type == "ATTDEF" || entity.type == "ATTRIB";
}

bool states_name(const Entity& entity) {
  if (!is_text(entity)) return false;
  const auto lines = dxf::text_lines(entity, Encoding::kUtf8);
  return std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    const auto pair = key_and_value(line);
    return pair && pair->first == "PIECE NAME";
  });
}

class RoleReader {
 public:
  RoleReader(const dxf::DxfDrawing& drawing, dxf::strokes::Blocks& blocks) : drawing_{drawing}, blocks_{blocks} {}

  BlockRoles read() {
    follow(drawing_.entities, {}, 0);
    std::set<const Block*> pieces, parts;
    for (const PieceInsert& insert : roles_.inserts) pieces.insert(insert.block);
    for (const Block& block : drawing_.blocks) {
      for (const Entity& entity : block.entities) {
        if (entity.type == "INSERT" && !collects(block, 0)) parts.insert(blocks_.of(entity));
      }
    }
    for (const Block& block : drawing_.blocks) {
      const bool part = parts.contains(&block) && !pieces.contains(&block);
      roles_.of.push_back(collects(block, 0) ? BlockRole::kCollection : part ? BlockRole::kPart : BlockRole::kPiece);
    }
    return std::move(roles_);
  }

 private:
  void follow(const std::vector<Entity>& entities, const dxf::strokes::Insertion& outer, int depth) {
    for (const Entity& entity : entities) {
      if (entity.type != "INSERT") continue;
      const Block* const block = blocks_.of(entity);
      const dxf::strokes::Insertion seen =
          dxf::strokes::from_behind(entity) ? outer.after(dxf::strokes::kSeenFromBehind) : outer;
      if (block && collects(*block, 0)) {
        blocks_.insert(entity, seen, depth, [&](const Block& inner, const dxf::strokes::Insertion& insertion) {
          follow(inner.entities, insertion, depth + 1);
        });
      } else {
        const dxf::strokes::Insertion at = block ? seen.after(dxf::strokes::insertion_of(entity, *block, 0, 0)) : seen;
        roles_.inserts.push_back({block, at, entity.text(2), entity.line});
      }
    }
  }

  // Whether the block, or one that it inserts, draws a line on the boundary layer.
  bool has_boundary(const Block& block, std::string_view inherited, int depth) {
    if (depth > dxf::strokes::kDeepestBlocks) return false;
    const auto [known, fresh] = bounded_.emplace(std::pair{&block, inherited}, false);
    if (!fresh) return known->second;
    const bool found = std::any_of(block.entities.begin(), block.entities.end(), [&](const Entity& entity) {
      if (entity.type != "INSERT") return draws_boundary(entity, inherited);
      const Block* const inner = blocks_.of(entity);
      return inner && has_boundary(*inner, dxf::strokes::layer_of(entity, inherited), depth + 1);
    });
    bounded_[{&block, inherited}] = found;
    return found;
  }

  bool has_name(const Block& block) {
    const auto [known, fresh] = named_.emplace(&block, false);
    if (fresh) known->second = std::any_of(block.entities.begin(), block.entities.end(), states_name);
    return known->second;
  }

  bool collects(const Block& block, int depth) {
    if (depth > dxf::strokes::kDeepestBlocks) return false;
    const auto [known, fresh] = collecting_.emplace(&block, false);
    if (!fresh) return known->second;
    if (has_name(block)) return false;
    int bounded = 0;
    bool pieces = false;
    for (const Entity& entity : block.entities) {
      if (draws_boundary(entity)) return false;
      const Block* const inner = entity.type == "INSERT" ? blocks_.of(entity) : nullptr;
      if (!inner || !has_boundary(*inner, entity.layer, 0)) continue;
      pieces = pieces || has_name(*inner) || collects(*inner, depth + 1);
      ++bounded;
    }
    return collecting_[&block] = pieces || bounded > 1;
  }

  const dxf::DxfDrawing& drawing_;
  dxf::strokes::Blocks& blocks_;
  std::map<std::pair<const Block*, std::string_view>, bool> bounded_;
  std::map<const Block*, bool> named_, collecting_;
  BlockRoles roles_;
};

}  // namespace

BlockRoles roles_of(const dxf::DxfDrawing& drawing, dxf::strokes::Blocks& blocks) {
  return RoleReader{drawing, blocks}.read();
}

bool draws_boundary(const dxf::Entity& entity, std::string_view inherited) {
  return whole_number_in(dxf::strokes::layer_of(entity, inherited)) == 1 && !is_text(entity) &&
         entity.type != "POINT" && entity.type != "INSERT";
}

}  // namespace selvage::protocol::trade::aama::blocks
