// Columns: pieces that lie on top of each other across the strip.  Where they have become taller than the strip is
// wide, no translation parts them: this is why most of the failing substitutions fail
// (docs/measurements/searches/remaking.md).
//
// Outlines are sampled along x.  A piece must lie above those that it lies above now by as much as their outlines
// demand where they share some x; the longest chain of such demands is a column.  Pieces that could pass each other are
// counted, too, so a column may fit though its chain is longer than the strip is wide: this is a prediction, not a
// proof.
// Units: lattice units.
#pragma once

#include <cstdint>
#include <vector>

#include "core/marker/marker.h"

namespace selvage::remake::substitution {

// How columns are sampled.
struct ColumnSampling {
  double cell{};  // along x
  double slip{};  // pieces that share less of x may pass each other
};

class Columns {
 public:
  Columns(const Strip& strip, Coord spacing, ColumnSampling sampling)
      : strip_{strip}, spacing_{spacing}, sampling_{sampling} {}

  // Adds a piece, or replaces one, by its outline where it lies.
  void set(std::size_t piece, const Polygon& placed);

  // How far chains of pieces reach beyond the strip.
  struct Excess {
    double total{};                    // summed over the pieces that end beyond it
    std::vector<std::size_t> longest;  // the pieces of the longest chain that does, from bottom to top; may be empty
  };
  [[nodiscard]] Excess excess() const;

 private:
  struct Profile {
    std::int64_t first{};           // the first sample's number
    std::vector<double> low, high;  // by sample: the outline's least and greatest y
    double lowest{}, highest{};     // of the outline
  };

  // How much higher the upper piece must lie at least than the lower one does; minus infinity when it does not lie
  // above it.
  [[nodiscard]] double demand(const Profile& lower, const Profile& upper) const;
  // Notes a demand of -infinity as well, which ends what was demanded before.
  void set_demand(std::size_t lower, std::size_t upper, double demand);

  Strip strip_;
  Coord spacing_;
  ColumnSampling sampling_;
  struct Demand {
    std::size_t lower{};
    double by{};
  };

  std::vector<Profile> profiles_;
  std::vector<std::vector<Demand>> demands_;  // by the upper piece: of those that it lies above, by the lower piece
};

}  // namespace selvage::remake::substitution
