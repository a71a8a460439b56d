#include "tests/soak/compaction/laws.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/motion/baseline/one_at_a_time.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/compaction/critical_path.h"
#include "core/motion/piece/bump.h"
#include "tests/judge/exact_pairs.h"

namespace selvage::test {
namespace {

constexpr double kContact = 1e-4;  // fraction of the width within which pieces count as touching

double part_gained(Coord before, Coord after) {
  return static_cast<double>(before - after) / static_cast<double>(std::max<Coord>(1, before));
}

Result<motion::compaction::Compaction> compacted(const Marker& marker, SumCache& sums) {
  return compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), {sums});
}

Coord spacing_of(const Marker& marker, PieceId p, PieceId q) {
  return std::max(marker.spacing, marker.pieces[p.value].buffer + marker.pieces[q.value].buffer);
}

bool is_contact(const Marker& marker, const motion::compaction::LoadedContact& contact) {
  const auto near = static_cast<Coord>(std::ceil(kContact * static_cast<double>(marker.strip.width)));
  const Polygon first = placed_outline(marker, contact.first);
  if (contact.second) {
    const Coord spacing = spacing_of(marker, contact.first, *contact.second);
    return nearer_than(first, placed_outline(marker, *contact.second), spacing + near);
  }
  const Box box = box_of(first);
  switch (contact.edge) {
    case StripEdge::kLeft: return box.low.x <= marker.strip.margin + near;
    case StripEdge::kRight: return box.high.x >= length_of(marker) - near;
    case StripEdge::kBottom: return box.low.y <= marker.strip.margin + near;
    case StripEdge::kTop: return box.high.y >= marker.strip.width - marker.strip.margin - near;
  }
  return false;
}

std::string names_of(const Marker& marker, const motion::compaction::LoadedContact& contact) {
  const std::string first = marker.pieces[contact.first.value].id;
  return contact.second ? first + " and " + marker.pieces[contact.second->value].id : first + " and an edge";
}

}  // namespace

CompactionVerdict judged_compaction(const Marker& start, SumCache& sums) {
  const auto done = compacted(start, sums);
  if (!done) return {.fault = "compaction failed: " + done.error().message};
  CompactionVerdict verdict;
  Judge judge;
  verdict.fault = judge.fault_of(done->marker);
  if (!verdict.fault.empty()) return verdict;

  const auto sweeps = motion::baseline::compact_one_at_a_time(start, {}, {sums});
  if (!sweeps) return {.fault = "sweeps failed: " + sweeps.error().message};
  verdict.beyond_sweeps = -part_gained(sweeps->length_after, done->length_after);
  if (verdict.beyond_sweeps > kSignificant) verdict.fault = "longer than after sweeps of single pieces";
  if (const auto again = compacted(done->marker, sums)) {
    verdict.second_gain = part_gained(done->length_after, again->length_after);
  }

  const auto hold = motion::compaction::critical_path(done->marker, {sums});
  if (!hold) return {.fault = "no critical path: " + hold.error().message};
  std::set<PieceId> holding;
  for (const motion::compaction::LoadedContact& contact : hold->contacts) {
    if (!is_contact(done->marker, contact)) verdict.fault = "no contact between " + names_of(done->marker, contact);
    holding.insert(contact.first);
    if (contact.second) holding.insert(*contact.second);
  }
  for (const PieceId piece : holding) {
    const auto bumped = motion::piece::repair_and_bump(done->marker, piece, -1, 0, {sums});
    if (!bumped || bumped->bump.gain <= 0) continue;
    const auto after = compacted(bumped->marker, sums);
    if (after) verdict.after_bump = std::max(verdict.after_bump, part_gained(done->length_after, after->length_after));
  }
  return verdict;
}

}  // namespace selvage::test
