// The rounds of a separation (separate.h) on one set of pieces: a linear program each, leaps of pieces that programs
// cannot free, and a repair of what rounding leaves.
// Units: lattice units.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <stop_token>
#include <vector>

#include "core/motion/separation/leap.h"
#include "core/motion/separation/separate.h"
#include "core/motion/separation/separation_step.h"

namespace selvage::motion::separation {

// Moves pieces that lie outside their rooms on a strip of this length to its edge: any separation must move them at
// least as far.  Match sets come into phase.
void move_into_strip(scene::Scene& scene, Coord length);

struct Ending {
  scene::StopReason reason{};
  bool apart{};
};

class Rounds {
 public:
  // `home`: where the pieces were at the start.  Up to the length `free` there is no price, and the pieces have to end
  // within `allowed`.  The referenced values must outlive this.
  Rounds(scene::Scene& scene, const std::vector<Vec>& home, Coord free, Coord allowed,
         const SeparationSettings& settings, const scene::Run& run);

  // Leaves the pieces separated, or where they overlap least; adds its rounds and programs to `total`.
  Ending run(Separation& total);

  // The overlapping piece that blocks separation most: the one whose rows have the largest dual values [Li94 10], among
  // small pieces if there are any.  A fixed piece only if there is no other.  REQUIRES: not apart.
  [[nodiscard]] std::uint32_t most_blocking(Separation& total) const;
  // How many pieces must be removed at least: as many as there are overlaps no two of which share a piece, found
  // greedily.  At least 1.  REQUIRES: not apart.
  [[nodiscard]] std::size_t least_to_remove() const;

 private:
  struct Best {
    std::vector<Vec> positions;
    double remaining{};
  };

  scene::StopReason iterate(Separation& total);
  // After a leap a piece aims at where it landed.  Once all pieces are apart, they move as close as possible to where
  // they were at the start.
  void return_towards_start(Separation& total);
  [[nodiscard]] double distance_to_start(const std::vector<Vec>& from) const;
  // Returns to the best positions found, without the excess length; no worse than the start.  Even when stopped.
  void restore_best(const Best& start);

  // Whether so much is left after this many rounds that separation gives up (SeparationTuning::hopeless).
  [[nodiscard]] bool is_hopeless(int rounds) const;
  [[nodiscard]] bool is_small(std::uint32_t piece) const;
  [[nodiscard]] const SeparationTuning& tuning() const { return settings_.tuning; }
  [[nodiscard]] bool has_many() const { return scene_.pieces.size() > tuning().many; }
  // Whether this round, 0 being the first, moves only what overlaps.
  [[nodiscard]] bool is_local(int round) const { return round > 0 && has_many(); }
  // What is wrong besides overlaps, added up: by how much the marker and its shades are too long, match sets are off
  // their phase, and pieces of match sets leave their rooms, as coming into phase may make them.
  [[nodiscard]] Coord excess() const;
  [[nodiscard]] bool apart() const { return known_ && overlapping_.empty() && excess() == 0; }
  // The overlap and excess length that remain.
  [[nodiscard]] double remaining() const { return depth_ + static_cast<double>(excess()); }
  // Overlaps up to this depth come from rounding, and a repair removes them.
  [[nodiscard]] double shallow() const;
  // Whether the overlap keeps pieces from being separated: shallow ones do only where there are no others.
  [[nodiscard]] bool counts(const OverlappingPair& overlapping) const;
  [[nodiscard]] bool only_rounding_left() const { return deepest_ <= shallow() && excess() == 0; }

  // The overlaps are unknown afterwards.
  void place(std::vector<Vec> positions);
  // Finds all overlapping pairs, exactly.  False when cancelled: then only some of them were found.
  bool find_overlaps() { return measure_overlaps(run_.stop); }
  // The same, cancelled by this token.
  bool measure_overlaps(const std::stop_token& stop);
  // A repair has rows that cannot be violated, so it may part pairs that prices alone leave overlapping.  False, with
  // the pieces where they were, when there is no room within the allowed length, or when cancelled.
  bool repaired();
  // From every pair that still overlaps, the piece with the cheaper leap leaps; so does every piece that lies beyond
  // the allowed length.  False when cancelled, like find_overlaps.
  bool leap(int times);
  void leap_one(std::initializer_list<std::uint32_t> candidates, double reach);

  [[nodiscard]] SeparationStepSettings program_settings() const;
  [[nodiscard]] std::uint32_t rightmost() const;

  scene::Scene& scene_;
  const std::vector<Vec>& home_;
  std::vector<Vec> aim_;  // where each piece is wanted: at its start, or where it leapt to
  Coord free_, allowed_;
  const SeparationSettings& settings_;
  const scene::Run& run_;
  std::vector<OverlappingPair> overlapping_;
  bool known_{};  // `overlapping_` lists all overlaps of the pieces where they are now
  OverlapPrices prices_{settings_.tuning.overlap_price, {}};
  double depth_{}, deepest_{};
  Best best_;
};

}  // namespace selvage::motion::separation
