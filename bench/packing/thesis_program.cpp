#include "bench/packing/thesis_program.h"

#include <algorithm>
#include <span>
#include <vector>

namespace selvage::bench {
namespace {

using packing::branching::Chosen;
using packing::cells::HalfPlane;
using Entry = lp::LinearProgram::Entry;

class ProgramMaker {
 public:
  ProgramMaker(const packing::branching::Problem& problem, Cover cover, double longest)
      : problem_{problem}, cover_{cover} {
    for (const auto& body : problem.bodies) {
      const auto& variant = body.variants.front();
      RealBox range = variant.range;
      range.high_x = std::min(range.high_x, longest - variant.width);
      ranges_.push_back(range);
      made_.unit = std::max(made_.unit, range.high_y + 1);
    }
    length_ = program().add_column(1, problem.least_length / made_.unit, longest / made_.unit);
  }

  ThesisProgram make() {
    for (std::uint32_t body = 0; body < problem_.world(); ++body) add_body(body);
    for (const auto& [pair, rings] : problem_.between) {
      for (const std::uint32_t ring : rings) add_ring(pair.first.body, pair.second.body, problem_.rings[ring]);
    }
    return std::move(made_);
  }

 private:
  [[nodiscard]] lp::LinearProgram& program() { return made_.program.linear; }
  [[nodiscard]] int column_x(std::uint32_t body) const { return length_ + 1 + 2 * static_cast<int>(body); }

  // Adds the columns of a body's position, and the row that keeps its right end within the length.
  void add_body(std::uint32_t body) {
    const RealBox& range = ranges_[body];
    program().add_column(0, range.low_x / made_.unit, range.high_x / made_.unit);
    program().add_column(0, range.low_y / made_.unit, range.high_y / made_.unit);
    const double width = problem_.bodies[body].variants.front().width / made_.unit;
    program().add_row(std::vector<Entry>{{length_, 1}, {column_x(body), -1}}, width);
  }

  void add_ring(std::uint32_t first, std::uint32_t second, const packing::cells::WedgeRing& ring) {
    std::vector<Entry> any;
    std::vector<Entry> at_most_one;
    for (const auto& set : cover_(ring)) {
      const int chosen = made_.program.add_whole_column(0, 0, 1);
      any.push_back({chosen, 1});
      at_most_one.push_back({chosen, -1});
      for (const HalfPlane& side : set) add_side(first, second, side, chosen);
    }
    program().add_row(any, 1);
    program().add_row(at_most_one, -1);
  }

  void add_side(std::uint32_t first, std::uint32_t second, const HalfPlane& side, int chosen) {
    std::vector<Entry> row;
    double least = 0;
    const auto add_term = [&](double factor, int column, double low, double high) {
      if (factor == 0) return;
      row.push_back({column, factor});
      least += std::min(factor * low, factor * high);
    };
    const auto add_position = [&](double sign, std::uint32_t body) {
      if (body == problem_.world()) return;
      const RealBox& range = ranges_[body];
      add_term(sign * side.nx, column_x(body), range.low_x, range.high_x);
      add_term(sign * side.ny, column_x(body) + 1, range.low_y, range.high_y);
    };
    add_position(-1, first);
    add_position(1, second);
    const double lambda = (side.c - least) / made_.unit;
    if (lambda <= 0) return;  // holds everywhere
    row.push_back({chosen, -lambda});
    program().add_row(row, side.c / made_.unit - lambda);
  }

  const packing::branching::Problem& problem_;
  Cover cover_;
  std::vector<RealBox> ranges_;
  int length_{};
  ThesisProgram made_{};
};

}  // namespace

ThesisProgram thesis_program(const packing::branching::Problem& problem, Cover cover, double longest) {
  return ProgramMaker{problem, cover, longest}.make();
}

}  // namespace selvage::bench
