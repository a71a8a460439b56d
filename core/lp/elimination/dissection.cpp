#include "core/lp/elimination/dissection.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <span>
#include <utility>

namespace selvage::lp::elimination {
namespace {

// A vertex is a hub if it is in more nets than kHubNets times the square root of the number of vertices, and in more
// than kLeastHubNets.
constexpr double kHubNets = 10;
constexpr std::size_t kLeastHubNets = 300;
// Cuts are looked for within this part of a domain's vertices on either side of the place that divides them equally.
constexpr double kWindow = 0.25;
constexpr int kSweeps = 2;  // searches for a vertex at the end of a component

constexpr int kUnseen = -1;
constexpr int kHub = -2;

std::size_t index(int k) {
  return static_cast<std::size_t>(k);
}

// The vertices but for the hubs, sorted into levels.
struct Levels {
  std::vector<int> level;     // of each vertex; kHub for a hub
  std::vector<int> end;       // of each level, the number of vertices up to it
  std::vector<char> forward;  // of each vertex, whether it is adjacent to one of the next level
};

class LevelSearch {
 public:
  explicit LevelSearch(const Nets& nets) : nets_{nets}, seen_net_(index(nets.count()), 0) {
    nets_start_.assign(index(nets.vertices) + 1, 0);
    for (const int v : nets.vertex) ++nets_start_[index(v) + 1];
    for (std::size_t v = 0; v < index(nets.vertices); ++v) nets_start_[v + 1] += nets_start_[v];
    net_.resize(nets.vertex.size());
    std::vector<int> filled(nets_start_.begin(), nets_start_.end() - 1);
    for (int k = 0; k < nets.count(); ++k) {
      for (const int v : vertices_of(k)) net_[index(filled[index(v)]++)] = k;
    }
  }

  [[nodiscard]] Levels levels() {
    Levels found;
    found.level.assign(index(nets_.vertices), kUnseen);
    const double most = std::max(static_cast<double>(kLeastHubNets), kHubNets * std::sqrt(nets_.vertices));
    for (int v = 0; v < nets_.vertices; ++v) {
      if (static_cast<double>(nets_of(v).size()) > most) found.level[index(v)] = kHub;
    }
    for (int v = 0; v < nets_.vertices; ++v) {
      if (found.level[index(v)] != kUnseen) continue;
      int from = v;
      for (int sweep = 0; sweep < kSweeps; ++sweep) {
        const std::size_t first = order_.size();
        search(from, 0, found.level);
        from = order_.back();
        for (std::size_t k = first; k < order_.size(); ++k) found.level[index(order_[k])] = kUnseen;
        order_.resize(first);
      }
      search(from, static_cast<int>(found.end.size()), found.level);
      for (std::size_t k = found.end.empty() ? 0 : index(found.end.back()); k < order_.size(); ++k) {
        const auto level = index(found.level[index(order_[k])]);
        if (level == found.end.size()) found.end.push_back(0);
        found.end[level] = static_cast<int>(k) + 1;
      }
    }
    mark_forward(found);
    return found;
  }

 private:
  [[nodiscard]] std::span<const int> vertices_of(int net) const {
    return std::span{nets_.vertex}.subspan(index(nets_.start[index(net)]),
                                           index(nets_.start[index(net) + 1] - nets_.start[index(net)]));
  }
  [[nodiscard]] std::span<const int> nets_of(int vertex) const {
    return std::span{net_}.subspan(index(nets_start_[index(vertex)]),
                                   index(nets_start_[index(vertex) + 1] - nets_start_[index(vertex)]));
  }

  // Appends the component of a vertex to the order, and gives its vertices levels from `first_level` on.
  void search(int from, int first_level, std::vector<int>& level) {
    ++searches_;
    level[index(from)] = first_level;
    order_.push_back(from);
    for (std::size_t k = order_.size() - 1; k < order_.size(); ++k) {
      const int v = order_[k];
      for (const int net : nets_of(v)) {
        if (std::exchange(seen_net_[index(net)], searches_) == searches_) continue;
        for (const int w : vertices_of(net)) {
          if (level[index(w)] != kUnseen) continue;
          level[index(w)] = level[index(v)] + 1;
          order_.push_back(w);
        }
      }
    }
  }

  void mark_forward(Levels& found) const {
    found.forward.assign(found.level.size(), 0);
    for (int net = 0; net < nets_.count(); ++net) {
      int last = kUnseen;
      for (const int v : vertices_of(net)) last = std::max(last, found.level[index(v)]);
      for (const int v : vertices_of(net)) {
        if (found.level[index(v)] != kHub && found.level[index(v)] < last) found.forward[index(v)] = 1;
      }
    }
  }

  const Nets& nets_;
  std::vector<int> nets_start_, net_;  // the nets of each vertex
  std::vector<int> seen_net_;          // the last search that came to each net
  int searches_{};
  std::vector<int> order_;
};

// The levels after which the graph is cut, ascending.
std::vector<int> cuts(const Levels& levels, int domains) {
  std::vector<int> cost(levels.end.size(), 0);
  for (std::size_t v = 0; v < levels.level.size(); ++v) {
    if (levels.forward[v] != 0) ++cost[index(levels.level[v])];
  }
  const double part = levels.end.empty() ? 0 : static_cast<double>(levels.end.back()) / domains;
  std::vector<int> found;
  std::size_t level = 0;
  for (int k = 1; k < domains; ++k) {
    const auto distance = [&](std::size_t at) { return std::abs(levels.end[at] - k * part); };
    int best = kUnseen;
    for (; level < levels.end.size() && levels.end[level] <= (k + kWindow) * part; ++level) {
      if (levels.end[level] < (k - kWindow) * part) continue;
      const bool better = best == kUnseen || cost[level] < cost[index(best)] ||
                          (cost[level] == cost[index(best)] && distance(level) < distance(index(best)));
      if (better) best = static_cast<int>(level);
    }
    if (best == kUnseen) return {};
    found.push_back(best);
  }
  return found;
}

bool is_within_bounds(const Dissection& divided) {
  std::vector<int> size(index(divided.domains), 0);
  int border = 0;
  for (const int domain : divided.domain_of) ++(domain == Dissection::kBorder ? border : size[index(domain)]);
  const auto all = static_cast<double>(divided.domain_of.size());
  return border <= Dissection::kMostBorder * all && std::ranges::min(size) > 0 &&
         std::ranges::max(size) <= (1 + Dissection::kMostExcess) * all / divided.domains;
}

}  // namespace

Dissection dissection(const Nets& nets, int domains) {
  Dissection whole{1, std::vector<int>(index(nets.vertices), 0)};
  if (domains == 1) return whole;
  const Levels levels = LevelSearch{nets}.levels();
  const std::vector<int> after = cuts(levels, domains);
  if (after.empty()) return whole;
  Dissection divided{domains, std::vector<int>(index(nets.vertices), Dissection::kBorder)};
  for (std::size_t v = 0; v < levels.level.size(); ++v) {
    const int level = levels.level[v];
    if (level == kHub) continue;
    const auto cut = std::ranges::lower_bound(after, level);
    const bool on_border = cut != after.end() && *cut == level && levels.forward[v] != 0;
    if (!on_border) divided.domain_of[v] = static_cast<int>(cut - after.begin());
  }
  return is_within_bounds(divided) ? divided : whole;
}

}  // namespace selvage::lp::elimination
