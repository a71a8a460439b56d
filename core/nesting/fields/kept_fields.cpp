#include "core/nesting/fields/kept_fields.h"

namespace selvage::nesting::fields {

KeptFields::KeptFields(const layout::PieceSet& set, depth::DepthMaps& maps, std::size_t limit_bytes)
    : set_{&set}, maps_{&maps}, limit_{limit_bytes}, fields_(set.size()), shared_{set, maps} {}

Field& KeptFields::of(std::size_t piece, std::uint32_t turn) {
  if (latest_ != nullptr) bytes_ += latest_->bytes();
  latest_ = nullptr;
  auto& of_piece = fields_[piece];
  if (of_piece.empty()) of_piece.resize(set_->kind(piece).turned.size());
  if (of_piece[turn] != nullptr) return *of_piece[turn];
  if (bytes_ >= limit_) return shared_;
  of_piece[turn] = std::make_unique<Field>(*set_, *maps_);
  latest_ = of_piece[turn].get();
  return *latest_;
}

}  // namespace selvage::nesting::fields
