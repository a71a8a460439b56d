// How INSERTs place blocks: scaled, turned, mirrored and moved, in arrays, and block within block.
//
// A few blocks that insert one another can ask for billions of entities, so the depth and the number of entities are
// bounded.  Units: those of the file.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "protocol/trade/dxf/drawing.h"
#include "protocol/trade/loops.h"

namespace selvage::protocol::trade::dxf::strokes {

inline constexpr int kDeepestBlocks = 16;  // an INSERT within this many blocks is refused

// The affine map of an INSERT, or of several within one another.
struct Insertion {
  double xx{1}, xy{}, yx{}, yy{1};
  document::Spot at{};

  [[nodiscard]] document::Spot apply(document::Spot p) const {
    return {xx * p.x + xy * p.y + at.x, yx * p.x + yy * p.y + at.y};
  }
  void apply(Run& run) const;
  // The angle of a direction after the map; degrees.
  [[nodiscard]] double apply_to_angle(double degrees) const;
  // First `inner`, then this one.
  [[nodiscard]] Insertion after(const Insertion& inner) const;

  [[nodiscard]] bool mirrors() const { return xx * yy - xy * yx < 0; }
  // By how much it enlarges lengths: exactly, if it enlarges all of them alike, and in the mean otherwise.
  [[nodiscard]] double scale() const;
  [[nodiscard]] bool scales_evenly() const;
};

// An entity that is seen from behind, with the extrusion direction 0, 0, -1, has the coordinate -x for x.
[[nodiscard]] bool from_behind(const Entity& entity);
inline constexpr Insertion kSeenFromBehind{-1, 0, 0, 1, {}};

// The layer on which an entity of an inserted block lies: what a block has on layer 0 lies on the layer of its INSERT.
// `of_insert`: that layer; empty for an entity that is in no inserted block.
[[nodiscard]] inline std::string_view layer_of(const Entity& entity, std::string_view of_insert) {
  return entity.layer == "0" && !of_insert.empty() ? of_insert : entity.layer;
}

// The copy in this column and row of an INSERT, which may be an array.
[[nodiscard]] Insertion insertion_of(const Entity& insert, const Block& block, int column, int row);

// The blocks of a drawing by their names, in which capitals do not count, and how many entities may still be inserted.
class Blocks {
 public:
  explicit Blocks(const DxfDrawing& drawing);  // REQUIRES: the drawing outlives the blocks

  // The block that an INSERT inserts; null when it is not in the file.
  [[nodiscard]] const Block* of(const Entity& insert) const;

  // Calls `place(block, insertion)` for each copy that the INSERT makes; `outer` is what the blocks around it do, and
  // `depth` their number.  Afterwards error() may say that it was not called for all of them.
  template <class Place>
  void insert(const Entity& insert, const Insertion& outer, int depth, Place place) {
    const Block* const block = of(insert);
    if (!block) return;
    const int columns = steps(insert, 70), rows = steps(insert, 71);
    for (int column = 0; column < columns && !error_; ++column) {
      for (int row = 0; row < rows && !error_; ++row) {
        const Insertion insertion = outer.after(insertion_of(insert, *block, column, row));
        if (!take(block->entities.size() + 1, insert, depth) || !reaches(insertion, insert)) return;
        place(*block, insertion);
      }
    }
  }
  // Takes entities or points from those that may still be inserted.  Returns whether there are enough.
  bool take(std::size_t count, const Entity& insert, int depth);

  // kOutOfRange, with the line of the INSERT, after too many entities or too large a scale.
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 private:
  bool reaches(const Insertion& insertion, const Entity& insert);
  [[nodiscard]] static int steps(const Entity& insert, int code);

  std::map<std::string_view, const Block*> by_name_;
  std::map<std::string, const Block*> by_capitals_;
  std::size_t inserted_{};
  std::optional<Error> error_;
};

}  // namespace selvage::protocol::trade::dxf::strokes
