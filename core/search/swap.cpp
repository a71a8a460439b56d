#include "core/search/swap.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "core/motion/repair/faults.h"
#include "core/motion/separation/separate.h"
#include "core/scene/scene.h"

namespace selvage::search {
namespace {

Coord differences(const Box& a, const Box& b) {
  return std::abs((a.high.x - a.low.x) - (b.high.x - b.low.x)) + std::abs((a.high.y - a.low.y) - (b.high.y - b.low.y));
}
Vec centre_of(const Box& box) {
  return {(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
}

bool alike(const Piece& a, const Piece& b) {
  return a.shape == b.shape && a.orientation == b.orientation && a.buffer == b.buffer && a.overlap == b.overlap;
}

// One of the pieces that differ from piece i and would fit its place best.
std::optional<std::uint32_t> partner_of(std::uint32_t i, const Marker& marker, const marker::PlacedPieces& pieces,
                                        const std::vector<std::uint32_t>& free, const SwapTuning& tuning,
                                        std::mt19937& random) {
  std::vector<std::pair<double, std::uint32_t>> partners;
  for (const std::uint32_t j : free) {
    if (j == i || alike(marker.pieces[i], marker.pieces[j])) continue;
    const Vec way = centre_of(pieces.box(j)) - centre_of(pieces.box(i));
    const double misfit = static_cast<double>(differences(pieces.box(i), pieces.box(j)));
    partners.emplace_back(misfit + tuning.distance_weight * static_cast<double>(std::abs(way.x)), j);
  }
  if (partners.empty()) return std::nullopt;
  const std::size_t best = std::min(tuning.partners, partners.size());
  std::partial_sort(partners.begin(), partners.begin() + static_cast<std::ptrdiff_t>(best), partners.end());
  return partners[random() % best].second;
}

// Turns the piece to another rotation that its shape allows, about the middle of its box; false when there is none, or
// when the tilt, and with it the orientation, is locked or given by the fold.
bool turn(Piece& piece, const Shape& shape, const Box& box, std::mt19937& random) {
  if (piece.locked.tilt || piece.rules.on_fold) return false;
  std::vector<Angle> others;
  for (const Angle rotation : shape.rotations) {
    const bool differs = rotation != piece.orientation.rotation;
    if (differs && keeps_nap(piece.rules, {false, rotation, {}})) others.push_back(rotation);
  }
  if (others.empty()) return false;
  piece.orientation.rotation = others[random() % others.size()];
  piece.at = centre_of(box) - centre_of(box_of(oriented(shape.outline, piece.orientation)));
  return true;
}

// Moves a piece that is matched to the cloth by one repeat of its pattern, to either side.
void jump(Piece& piece, Vec repeat, std::mt19937& random) {
  const bool along = repeat.y == 0 || (repeat.x != 0 && random() % 2 == 0);
  const Coord by = random() % 2 == 0 ? 1 : -1;
  (along ? piece.at.x : piece.at.y) += by * (along ? repeat.x : repeat.y);
}

// A piece of `free`, mostly one that is on the critical path as well.
std::uint32_t drawn_piece(const std::vector<std::uint32_t>& free, std::span<const PieceId> critical,
                          const SwapTuning& tuning, std::mt19937& random) {
  if (!critical.empty() && random() % tuning.any_one_in != 0) {
    const std::uint32_t piece = critical[random() % critical.size()].value;
    if (std::binary_search(free.begin(), free.end(), piece)) return piece;
  }
  return free[random() % free.size()];
}

// By how much pieces overlap or leave the strip, in total; lattice units.
double total_depth(const Marker& marker, const scene::Run& run) {
  const scene::Scene scene{marker, run};
  double total = 0;
  for (const motion::repair::Conflict& conflict : motion::repair::find_conflicts(scene, run)) {
    total += conflict.target.depth;
  }
  for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
    total += static_cast<double>(motion::repair::protrusion(scene, i));
  }
  return total;
}

}  // namespace

std::optional<DrawnSwap> draw_swap(const Marker& start, std::mt19937& random, std::span<const PieceId> critical,
                                   const SwapTuning& tuning) {
  const model::Ties ties = model::ties_of(start);
  std::vector<std::uint32_t> free;
  for (std::uint32_t i = 0; i < start.pieces.size(); ++i) {
    if (ties.free(i)) free.push_back(i);
  }
  if (free.empty()) return std::nullopt;
  const marker::PlacedPieces pieces{start};
  Marker next = start;
  const std::uint32_t i = drawn_piece(free, critical, tuning, random);
  Piece& piece = next.pieces[i];
  const Vec repeat = pieces.repeat_of(i, start.strip);
  if (repeat != Vec{} && random() % tuning.jumps_one_in == 0) {
    jump(piece, repeat, random);
  } else if (random() % tuning.turns_one_in == 0) {
    if (!turn(piece, start.shapes[piece.shape.value], pieces.box(i), random)) return std::nullopt;
  } else {
    const auto j = partner_of(i, start, pieces, free, tuning, random);
    if (!j) return std::nullopt;
    const Vec way = centre_of(pieces.box(*j)) - centre_of(pieces.box(i));
    piece.at = piece.at + way;
    next.pieces[*j].at = next.pieces[*j].at - way;
  }
  return DrawnSwap{std::move(next), pieces.length(), random() % tuning.deep_one_in == 0};
}

SwapOutcome complete_swap(const DrawnSwap& drawn, const motion::compaction::CompactionSettings& settings,
                          const scene::Run& run, const SwapTuning& tuning) {
  const auto width = static_cast<double>(drawn.marker.strip.width);
  if (!drawn.even_if_deep && total_depth(drawn.marker, run) > tuning.deepest * width) return {};
  const double length = static_cast<double>(std::max<Coord>(1, drawn.length));
  motion::separation::SeparationSettings separation;
  separation.rounds = tuning.separation_rounds;
  separation.grow = tuning.separation_growth * width / length;
  separation.solver = settings.solver;
  auto separated = separate(drawn.marker, separation, run);
  if (!separated) return {};
  SwapOutcome done{.marker = {}, .programs = separated->programs};
  if (!separated->apart) return done;
  auto compaction = compact(separated->marker, settings, run);
  if (!compaction) return done;
  done.programs += compaction->programs;
  done.marker = std::move(compaction->marker);
  return done;
}

}  // namespace selvage::search
