// Laws of packing and containment on random markers.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/marker/validity.h"
#include "core/packing/contain.h"
#include "core/packing/pack.h"
#include "protocol/execution/thread_pool.h"
#include "tests/core/packing/polyominoes.h"
#include "tests/laws/random_marker.h"

namespace selvage::packing {
namespace {

constexpr Coord kRounding = 16;  // lattice units by which rounding lengthens a layout at most in these tests

// Up to `most` pieces that may move, in random order.
std::vector<PieceId> some_pieces(test::Random& random, const Marker& marker, std::size_t most) {
  std::vector<PieceId> pieces;
  for (std::uint32_t k = 0; k < marker.pieces.size(); ++k) {
    if (!marker.pieces[k].locked) pieces.push_back({k});
  }
  for (std::size_t k = pieces.size(); k > 1; --k) std::swap(pieces[k - 1], pieces[random.below(k)]);
  pieces.resize(std::min(pieces.size(), 1 + random.below(most)));
  return pieces;
}

Marker with_pieces_at_origin(Marker marker, const std::vector<PieceId>& pieces) {
  for (const PieceId piece : pieces) marker.pieces[piece.value].at = {};
  return marker;
}

// Takes up to `most` pieces out of a random marker and asks for places for them.
void expect_to_find_places(test::Random& random, std::size_t most) {
  const Marker valid = test::random_marker(random);
  const auto pieces = some_pieces(random, valid, most);
  const Box room = room_until(valid.strip, length_of(valid));
  SumCache sums;
  const Containment result = contain(with_pieces_at_origin(valid, pieces), pieces, room, {}, {sums});
  EXPECT_EQ(result.verdict, Verdict::kFound);
  if (result.verdict == Verdict::kFound) {
    EXPECT_TRUE(is_valid(result.marker));
  }
}

TEST(ContainLaws, FindsPlacesForPiecesTakenOutOfAValidMarker) {
  test::Random random{31};
  for (int trial = 0; trial < 150 / test::kSlowdown; ++trial) {
    SCOPED_TRACE(trial);
    expect_to_find_places(random, 5);
  }
}

// The only leaf of this one has its layouts far from its solution.
TEST(ContainLaws, FindsALayoutFarFromTheSolutionOfItsLeaf) {
  test::Random random{8251};
  expect_to_find_places(random, 7);
}

std::vector<test::Squares> random_pieces(test::Random& random, std::size_t count) {
  std::vector<test::Squares> pieces;
  while (pieces.size() < count) {
    auto squares = test::random_squares(random, 1 + random.below(5));
    if (box_of(squares).high.y < 4) pieces.push_back(std::move(squares));
  }
  return pieces;
}

std::vector<PieceId> all_pieces(const Marker& marker) {
  std::vector<PieceId> pieces;
  for (std::uint32_t k = 0; k < marker.pieces.size(); ++k) pieces.push_back({k});
  return pieces;
}

TEST(ContainLaws, MoreRoomNeverMakesItImpossible) {
  test::Random random{53};
  int found = 0;
  for (int trial = 0; trial < 100 / test::kSlowdown + 1; ++trial) {
    const auto polyominoes = random_pieces(random, 3 + random.below(3));
    const Marker marker = test::marker_of(polyominoes, 5);
    const auto verdict_in = [&](Coord length, Coord width) {
      SumCache sums;
      return contain(marker, all_pieces(marker), Box{{0, 0}, {length, width}}, {}, {sums}).verdict;
    };
    const Coord length = random.between(3, 5) * test::kSquare;
    if (verdict_in(length, 4 * test::kSquare) != Verdict::kFound) continue;
    ++found;
    EXPECT_NE(verdict_in(length + random.between(1, test::kSquare), 4 * test::kSquare), Verdict::kImpossible);
    EXPECT_NE(verdict_in(length, 4 * test::kSquare + random.between(1, test::kSquare)), Verdict::kImpossible);
  }
  EXPECT_GT(found, 0);
}

TEST(ContainLaws, ThreadsDoNotMatter) {
  test::Random random{59};
  for (int trial = 0; trial < 20 / test::kSlowdown + 1; ++trial) {
    const Marker marker = test::marker_of(random_pieces(random, 7), 4);
    const Box room{{0, 0}, {random.between(4, 6) * test::kSquare, 4 * test::kSquare}};
    SumCache sums;
    ContainSettings settings;
    settings.limits.nodes = 2000;
    const Containment expected = contain(marker, all_pieces(marker), room, settings, {sums});
    for (const std::size_t threads : {2U, 4U}) {
      const protocol::execution::ThreadPool pool{threads - 1};
      scene::Run run{sums};
      run.executor = &pool;
      const Containment result = contain(marker, all_pieces(marker), room, settings, run);
      EXPECT_EQ(result.verdict, expected.verdict);
      EXPECT_EQ(result.marker, expected.marker);
      EXPECT_EQ(result.work.nodes, expected.work.nodes);
      EXPECT_EQ(result.work.skipped, expected.work.skipped);
    }
  }
}

Coord shortest(const Marker& marker) {
  SumCache sums;
  const Packing packing = pack(marker, {}, {sums});
  EXPECT_TRUE(packing.proved);
  EXPECT_TRUE(is_valid(packing.marker));
  return packing.length_after;
}

TEST(PackLaws, AddingAPieceNeverShortens) {
  test::Random random{37};
  for (int trial = 0; trial < 25 / test::kSlowdown + 1; ++trial) {
    const auto pieces = random_pieces(random, 5);
    const auto fewer = std::vector<test::Squares>{pieces.begin(), pieces.end() - 1};
    EXPECT_LE(shortest(test::marker_of(fewer, 4)), shortest(test::marker_of(pieces, 4)) + kRounding);
  }
}

TEST(PackLaws, AgreesWithExhaustiveSearchOnAGrid) {
  test::Random random{41};
  for (int trial = 0; trial < 25 / test::kSlowdown + 1; ++trial) {
    const auto pieces = random_pieces(random, 4);
    Coord length = 1;
    while (!test::fit_on_grid(pieces, 4, length)) ++length;
    EXPECT_NEAR(static_cast<double>(shortest(test::marker_of(pieces, 4))), static_cast<double>(length * test::kSquare),
                kRounding);
  }
}

// A search that nests again and again, and then goes on below the shorter layout, proves what one without does.
TEST(PackLaws, InterruptionsChangeNoProof) {
  test::Random random{47};
  std::uint64_t longest_search = 0;
  for (int trial = 0; trial < 25 / test::kSlowdown + 1; ++trial) {
    const auto pieces = random_pieces(random, 5);
    Coord length = 1;
    while (!test::fit_on_grid(pieces, 4, length)) ++length;
    PackSettings settings;
    settings.interruptions = {.first = 2, .moves_a_piece = 1 + random.below(20), .second = 4, .nodes_a_move = 1};
    SumCache sums;
    const Packing packing = pack(test::marker_of(pieces, 4), settings, {sums});
    EXPECT_TRUE(packing.proved);
    EXPECT_NEAR(static_cast<double>(packing.length_after), static_cast<double>(length * test::kSquare), kRounding);
    EXPECT_LE(packing.bound, length * test::kSquare);
    longest_search = std::max(longest_search, packing.work.nodes);
  }
  EXPECT_GT(longest_search, 16U);
}

TEST(PackLaws, InterruptionsKeepTheSequenceOfPiecesAndTheirLocks) {
  test::Random random{59};
  for (int trial = 0; trial < 12 / test::kSlowdown + 3; ++trial) {
    Marker marker = test::marker_of(random_pieces(random, 5), 4);
    const std::size_t locked = 1 + random.below(4);
    marker.pieces[locked].locked = true;
    PackSettings settings;
    settings.interruptions = {.first = 1, .moves_a_piece = 0, .second = 2, .nodes_a_move = 1};
    SumCache sums;
    const Packing packing = pack(marker, settings, {sums});
    ASSERT_EQ(packing.marker.pieces.size(), marker.pieces.size());
    for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
      EXPECT_EQ(packing.marker.pieces[k].id, marker.pieces[k].id);
      EXPECT_EQ(packing.marker.pieces[k].locked, marker.pieces[k].locked);
    }
    EXPECT_EQ(packing.marker.pieces[locked].at, marker.pieces[locked].at);
    EXPECT_TRUE(packing.proved);
  }
}

// Where every piece is its own mirror image, half of the layouts are left out (core/packing/bodies/mirror.h).
TEST(PackLaws, SkipsOnlyMirrorImages) {
  test::Random random{43};
  const auto bar = [&] {
    test::Squares squares;
    const Coord width = random.between(1, 3);
    const Coord height = random.between(1, 2);
    for (Coord x = 0; x < width; ++x) {
      for (Coord y = 0; y < height; ++y) squares.push_back({x, y});
    }
    return squares;
  };
  // Its own image along the strip, across it, by half a turn.
  const std::vector<test::Squares> others{
      {{0, 0}, {1, 0}, {2, 0}, {1, 1}}, {{0, 0}, {0, 1}, {0, 2}, {1, 1}}, {{0, 0}, {1, 0}, {1, 1}, {2, 1}}};
  for (int trial = 0; trial < 9 / test::kSlowdown + 3; ++trial) {
    const std::size_t other = static_cast<std::size_t>(trial) % (others.size() + 1);
    const std::size_t copies = other < others.size() ? 1 + random.below(3) : 0;
    std::vector<test::Squares> pieces(copies, other < others.size() ? others[other] : test::Squares{});
    while (pieces.size() < 5) pieces.push_back(bar());
    Coord length = 1;
    while (!test::fit_on_grid(pieces, 4, length)) ++length;
    EXPECT_NEAR(static_cast<double>(shortest(test::marker_of(pieces, 4))), static_cast<double>(length * test::kSquare),
                kRounding)
        << "trial " << trial;
  }
}

TEST(PackLaws, MirrorAndScaleDoNotMatter) {
  test::Random random{43};
  for (int trial = 0; trial < 15 / test::kSlowdown + 1; ++trial) {
    Marker marker = test::marker_of(random_pieces(random, 4), 4);
    for (Shape& shape : marker.shapes) shape.may_flip = true;
    PackSettings settings;
    settings.turns = false;
    SumCache sums;
    const auto length = [&](const Marker& one) { return pack(one, settings, {sums}).length_after; };
    const Coord expected = length(marker);
    EXPECT_NEAR(static_cast<double>(length(test::mirrored(marker))), static_cast<double>(expected), kRounding);
    EXPECT_NEAR(static_cast<double>(length(test::on_finer_lattice(marker))), static_cast<double>(10 * expected),
                10 * kRounding);
  }
}

TEST(PackLaws, ThreadsDoNotMatter) {
  test::Random random{47};
  for (int trial = 0; trial < 5 / test::kSlowdown + 1; ++trial) {
    const Marker marker = test::marker_of(random_pieces(random, 6), 4);
    SumCache sums;
    PackSettings settings;
    settings.limits.nodes = 3000;
    const Packing expected = pack(marker, settings, {sums});
    for (const std::size_t threads : {2U, 4U}) {
      const protocol::execution::ThreadPool pool{threads - 1};
      scene::Run run{sums};
      run.executor = &pool;
      const Packing packing = pack(marker, settings, run);
      EXPECT_EQ(packing.marker, expected.marker);
      EXPECT_EQ(packing.bound, expected.bound);
      EXPECT_EQ(packing.work.nodes, expected.work.nodes);
      EXPECT_EQ(packing.work.pivots, expected.work.pivots);
    }
  }
}

}  // namespace
}  // namespace selvage::packing
