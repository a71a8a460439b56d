// Chance that repeats: the same numbers from the same seed, on every machine.
#pragma once

#include <cstdint>
#include <random>

#include "core/geometry/orientation.h"

namespace selvage::test {

// Sanitised builds take some thirty times as long: laws are tried less often there.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int kSlowdown = 20;
#else
inline constexpr int kSlowdown = 1;
#endif

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_{seed} {}

  // Both ends included.
  [[nodiscard]] Coord between(Coord low, Coord high) {
    const auto span = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<Coord>(engine_() % span);
  }
  [[nodiscard]] std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  [[nodiscard]] bool chance(int percent) { return between(1, 100) <= percent; }
  // In [0, 1).
  [[nodiscard]] double part() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  [[nodiscard]] Vec point(Coord low, Coord high) {
    const Coord x = between(low, high);
    return {x, between(low, high)};
  }
  [[nodiscard]] Symmetry symmetry() {
    const bool flip = chance(50);
    return {flip, static_cast<int>(between(0, 3))};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace selvage::test
