// The part of a nesting's budget that one of its batches has: what is left of the whole, divided by the batches that
// are left; but never less than it takes to find a layout that is better than the one the batch starts from.  Where the
// whole does not suffice for all batches, the last ones keep the layouts that they start from.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>

namespace selvage::nesting::batches {

class BatchShare {
 public:
  // `moves`: what is left of the whole budget; `elapsed` as in NestSettings, of the whole.
  // REQUIRES: left > 0.  The function outlives this.
  BatchShare(std::uint64_t moves, const std::function<double()>& elapsed, std::size_t pieces, std::size_t left)
      : moves_{moves == 0 ? 0 : std::max(kLeastMoves * pieces, moves / left)}, elapsed_{elapsed} {
    if (!elapsed_) return;
    begin_ = elapsed_();
    end_ = begin_ + (1 - begin_) / static_cast<double>(left);
  }
  BatchShare(const BatchShare&) = delete;
  BatchShare& operator=(const BatchShare&) = delete;

  [[nodiscard]] std::uint64_t moves() const { return moves_; }
  void found_better() { better_ = true; }
  // The part of the share that is used up; 1 when all of the whole is.
  [[nodiscard]] double used() const {
    const double now = elapsed_();
    if (now >= 1) return 1;
    const double used = (now - begin_) / (end_ - begin_);
    return better_ ? used : std::min(used, kUntilBetter);
  }

 private:
  static constexpr std::uint64_t kLeastMoves = 4;  // for each piece: the first puts it down, the others separate it
  static constexpr double kUntilBetter = 0.5;      // a search that is not better yet has used no more than this

  std::uint64_t moves_;
  const std::function<double()>& elapsed_;
  double begin_{}, end_{};
  std::atomic<bool> better_{};
};

}  // namespace selvage::nesting::batches
