// Reproducible random numbers.  They come either from a seed, and are then the same on every platform, or from a
// fuzzer's bytes, so that the fuzzer controls them: each number consumes as many bytes as it needs, and a default seed
// supplies the rest when the bytes are used up.
#pragma once

#include <cstdint>
#include <random>
#include <span>

#include "core/geometry/orientation.h"

namespace selvage::test {

// Sanitised builds run about thirty times slower, so properties are tested with fewer trials there.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int kSlowdown = 20;
#else
inline constexpr int kSlowdown = 1;
#endif

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_{seed} {}
  // REQUIRES: `bytes` outlives this object.
  explicit Random(std::span<const std::uint8_t> bytes) : bytes_{bytes} {}

  // A number in [low, high], both ends included.
  [[nodiscard]] Coord between(Coord low, Coord high) {
    const auto span = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<Coord>(draw(span));
  }
  [[nodiscard]] std::size_t below(std::size_t count) { return static_cast<std::size_t>(draw(count)); }
  [[nodiscard]] bool chance(int percent) { return between(1, 100) <= percent; }
  // A number in [0, 1).
  [[nodiscard]] double part() {
    if (!bytes_.empty()) return static_cast<double>(draw(std::uint64_t{1} << 16)) * 0x1p-16;
    return static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  [[nodiscard]] Vec point(Coord low, Coord high) {
    const Coord x = between(low, high);
    return {x, between(low, high)};
  }
  [[nodiscard]] Symmetry symmetry() {
    const bool flip = chance(50);
    return {flip, static_cast<int>(between(0, 3))};
  }

 private:
  std::uint64_t draw(std::uint64_t count) {
    if (bytes_.empty()) return engine_() % count;
    std::uint64_t number = 0;
    for (std::uint64_t most = count - 1; most > 0 && !bytes_.empty(); most >>= 8) {
      number = number << 8 | bytes_.front();
      bytes_ = bytes_.subspan(1);
    }
    return number % count;
  }

  std::mt19937_64 engine_;
  std::span<const std::uint8_t> bytes_;
};

}  // namespace selvage::test
