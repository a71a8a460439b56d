// How finely the curves of one file are flattened, and how many chords that may take.
//
// A circle of a few bytes can be so large that thousands of chords replace it.  The chords of a file are limited by its
// size, so that the memory which a reader needs is limited, too: 64 MB, and 64 bytes for each byte of the file.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include "core/base/error.h"

namespace selvage::protocol::trade {

class Flattening {
 public:
  // `tolerance`: how far a chord may lie from its curve, in units of the drawing, greater than 0; `bytes`: of the file.
  Flattening(double tolerance, std::size_t bytes)
      : tolerance_{tolerance}, most_{kFreeChords + bytes / 8}, left_{most_} {}

  [[nodiscard]] double tolerance() const { return tolerance_; }

  // While it exists, curves are flattened that are then enlarged by the scale, so that the tolerance is that of the
  // enlarged curve.  A scale that is not greater than 0 changes nothing.
  class Enlarged {
   public:
    Enlarged(Flattening& flattening, double scale) : flattening_{flattening}, before_{flattening.tolerance_} {
      constexpr double kLeast = 1e-6, kMost = 1e6;
      if (scale > 0) flattening.tolerance_ /= std::clamp(scale, kLeast, kMost);
    }
    ~Enlarged() { flattening_.tolerance_ = before_; }
    Enlarged(const Enlarged&) = delete;
    Enlarged& operator=(const Enlarged&) = delete;

   private:
    Flattening& flattening_;
    double before_;
  };

  // Takes chords from those that are left.  When there are too few, no later curve gets any, either.
  [[nodiscard]] bool take(std::size_t chords) {
    exhausted_ = exhausted_ || chords > left_;
    if (exhausted_) return false;
    left_ -= chords;
    return true;
  }
  [[nodiscard]] bool exhausted() const { return exhausted_; }

  // kOutOfRange when it is exhausted: some curves of the file were not drawn.
  [[nodiscard]] std::optional<Error> error() const {
    if (!exhausted_) return std::nullopt;
    return Error{ErrorCode::kOutOfRange,
                 "the curves of this file need more than " + std::to_string(most_) +
                     " chords; a file of its size may have no more.  Are the unit and the tolerance right?",
                 ""};
  }

 private:
  static constexpr std::size_t kFreeChords = 100'000;  // each takes up to 500 bytes in all that is made of it

  double tolerance_;
  std::size_t most_, left_;
  bool exhausted_{};
};

}  // namespace selvage::protocol::trade
