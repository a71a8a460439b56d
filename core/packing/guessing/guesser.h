// Guesses: layouts that overlap little, found by a guided local search [UYI+09] [GVW25], from which an exact search
// nearby (branching/search.h) often gets a layout.
//
//     every body somewhere at random
//     again and again, in random order:
//       move every body that overlaps to the best of some random positions, improved by coordinate descent
//       raise the weights of the pairs that still overlap
//
// Overlaps are measured by the rings of the problem, in floating point: a guess claims nothing.
// Units: lattice units.
#pragma once

#include <cstdint>
#include <random>
#include <stop_token>
#include <vector>

#include "core/packing/branching/problem.h"
#include "core/packing/guessing/ring_grid.h"

namespace selvage::packing::guessing {

using branching::Problem;

struct Guess {
  std::vector<RealVec> positions;      // of the bodies
  std::vector<std::uint32_t> variant;  // of the bodies; those of one kind are in the order of a search
};

class Guesser {
 public:
  // REQUIRES: every body has a variant.  The problem must outlive this.
  explicit Guesser(const Problem& problem);

  // Begins anew with the bodies as near to these positions as they can be, each in the variant that overlaps least
  // there.
  void begin_at(const std::vector<RealVec>& positions);

  // Iterates until `moves` are made, the last iteration being completed, or until nothing has been gained for a while;
  // then the next call begins anew.  Returns the layout that overlapped least; `moves` is reduced by those made.
  [[nodiscard]] Guess next(std::int64_t& moves, const std::stop_token& stop);

 private:
  struct Placed {
    RealVec at;
    std::uint32_t variant{};
  };
  struct Candidate {
    Placed placed;
    double loss{};
  };
  struct Rings {
    std::uint32_t first{}, end{};  // in rings_
  };

  [[nodiscard]] std::size_t chosen(std::size_t body, std::uint32_t variant) const { return first_[body] + variant; }
  [[nodiscard]] Rings between(std::size_t a, std::size_t b) const { return between_[a * chosen_ + b]; }
  [[nodiscard]] double depth(std::uint32_t ring, RealVec way) const;
  [[nodiscard]] double pair_depth(std::size_t a, std::size_t b, RealVec way) const;
  [[nodiscard]] double loss(std::size_t body, const Placed& placed, double bound) const;
  [[nodiscard]] double part(double low, double high);
  void scatter();
  [[nodiscard]] RealVec nearest(std::size_t body, std::uint32_t variant, RealVec position) const;
  void move(std::size_t body);
  void sample(std::size_t body, const Candidate& now);
  void keep(const Candidate& candidate);
  [[nodiscard]] Candidate descended(std::size_t body, Candidate from);
  // Returns the sum of all overlaps.
  double raise_weights();
  [[nodiscard]] Guess in_order(std::vector<Placed> placed) const;

  const Problem* problem_;
  std::size_t bodies_, chosen_{};
  std::vector<std::size_t> first_;  // by body: the number of its first variant
  std::vector<Rings> between_;      // by two of these numbers, those of the lower body first; the world comes last
  std::vector<const cells::WedgeRing*> rings_;  // of the problem, those of a pair one after another
  std::vector<RealBox> boxes_;                  // by ring: most rings are far from most positions
  std::vector<double> sizes_;                   // by ring
  std::vector<RingGrid> fixed_;                 // by body and variant: the rings of fixed pieces, from the first one on
  std::vector<double> ring_weights_;            // by ring: of fixed pieces
  std::vector<double> pair_weights_;            // by two bodies
  std::vector<Placed> placed_;
  std::vector<Candidate> candidates_;  // of the body that is being moved, the best first
  double least_{};                     // of the sums of overlaps since the start
  int idle_{};                         // iterations since the last gain
  bool fresh_{true};                   // the next guess begins anew
  std::mt19937_64 random_;             // with the default seed: guesses are the same for the same problem
};

}  // namespace selvage::packing::guessing
