#include "core/minkowski/convolution/polar_envelope.h"

#include <cmath>

#include "core/geometry/pseudo_angle.h"

namespace selvage::minkowski::convolution {
namespace {

// The distance from the origin in the norm |x| + |y|, which compares points on one ray.
double reach(double x, double y) {
  return std::abs(x) + std::abs(y);
}

struct Point {
  double x{}, y{};
};

// The point where the stretch's line crosses the ray from the origin through (x, y).
Point on_ray(const Stretch& s, double x, double y) {
  const double dx = s.x1 - s.x0;
  const double dy = s.y1 - s.y0;
  const double turn = x * dy - y * dx;
  if (!(turn > 0)) return {s.x1, s.y1};
  const double r = (s.x0 * dy - s.y0 * dx) / turn;
  return {r * x, r * y};
}

// Several lists of stretches stored one after another in one buffer; `starts` holds the start of each list, and the
// end.
struct Runs {
  std::vector<Stretch> stretches;
  std::vector<std::size_t> starts;
};

constexpr std::size_t kUsualRuns = 16;

// Follows each chain of candidates, and cuts chains where they cross the positive x axis.
Runs runs_of(std::span<const Candidate> candidates) {
  Runs runs;
  runs.stretches.reserve(candidates.size() + kUsualRuns);
  runs.starts.reserve(kUsualRuns);
  std::vector<char> done(candidates.size());
  const auto follow = [&](std::uint32_t c) {
    runs.starts.push_back(runs.stretches.size());
    for (; c != kNoCandidate && !done[c]; c = candidates[c].next) {
      done[c] = true;
      const Candidate& e = candidates[c];
      const double a = geometry::pseudo_angle(e.ax, e.ay);
      const double b = geometry::pseudo_angle(e.bx, e.by);
      if (b > a) {
        runs.stretches.push_back({a, b, e.ax, e.ay, e.bx, e.by, c});
        continue;
      }
      if (b == 0) {
        runs.stretches.push_back({a, geometry::kFullTurn, e.ax, e.ay, e.bx, e.by, c});
      } else {
        const double t = e.ay / (e.ay - e.by);
        const double x = e.ax + t * (e.bx - e.ax);
        runs.stretches.push_back({a, geometry::kFullTurn, e.ax, e.ay, x, 0, c});
        runs.starts.push_back(runs.stretches.size());
        runs.stretches.push_back({0, b, x, 0, e.bx, e.by, c});
        continue;
      }
      runs.starts.push_back(runs.stretches.size());
    }
  };
  for (std::uint32_t c = 0; c < candidates.size(); ++c) {
    if (!candidates[c].has_previous) follow(c);
  }
  for (std::uint32_t c = 0; c < candidates.size(); ++c) {
    if (!done[c]) follow(c);  // closed chains
  }
  runs.starts.push_back(runs.stretches.size());
  return runs;
}

// Merges two envelopes into one.
class Merge {
 public:
  Merge(std::span<const Stretch> a, std::span<const Stretch> b, std::vector<Stretch>& out)
      : a_{a}, b_{b}, out_{out}, first_{out.size()} {}

  void run() {
    if (a_.empty() || b_.empty()) {
      out_.insert(out_.end(), a_.begin(), a_.end());
      out_.insert(out_.end(), b_.begin(), b_.end());
      return;
    }
    Stretch a = a_[0];
    Stretch b = b_[0];
    for (;;) {
      if (a.angle1 <= b.angle0) {
        emit(a);
        if (!advance(a_, i_, a)) break;
      } else if (b.angle1 <= a.angle0) {
        emit(b);
        if (!advance(b_, j_, b)) break;
      } else if (a.angle0 < b.angle0) {
        emit_up_to(a, b.angle0, b.x0, b.y0);
      } else if (b.angle0 < a.angle0) {
        emit_up_to(b, a.angle0, a.x0, a.y0);
      } else if (!compare(a, b)) {
        break;
      }
    }
    drain(a_, i_, a);
    drain(b_, j_, b);
  }

 private:
  static bool advance(std::span<const Stretch> list, std::size_t& k, Stretch& current) {
    if (++k >= list.size()) return false;
    current = list[k];
    return true;
  }
  void drain(std::span<const Stretch> list, std::size_t k, const Stretch& current) {
    if (k >= list.size()) return;
    emit(current);
    for (++k; k < list.size(); ++k) emit(list[k]);
  }
  void emit(const Stretch& s) {
    if (!(s.angle1 > s.angle0)) return;
    if (out_.size() > first_) {
      Stretch& last = out_.back();
      if (last.candidate == s.candidate && last.angle1 == s.angle0) {
        last.angle1 = s.angle1;
        last.x1 = s.x1;
        last.y1 = s.y1;
        return;
      }
    }
    out_.push_back(s);
  }
  // Emits the part of `s` before the ray through (x, y) and leaves the rest in `s`.
  void emit_up_to(Stretch& s, double angle, double x, double y) {
    const Point cut = on_ray(s, x, y);
    emit({s.angle0, angle, s.x0, s.y0, cut.x, cut.y, s.candidate});
    s.angle0 = angle;
    s.x0 = cut.x;
    s.y0 = cut.y;
  }
  // Both stretches start at the same angle: emits the outer one up to the end of the shorter.  False when a list is
  // exhausted.
  bool compare(Stretch& a, Stretch& b) {
    const bool a_ends = a.angle1 <= b.angle1;
    const bool b_ends = b.angle1 <= a.angle1;
    const double angle = a_ends ? a.angle1 : b.angle1;
    const Point end_a = a_ends ? Point{a.x1, a.y1} : on_ray(a, b.x1, b.y1);
    const Point end_b = b_ends ? Point{b.x1, b.y1} : on_ray(b, a.x1, a.y1);
    emit_outer(a, b, angle, end_a, end_b);
    a.angle0 = angle;
    a.x0 = end_a.x;
    a.y0 = end_a.y;
    b.angle0 = angle;
    b.x0 = end_b.x;
    b.y0 = end_b.y;
    const bool a_left = !a_ends || advance(a_, i_, a);
    const bool b_left = !b_ends || advance(b_, j_, b);
    return a_left && b_left;
  }
  void emit_outer(const Stretch& a, const Stretch& b, double angle, Point end_a, Point end_b) {
    constexpr double kSame = 4e-15;  // relative tolerance within which two distances count as equal
    const double ra = reach(a.x0, a.y0);
    const double rb = reach(b.x0, b.y0);
    const double sa = reach(end_a.x, end_a.y);
    const double sb = reach(end_b.x, end_b.y);
    const double at_start = std::abs(ra - rb) <= kSame * (ra + rb) ? 0 : ra - rb;
    const double at_end = std::abs(sa - sb) <= kSame * (sa + sb) ? 0 : sa - sb;
    if (at_start >= 0 && at_end >= 0) {
      emit({a.angle0, angle, a.x0, a.y0, end_a.x, end_a.y, a.candidate});
    } else if (at_start <= 0 && at_end <= 0) {
      emit({b.angle0, angle, b.x0, b.y0, end_b.x, end_b.y, b.candidate});
    } else {
      const Stretch& inner = at_start > 0 ? b : a;
      const Stretch& outer = at_start > 0 ? a : b;
      const Point outer_end = at_start > 0 ? end_a : end_b;
      const Point inner_end = at_start > 0 ? end_b : end_a;
      const double ux = outer_end.x - outer.x0;
      const double uy = outer_end.y - outer.y0;
      const double vx = inner_end.x - inner.x0;
      const double vy = inner_end.y - inner.y0;
      const double turn = ux * vy - uy * vx;
      double t = turn == 0 ? 0.5 : ((inner.x0 - outer.x0) * vy - (inner.y0 - outer.y0) * vx) / turn;
      t = std::min(1.0, std::max(0.0, t));
      const Point x{outer.x0 + t * ux, outer.y0 + t * uy};
      const bool full_turn = x.y == 0 && x.x > 0 && angle > 2;
      const double middle =
          std::min(angle, std::max(a.angle0, full_turn ? geometry::kFullTurn : geometry::pseudo_angle(x.x, x.y)));
      emit({a.angle0, middle, outer.x0, outer.y0, x.x, x.y, outer.candidate});
      emit({middle, angle, x.x, x.y, inner_end.x, inner_end.y, inner.candidate});
    }
  }

  std::span<const Stretch> a_, b_;
  std::vector<Stretch>& out_;
  std::size_t first_;
  std::size_t i_{}, j_{};
};

}  // namespace

std::optional<std::vector<Stretch>> polar_envelope(std::span<const Candidate> candidates,
                                                   const std::function<bool()>& stopped) {
  Runs runs = runs_of(candidates);
  Runs merged;
  merged.stretches.reserve(runs.stretches.size());
  merged.starts.reserve(runs.starts.size());
  while (runs.starts.size() > 2) {
    if (stopped && stopped()) return {};
    merged.stretches.clear();
    merged.starts.clear();
    const std::size_t lists = runs.starts.size() - 1;
    for (std::size_t k = 0; k < lists; k += 2) {
      merged.starts.push_back(merged.stretches.size());
      const auto list = [&](std::size_t m) {
        if (m >= lists) return std::span<const Stretch>{};
        return std::span<const Stretch>{runs.stretches}.subspan(runs.starts[m], runs.starts[m + 1] - runs.starts[m]);
      };
      Merge{list(k), list(k + 1), merged.stretches}.run();
    }
    merged.starts.push_back(merged.stretches.size());
    std::swap(runs, merged);
  }
  return std::move(runs.stretches);
}

}  // namespace selvage::minkowski::convolution
