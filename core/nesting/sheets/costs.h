// What sheets cost, and in which order the kinds of sheets are tried.
// Kinds are named by their index in the list of ready sheets.
#pragma once

#include <cstddef>
#include <vector>

#include "core/nesting/sheets/used_sheet.h"

namespace selvage::nesting::sheets {

// Where all kinds cost the same, even nothing, each counts as 1, so that the cost of some sheets is their number.
class Costs {
 public:
  explicit Costs(const std::vector<ReadySheet>& sheets);

  [[nodiscard]] double of(std::size_t kind) const { return kinds_[kind].cost; }
  [[nodiscard]] double of(const std::vector<UsedSheet>& used) const;
  [[nodiscard]] bool differ() const { return differ_; }
  // Whether one kind costs less than another, or as much and is smaller.
  [[nodiscard]] bool cheaper(std::size_t a, std::size_t b) const;
  // No sheets with this area cost less.  Where costs differ, only a part of the last sheet counts.
  [[nodiscard]] double least_for(double area) const;

  // Those that cost least for their area first, of these the largest.
  [[nodiscard]] const std::vector<std::size_t>& by_cost_per_area() const { return by_cost_per_area_; }
  // The cheapest first, of these the smallest.
  [[nodiscard]] const std::vector<std::size_t>& by_cost() const { return by_cost_; }

 private:
  struct Kind {
    double cost{}, area{};
    std::size_t count{};
  };
  [[nodiscard]] static double cost_per_area(const Kind& kind);  // infinite where holes cover all of the sheet

  std::vector<Kind> kinds_;
  bool differ_{};
  std::vector<std::size_t> by_cost_per_area_, by_cost_;
};

}  // namespace selvage::nesting::sheets
