#include "core/minkowski/convolution/reduced_convolution.h"

namespace selvage::minkowski::convolution {
namespace {

constexpr std::size_t kAskedEvery = 32;  // vertices, so that small sums take no longer than without

// Calls visit(edge) for every edge of `edges` from position `begin` up to `end` of their order by direction, which is
// cyclic.
template <class Visit>
void for_edges_between(const Turns& edges, std::uint32_t begin, std::uint32_t end, Visit visit) {
  const auto& order = edges.by_direction;
  if (begin > end) {
    for (std::uint32_t k = begin; k < order.size(); ++k) visit(order[k]);
    begin = 0;
  }
  for (std::uint32_t k = begin; k < end; ++k) visit(order[k]);
}

// Links each candidate to the one that continues it, using a small open-addressed hash table from start to candidate.
void link(std::vector<Candidate>& candidates, std::size_t first_size, std::size_t second_size) {
  std::size_t slots = 16;
  while (slots < 2 * candidates.size()) slots *= 2;
  std::vector<std::uint32_t> table(slots, kNoCandidate);
  const auto slot_of = [&](std::uint32_t i, std::uint32_t j) {
    return ((static_cast<std::uint64_t>(i) * second_size + j) * 0x9e3779b97f4a7c15U >> 20) & (slots - 1);
  };
  for (std::uint32_t c = 0; c < candidates.size(); ++c) {
    std::size_t s = slot_of(candidates[c].first_vertex, candidates[c].second_vertex);
    while (table[s] != kNoCandidate) s = (s + 1) & (slots - 1);
    table[s] = c;
  }
  for (Candidate& c : candidates) {
    std::uint32_t i = c.first_vertex;
    std::uint32_t j = c.second_vertex;
    if (c.edge_of_first) {
      i = i + 1 == first_size ? 0 : i + 1;
    } else {
      j = j + 1 == second_size ? 0 : j + 1;
    }
    for (std::size_t s = slot_of(i, j); table[s] != kNoCandidate; s = (s + 1) & (slots - 1)) {
      Candidate& follower = candidates[table[s]];
      if (follower.first_vertex != i || follower.second_vertex != j || follower.has_previous) continue;
      c.next = table[s];
      follower.has_previous = true;
      break;
    }
  }
}

}  // namespace

bool inside_whole(const outline::StarPart& of_vertex, std::size_t vertex, const outline::StarPart& of_edge,
                  std::size_t edge, Vec along) {
  if (!of_edge.turns.empty() && of_edge.turns[edge].out != along) return true;
  if (of_vertex.turns.empty()) return false;
  const auto& [in, out] = of_vertex.turns[vertex];
  return cross(in, out) <= 0 || cross(in, along) < 0 || cross(along, out) < 0;
}

std::optional<std::vector<Candidate>> reduced_convolution(const TurningPart& first, const TurningPart& second,
                                                          const std::function<bool()>& stopped) {
  const Polygon& p = first.part.vertices;
  const Polygon& q = second.part.vertices;
  const Turns& p_turns = first.turns;
  const Turns& q_turns = second.turns;
  const double centre_x = first.part.kernel.x + second.part.kernel.x;
  const double centre_y = first.part.kernel.y + second.part.kernel.y;
  std::vector<Candidate> candidates;
  candidates.reserve(2 * (p.size() + q.size()));
  const auto add = [&](std::size_t i, std::size_t j, Vec along, bool edge_of_first) {
    Candidate c;
    c.from = p[i] + q[j];
    c.to = c.from + along;
    c.ax = static_cast<double>(c.from.x) - centre_x;
    c.ay = static_cast<double>(c.from.y) - centre_y;
    c.bx = static_cast<double>(c.to.x) - centre_x;
    c.by = static_cast<double>(c.to.y) - centre_y;
    if (!(c.ax * c.by - c.ay * c.bx > 0)) return;
    c.first_vertex = static_cast<std::uint32_t>(i);
    c.second_vertex = static_cast<std::uint32_t>(j);
    c.edge_of_first = edge_of_first;
    candidates.push_back(c);
  };
  // Where an edge of one is parallel to one of the other, the turn of a vertex of the first part includes the direction
  // in which it ends, that of a vertex of the second part the direction in which it begins.
  const std::vector<std::uint32_t> past_p = places(p_turns, q_turns, true);
  const std::vector<std::uint32_t> before_q = places(q_turns, p_turns, false);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (i % kAskedEvery == 0 && stopped && stopped()) return {};
    if (!p_turns.convex[i]) continue;
    for_edges_between(q_turns, past_p[p_turns.into(i)], past_p[i],
                      [&](std::uint32_t e) { add(i, e, q_turns.edge[e].vector, false); });
  }
  for (std::size_t j = 0; j < q.size(); ++j) {
    if (j % kAskedEvery == 0 && stopped && stopped()) return {};
    if (!q_turns.convex[j]) continue;
    for_edges_between(p_turns, before_q[q_turns.into(j)], before_q[j],
                      [&](std::uint32_t e) { add(e, j, p_turns.edge[e].vector, true); });
  }
  link(candidates, p.size(), q.size());
  return candidates;
}

}  // namespace selvage::minkowski::convolution
