// Random choices of a search.  The same seed gives the same choices on every platform, unlike the distributions of the
// standard library.
#pragma once

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace selvage::nesting::layout {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_{seed} {}

  [[nodiscard]] double unit();                          // 0 <= u < 1
  [[nodiscard]] std::size_t below(std::size_t number);  // 0, ..., number - 1; REQUIRES: number > 0
  template <class Value>
  void shuffle(std::vector<Value>& values) {
    for (std::size_t k = values.size(); k > 1; --k) std::swap(values[k - 1], values[below(k)]);
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace selvage::nesting::layout
