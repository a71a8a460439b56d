// The fields of all pieces in all orientations, kept from one move to the next, as far as memory allows.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/nesting/fields/field.h"

namespace selvage::nesting::fields {

class KeptFields {
 public:
  // REQUIRES: `set` and `maps` outlive the fields.
  KeptFields(const layout::PieceSet& set, depth::DepthMaps& maps, std::size_t limit_bytes);

  // The field of the piece in that orientation.  When memory is used up, pieces whose fields are not kept yet share
  // one.  The reference is valid until the next call.
  [[nodiscard]] Field& of(std::size_t piece, std::uint32_t turn);

 private:
  const layout::PieceSet* set_;
  depth::DepthMaps* maps_;
  std::size_t limit_, bytes_{};
  std::vector<std::vector<std::unique_ptr<Field>>> fields_;  // by piece and orientation
  Field* latest_{};                                          // a new one, whose size is not in `bytes_` yet
  Field shared_;
};

}  // namespace selvage::nesting::fields
