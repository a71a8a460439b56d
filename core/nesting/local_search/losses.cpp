#include "core/nesting/local_search/losses.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace selvage::nesting::local_search {

// Far more than any layout needs; sums of many weighted depths remain finite.  Pairs that nothing can part, such as a
// locked piece and one with no other place, would otherwise outgrow a float.
constexpr float kMostWeight = 1e20F;

Losses::Losses(const layout::PieceSet& set, depth::DepthMaps& maps, const SearchTuning& tuning)
    : set_{&set},
      maps_{&maps},
      size_{set.size()},
      charge_{static_cast<float>(tuning.charge)},
      tolerance_{static_cast<float>(tuning.tolerance)},
      growth_{tuning.weight_growth},
      extra_growth_{tuning.extra_growth},
      decay_{tuning.weight_decay},
      losses_(size_ * size_),
      weights_(size_ * size_, 1),
      of_piece_(size_) {
  double mean = 0;
  for (std::size_t i = 0; i < size_; ++i) mean += std::sqrt(set.kind(i).hull_area);
  mean /= static_cast<double>(std::max<std::size_t>(1, size_));
  for (const layout::Kind& kind : set.kinds) {
    importance_.push_back(static_cast<float>(std::sqrt(std::sqrt(kind.hull_area) / mean)));
  }
}

void Losses::reset(const layout::Layout& layout) {
  std::fill(weights_.begin(), weights_.end(), 1.0F);
  raised_.clear();
  measure(layout);
}

void Losses::measure(const layout::Layout& layout) {
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = i + 1; j < size_; ++j) {
      losses_[i * size_ + j] = losses_[j * size_ + i] = pair_loss(layout, i, j);
    }
  }
  for (std::size_t i = 0; i < size_; ++i) {
    const float* row = losses_.data() + i * size_;
    of_piece_[i] = std::accumulate(row, row + size_, 0.0);
  }
}

void Losses::measure(const layout::Layout& layout, std::size_t piece) {
  float* own = losses_.data() + piece * size_;
  for (std::size_t j = 0; j < size_; ++j) {
    if (j == piece) continue;
    const float loss = pair_loss(layout, std::min(piece, j), std::max(piece, j));
    if (loss == own[j]) continue;
    own[j] = losses_[j * size_ + piece] = loss;
    // Summed anew, so that the sum of no losses is exactly 0.
    const float* row = losses_.data() + j * size_;
    of_piece_[j] = std::accumulate(row, row + size_, 0.0);
  }
  of_piece_[piece] = std::accumulate(own, own + size_, 0.0);
}

float Losses::pair_loss(const layout::Layout& layout, std::size_t first, std::size_t second) {
  if (set_->fixed[first] && set_->fixed[second]) return 0;
  const layout::Place& p = layout.places[first];
  const layout::Place& q = layout.places[second];
  const layout::Turned& one = set_->kind(first).turned[p.turn];
  const layout::Turned& other = set_->kind(second).turned[q.turn];
  if (!may_meet(*set_, one, p, other, q, maps_->scale().pixel)) return 0;  // most pairs never need a map
  const depth::MapView view = maps_->view(one, other);
  const float depth = view.depth(static_cast<float>(q.x - p.x), static_cast<float>(q.y - p.y));
  return importance(first, second) * charged(depth);
}

void Losses::reweigh() {
  float largest = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    if (of_piece_[i] <= 0) continue;
    for (std::size_t j = i + 1; j < size_; ++j) {
      const float loss = losses_[i * size_ + j];
      largest = std::max(largest, loss);
      if (loss > 0 && weights_[i * size_ + j] == 1) raised_.push_back(i * size_ + j);
    }
  }
  if (largest <= 0) return;
  std::erase_if(raised_, [&](std::size_t pair) {
    const float loss = losses_[pair];
    const double factor = loss == 0 ? decay_ : growth_ + extra_growth_ * loss / largest;
    const float weight = std::clamp(static_cast<float>(weights_[pair] * factor), 1.0F, kMostWeight);
    weights_[pair] = weights_[pair % size_ * size_ + pair / size_] = weight;
    return weight == 1;
  });
}

double Losses::total() const {
  return std::accumulate(of_piece_.begin(), of_piece_.end(), 0.0) / 2;
}

}  // namespace selvage::nesting::local_search
