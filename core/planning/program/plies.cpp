#include "core/planning/program/plies.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/lp/linear_program.h"

namespace selvage::planning::program {
namespace {

constexpr int kNever = std::numeric_limits<int>::max();

class PliesSearch {
 public:
  PliesSearch(std::span<const Member> members, std::uint64_t& work)
      : members_{members}, work_{work}, units_(members.size()) {}

  std::optional<Plies> run(const Window& window) {
    descend(0, window, 0);
    if (best_.units.empty()) return std::nullopt;
    return std::move(best_);
  }

 private:
  // The most units of a member when no more than these garments may be delivered.
  [[nodiscard]] int room(std::size_t member, const std::vector<int>& most) const {
    const orders::Ratio& ratio = *members_[member].ratio;
    int units = kNever;
    for (std::size_t size = 0; size < ratio.size(); ++size) {
      if (ratio[size] > 0) units = std::min(units, most[size] / ratio[size]);
    }
    return units;
  }

  // The fewest units of a member with which those behind it can still deliver what is missing.
  [[nodiscard]] int need(std::size_t member, const Window& window) const {
    const orders::Ratio& ratio = *members_[member].ratio;
    std::array<int, orders::kMostSizes> others{};
    for (std::size_t other = member + 1; other < members_.size(); ++other) {
      const int units = room(other, window.most);
      for (std::size_t size = 0; size < ratio.size(); ++size) others[size] += units * (*members_[other].ratio)[size];
    }
    int units = 0;
    for (std::size_t size = 0; size < ratio.size(); ++size) {
      const int missing = window.least[size] - others[size];
      if (missing <= 0) continue;
      if (ratio[size] == 0) return kNever;
      units = std::max(units, (missing + ratio[size] - 1) / ratio[size]);
    }
    return units;
  }

  // All units of the members from this one on that cost less than the best so far.
  void descend(std::size_t member, const Window& window, double cost) {
    if (work_ == 0 || cost >= best_.cost) return;
    --work_;
    if (member == members_.size()) {
      if (std::ranges::all_of(window.least, [](int missing) { return missing <= 0; })) best_ = {units_, cost};
      return;
    }
    const orders::Ratio& ratio = *members_[member].ratio;
    const int last = room(member, window.most);
    Window left = window;
    for (int units = need(member, window); units <= last; ++units) {
      for (std::size_t size = 0; size < ratio.size(); ++size) {
        left.least[size] = window.least[size] - units * ratio[size];
        left.most[size] = window.most[size] - units * ratio[size];
      }
      units_[member] = units;
      descend(member + 1, left, cost + members_[member].unit * units);
    }
  }

  std::span<const Member> members_;
  std::uint64_t& work_;
  std::vector<int> units_;
  Plies best_{.units = {}, .cost = lp::kInfinity};
};

}  // namespace

Window window_of(const orders::Problem& problem, std::size_t colour) {
  Window window;
  const int unit = problem.plies_of_unit();
  for (std::size_t size = 0; size < problem.order.sizes.size(); ++size) {
    window.least.push_back((problem.least(colour, size) + unit - 1) / unit);
    window.most.push_back(problem.most(colour, size) / unit);
  }
  return window;
}

std::optional<Plies> cheapest_plies(const Window& window, std::span<const Member> members, std::uint64_t& work) {
  return PliesSearch{members, work}.run(window);
}

}  // namespace selvage::planning::program
