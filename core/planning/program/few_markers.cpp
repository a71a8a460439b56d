#include "core/planning/program/few_markers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/planning/program/plies.h"

namespace selvage::planning::program {
namespace {

// Of rounding in projections, whose lengths are those of numbers of garments.
constexpr double kRounding = 1e-9;
constexpr std::size_t kPlane = 2;  // directions that are looked at when one marker is missing

using Point = std::array<double, kPlane>;
double cross(const Point& a, const Point& b) {
  return a[0] * b[1] - a[1] * b[0];
}
double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1];
}

// The box of a colour as the plane sees it: inside a disc.
struct Disc {
  Point middle{};
  double radius{}, distance{};  // of the middle from the origin
  [[nodiscard]] bool has_origin() const { return distance <= radius; }
};

// Directions at right angles to some ratios: rows of orthonormal vectors.
struct Directions {
  std::vector<double> rows;
  std::size_t count{};
};

class SetList {
 public:
  SetList(const orders::Problem& problem, const std::vector<Candidate>& candidates, const SetLimits& limits,
          std::stop_token stop)
      : problem_{problem},
        sizes_{problem.order.sizes.size()},
        work_{limits.work},
        target_{limits.target},
        stop_{std::move(stop)} {
    for (const Candidate& candidate : candidates) {
      Price price = price_of(problem, candidate);
      if (price.most_units == 0) continue;
      candidates_.push_back(candidate);
      prices_.push_back(std::move(price));
      for (const int bundles : candidate.ratio) ratios_.push_back(bundles);
    }
    for (std::size_t colour = 0; colour < problem.order.colours.size(); ++colour)
      windows_.push_back(window_of(problem, colour));
  }

  FewMarkers list() {
    FewMarkers few;
    for (std::size_t markers = 1; markers <= candidates_.size() && !too_many(markers); ++markers) {
      begin(markers);
      choose(0, 0);
      if (exhausted_) break;
      few.fewest = static_cast<int>(markers) + 1;
      few.least = std::min(few.least, least_cost_);
      if (few.least < target_) break;
    }
    few.cutting = std::move(cutting_);
    return few;
  }

 private:
  // Whether the sets without their last marker are more than the work that is left.
  [[nodiscard]] bool too_many(std::size_t markers) const {
    double sets = 1;
    for (std::size_t k = 1; k < markers; ++k)
      sets *= static_cast<double>(candidates_.size() - k + 1) / static_cast<double>(k);
    return sets > static_cast<double>(work_);
  }

  void begin(std::size_t markers) {
    set_.assign(markers, 0);
    directions_.assign(markers, {});
    directions_[0].count = markers == 1 ? std::min(sizes_, kPlane) : sizes_;
    directions_[0].rows.assign(sizes_ * sizes_, 0);
    for (std::size_t k = 0; k < sizes_; ++k) directions_[0].rows[k * sizes_ + k] = 1;
    least_cost_ = lp::kInfinity;
  }

  void pay(std::uint64_t work) {
    constexpr std::uint64_t kLook = 4096;  // payments between two looks at the stop token
    work_ -= std::min(work, work_);
    exhausted_ = exhausted_ || work_ == 0 || (++payments_ % kLook == 0 && stop_.stop_requested());
  }

  // The member of the set at this depth, and those behind it.
  void choose(std::size_t depth, std::size_t from) {
    if (depth + 1 == set_.size()) return choose_last(from);
    for (std::size_t candidate = from; candidate < candidates_.size() && !exhausted_; ++candidate) {
      set_[depth] = candidate;
      turn_away(directions_[depth], candidate, directions_[depth + 1], depth + 2 == set_.size());
      choose(depth + 1, candidate + 1);
    }
  }

  [[nodiscard]] const double* row(const Directions& directions, std::size_t k) const {
    return directions.rows.data() + k * sizes_;
  }
  template <class Vector>
  [[nodiscard]] double along(const double* direction, const Vector& vector) const {
    double sum = 0;
    for (std::size_t size = 0; size < sizes_; ++size) sum += direction[size] * vector[size];
    return sum;
  }
  [[nodiscard]] const double* ratio(std::size_t candidate) const { return ratios_.data() + candidate * sizes_; }

  // The directions that are also at right angles to the candidate's ratio: a reflection turns the ratio, as the
  // directions see it, into the last of them, which is left out.  `plane`: two are enough.
  void turn_away(const Directions& from, std::size_t candidate, Directions& to, bool plane) const {
    to.count = from.count == 0 ? 0 : from.count - 1;
    if (plane) to.count = std::min(to.count, kPlane);
    to.rows.resize(sizes_ * sizes_);
    if (to.count == 0) return;
    std::array<double, orders::kMostSizes> seen{};
    double square = 0;
    for (std::size_t k = 0; k < from.count; ++k) {
      seen[k] = along(row(from, k), ratio(candidate));
      square += seen[k] * seen[k];
    }
    std::copy_n(from.rows.begin(), to.count * sizes_, to.rows.begin());
    if (square < kRounding) return;  // it depends on the ratios before it
    const std::size_t last = from.count - 1;
    const double before = seen[last];
    seen[last] += before > 0 ? std::sqrt(square) : -std::sqrt(square);
    const double normal = square - before * before + seen[last] * seen[last];
    for (std::size_t size = 0; size < sizes_; ++size) {
      double sum = 0;
      for (std::size_t k = 0; k < from.count; ++k) sum += seen[k] * from.rows[k * sizes_ + size];
      for (std::size_t k = 0; k < to.count; ++k) to.rows[k * sizes_ + size] -= 2 * seen[k] / normal * sum;
    }
  }

  [[nodiscard]] Point seen(const Directions& plane, std::size_t candidate) const {
    Point point{};
    for (std::size_t k = 0; k < plane.count; ++k) point[k] = along(row(plane, k), ratio(candidate));
    return point;
  }

  // The discs of the colours; false when no one ray can meet all of them.
  bool see_colours(const Directions& plane) {
    std::array<double, orders::kMostSizes> reach{};  // how far the plane sees a size
    for (std::size_t size = 0; size < sizes_; ++size) {
      Point point{};
      for (std::size_t k = 0; k < plane.count; ++k) point[k] = row(plane, k)[size];
      reach[size] = std::sqrt(dot(point, point));
    }
    discs_.clear();
    for (const Window& window : windows_) {
      Disc disc{.radius = kRounding};
      for (std::size_t size = 0; size < sizes_; ++size) {
        const double middle = (window.least[size] + window.most[size]) / 2.0;
        disc.radius += reach[size] * (window.most[size] - window.least[size]) / 2.0;
        for (std::size_t k = 0; k < plane.count; ++k) disc.middle[k] += middle * row(plane, k)[size];
      }
      disc.distance = std::sqrt(dot(disc.middle, disc.middle));
      if (disc.has_origin()) continue;
      for (const Disc& other : discs_) {
        const double apart = std::abs(cross(disc.middle, other.middle));
        if (apart > disc.radius * other.distance + other.radius * disc.distance) return false;
      }
      discs_.push_back(disc);
    }
    return true;
  }

  [[nodiscard]] bool meets_all(const Point& ray) const {
    const double length = std::sqrt(dot(ray, ray));
    return std::all_of(discs_.begin(), discs_.end(), [&](const Disc& disc) {
      return dot(disc.middle, ray) >= -kRounding &&
             std::abs(cross(disc.middle, ray)) <= (disc.radius + kRounding) * length + kRounding;
    });
  }

  void choose_last(std::size_t from) {
    const Directions& plane = directions_[set_.size() - 1];
    pay(1);
    if (!see_colours(plane)) return;
    pay(candidates_.size() - from);
    for (std::size_t candidate = from; candidate < candidates_.size() && !exhausted_; ++candidate) {
      if (!meets_all(seen(plane, candidate))) continue;
      set_.back() = candidate;
      decide();
    }
  }

  // What the set costs at least, and a cutting by its markers.
  void decide() {
    std::vector<Use> uses;
    std::vector<Member> members;
    double cost = 0;
    for (const std::size_t candidate : set_) {
      uses.push_back({candidates_[candidate], {}});
      members.push_back({&candidates_[candidate].ratio, prices_[candidate].unit});
      cost += prices_[candidate].lay + prices_[candidate].marker;
    }
    for (const Window& window : windows_) {
      const auto plies = cheapest_plies(window, members, work_);
      exhausted_ = exhausted_ || work_ == 0;
      if (!plies) return;
      cost += plies->cost;
      for (std::size_t k = 0; k < uses.size(); ++k) uses[k].units.push_back(plies->units[k]);
    }
    least_cost_ = std::min(least_cost_, cost);
    std::erase_if(uses, [](const Use& use) {
      return std::all_of(use.units.begin(), use.units.end(), [](int units) { return units == 0; });
    });
    std::sort(uses.begin(), uses.end(),
              [](const Use& a, const Use& b) { return a.candidate.ratio < b.candidate.ratio; });
    const double real = cost_of(problem_, uses);
    if ((!cutting_ || real < cutting_->cost) && delivers(problem_, uses)) cutting_ = Cutting{std::move(uses), real};
  }

  const orders::Problem& problem_;
  std::size_t sizes_;
  std::uint64_t work_;
  double target_;
  std::stop_token stop_;
  std::vector<Candidate> candidates_;
  std::vector<Price> prices_;
  std::vector<double> ratios_;   // by candidate, by size
  std::vector<Window> windows_;  // by colour
  bool exhausted_{};
  std::uint64_t payments_{};
  // Of the sets of one number of markers:
  std::vector<std::size_t> set_;
  std::vector<Directions> directions_;  // by depth: at right angles to the members before
  std::vector<Disc> discs_;             // of the colours that the members before the last cannot deliver alone
  double least_cost_{lp::kInfinity};
  std::optional<Cutting> cutting_;
};

}  // namespace

FewMarkers few_markers(const orders::Problem& problem, const std::vector<Candidate>& candidates,
                       const SetLimits& limits, std::stop_token stop) {
  return SetList{problem, candidates, limits, std::move(stop)}.list();
}

}  // namespace selvage::planning::program
