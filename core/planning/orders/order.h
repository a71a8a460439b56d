// What is to be cut, on which cloth, within which limits and at which cost.
//
// A marker holds a ratio of bundles; a lay is a marker with plies of one or several colours under it.  Of each colour
// and size, the lays together cut   sum over lays of plies[colour] * ratio[size]   garments [Li94 5.3.4].
//
// Cloth comes from rolls and from remnants.  There are as many rolls as needed.  Where one ends within a ply, the ply
// is spliced: the next roll begins a little before the end, so that no piece is cut in two.  The loss in these overlaps
// is spread evenly over the cloth from rolls.  A remnant is a length of cloth left over from an earlier order.  Whole
// plies of its colour are cut from it, and they are never spliced. Units: millimetres and square millimetres; rates per
// metre, in the caller's currency.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace selvage::planning::orders {

// The total area and perimeter of the pieces of one garment of this size.
struct Size {
  std::string name;
  double area{}, perimeter{};
};

struct Order {
  std::vector<Size> sizes;
  std::vector<std::string> colours;
  std::vector<std::vector<int>> garments;  // by colour, by size
};

// One way: every ply lies face up.  Face to face: the cloth is folded back at the end of each ply, so that plies come
// in pairs, of which the second cuts mirrored pieces.
enum class Spread { kOneWay, kFaceToFace };

// A length of cloth left over from an earlier order.
struct Remnant {
  std::size_t colour{};
  double length{};
  friend bool operator==(const Remnant&, const Remnant&) = default;
};

struct Cloth {
  double width{};
  Spread spread{Spread::kOneWay};
  double end_loss{40};      // of every ply, at both of its ends together
  double roll_length{};     // 0: rolls are endless; else at least the table and at least two splices
  double splice_loss{500};  // the overlap of two rolls in a ply
  std::vector<Remnant> remnants;
};

struct Limits {
  int plies{60};               // maximum number in a lay
  double table{12'000};        // length of the table: the longest ply, end loss included
  int bundles{6};              // maximum number in a marker
  double over{0.03}, under{};  // how many more or fewer garments may be cut, as a fraction of those ordered
};

struct Costs {
  double metre{5};         // of cloth from rolls
  double remnant_metre{};  // of cloth from remnants
  double lay{10};          // of setting up a lay
  double ply{0.2};         // of spreading a ply
  double marker{10};       // of making a marker
  double cut_metre{0.05};  // of cutting a lay, per metre of the outlines in its marker
};

struct Problem {
  Order order;
  Cloth cloth;
  Limits limits;
  Costs costs;

  // The number of plies in a unit, and the maximum number of units in a lay.
  [[nodiscard]] int plies_of_unit() const { return cloth.spread == Spread::kFaceToFace ? 2 : 1; }
  [[nodiscard]] int units_of_lay() const { return limits.plies / plies_of_unit(); }
  // The length of cloth in the plies of a unit, including their end losses.
  [[nodiscard]] double unit_length(double marker) const { return plies_of_unit() * (marker + cloth.end_loss); }
  // The cost of a millimetre of a ply from rolls, splices included, and how much less it is from remnants (at least 0).
  [[nodiscard]] double roll_rate() const;
  [[nodiscard]] double remnant_saving() const;
  // The cost of cutting a millimetre.
  [[nodiscard]] double cut_rate() const;
  // The fraction by which splices increase the cloth from rolls: one splice for every length that a roll adds.
  [[nodiscard]] double splice_part() const;
  // The minimum and maximum number of garments that may be cut.  When plies come in pairs, so do garments; one more
  // than the minimum is then always allowed.
  [[nodiscard]] int least(std::size_t colour, std::size_t size) const;
  [[nodiscard]] int most(std::size_t colour, std::size_t size) const;
};

inline constexpr std::size_t kMostSizes = 50, kMostColours = 50;
inline constexpr int kMostGarments = 1'000'000;  // of a colour and size
inline constexpr int kMostPlies = 1'000, kMostBundles = 50;
inline constexpr std::size_t kMostRemnants = 100;
inline constexpr std::int64_t kMostLays = 100'000;  // of a plan

// What is wrong with a number of lays.  `field` is "/limits/plies".  Errors: kOutOfRange when it exceeds kMostLays.
[[nodiscard]] std::optional<Error> too_many_lays(std::int64_t lays);

// What is wrong with the problem: no size, colour or garment, a number that is not finite, negative or beyond what is
// allowed, or more lays than allowed even if all of them are full.  `field` points into {"quantities": {colour: {size:
// garments}}, "limits", "costs", "cloth"}. Errors: kOutOfRange, kMissingField.
[[nodiscard]] std::optional<Error> mistake_in(const Problem& problem);

}  // namespace selvage::planning::orders
