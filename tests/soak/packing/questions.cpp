#include "tests/soak/packing/questions.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "tests/core/packing/polyominoes.h"
#include "tests/judge/judge.h"
#include "tests/laws/random_marker.h"

namespace selvage::test {
namespace {

using packing::Verdict;

constexpr std::size_t kMostCutOut = 7;
constexpr std::uint64_t kMostNodes = 200'000;
constexpr Coord kBoxWidth = 4;  // squares

Judged judged(const Marker& marker, const std::vector<PieceId>& pieces, const Box& room, bool fits, SumCache& sums) {
  packing::ContainSettings settings;
  settings.limits.nodes = kMostNodes;
  const auto answer = packing::contain(marker, pieces, room, settings, {sums});
  Judged result{answer.verdict, answer.work.nodes};
  if (answer.verdict == Verdict::kUndecided) result.fault = "undecided";
  if (answer.verdict == Verdict::kImpossible && fits) result.fault = "called impossible, but fits";
  if (answer.verdict != Verdict::kFound) return result;
  Judge judge;
  result.fault = fits ? judge.fault_of(answer.marker) : "found, but does not fit";
  if (result.fault.empty() && judge.length_of(answer.marker) > room.high.x) result.fault = "beyond the room";
  return result;
}

// Up to kMostCutOut of the movable pieces, in random order.
std::vector<PieceId> some_of(Random& random, const Marker& marker) {
  std::vector<PieceId> pieces;
  for (std::uint32_t k = 0; k < marker.pieces.size(); ++k) {
    if (!marker.pieces[k].locked) pieces.push_back({k});
  }
  for (std::size_t k = pieces.size(); k > 1; --k) std::swap(pieces[k - 1], pieces[random.below(k)]);
  pieces.resize(std::min(pieces.size(), 1 + random.below(kMostCutOut)));
  return pieces;
}

}  // namespace

Judged judged_cut_out(Random& random, SumCache& sums) {
  Marker marker = random_marker(random);
  const std::vector<PieceId> pieces = some_of(random, marker);
  const Box room = packing::room_until(marker.strip, length_of(marker));
  for (const PieceId piece : pieces) marker.pieces[piece.value].at = {};
  return judged(marker, pieces, room, true, sums);
}

Judged judged_polyominoes(Random& random, SumCache& sums) {
  std::vector<Squares> polyominoes;
  std::vector<PieceId> pieces;
  Coord area = 0;
  const std::size_t count = 3 + random.below(4);
  while (polyominoes.size() < count) {
    Squares squares = random_squares(random, 1 + random.below(5));
    if (box_of(squares).high.y >= kBoxWidth) continue;
    area += static_cast<Coord>(squares.size());
    pieces.push_back({static_cast<std::uint32_t>(polyominoes.size())});
    polyominoes.push_back(std::move(squares));
  }
  const Coord length = (area + kBoxWidth - 1) / kBoxWidth + static_cast<Coord>(random.below(2));
  const Marker marker = marker_of(polyominoes, kBoxWidth);
  const Box room{{0, 0}, {length * kSquare, kBoxWidth * kSquare}};
  return judged(marker, pieces, room, fit_on_grid(polyominoes, kBoxWidth, length), sums);
}

}  // namespace selvage::test
