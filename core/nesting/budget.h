// How much work a search may do, counted in moves, and how much of it is done.
//
// Exploration and compression alternate: a first epoch of each, then one of twice the length, and so on.  So what a
// search does next does not depend on its budget, and more moves never give a longer marker.  A caller that limits time
// instead reports how much of it is used up; then there is one exploration and one compression.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <utility>

namespace selvage::nesting {

class Budget {
 public:
  // `elapsed`: the part of the caller's limit that is used up, 0..1; empty when only moves are limited.
  Budget(std::uint64_t moves, std::function<double()> elapsed, std::stop_token stop, double explored,
         std::uint64_t first_epoch)
      : most_{moves}, elapsed_{std::move(elapsed)}, stop_{std::move(stop)}, explored_{explored}, epoch_{first_epoch} {}

  [[nodiscard]] bool timed() const { return static_cast<bool>(elapsed_); }
  // True when the search is to end however many moves it has made.
  [[nodiscard]] bool out_of_time() const { return stop_.stop_requested() || (elapsed_ && elapsed_() >= 1); }
  [[nodiscard]] bool over(std::uint64_t moves) const { return moves >= most_ || out_of_time(); }
  // The part of it that is used up; 1 and more when it is over.
  [[nodiscard]] double used(std::uint64_t moves) const {
    const double of_moves = most_ == 0 ? 1 : static_cast<double>(moves) / static_cast<double>(most_);
    return elapsed_ ? std::max(of_moves, elapsed_()) : of_moves;
  }
  // True while the search is to explore, false while it is to compress.
  [[nodiscard]] bool exploring(std::uint64_t moves) const { return done_of_epoch(moves) < explored_; }
  // How much of the present compression is done, 0..1.
  [[nodiscard]] double compressed(std::uint64_t moves) const {
    return (done_of_epoch(moves) - explored_) / (1 - explored_);
  }

 private:
  [[nodiscard]] double done_of_epoch(std::uint64_t moves) const {
    if (elapsed_) return elapsed_();
    std::uint64_t begin = 0;
    std::uint64_t length = epoch_;
    while (moves >= begin + length) {
      begin += length;
      length *= 2;
    }
    return static_cast<double>(moves - begin) / static_cast<double>(length);
  }

  std::uint64_t most_;
  std::function<double()> elapsed_;
  std::stop_token stop_;
  double explored_;
  std::uint64_t epoch_;
};

}  // namespace selvage::nesting
