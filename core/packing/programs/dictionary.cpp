#include "core/packing/programs/dictionary.h"

#include <algorithm>
#include <limits>

namespace selvage::packing::programs {
namespace {

constexpr double kPivot = 1e-7;        // smaller entries are no pivots: most are the rounding of a zero
constexpr double kTie = 1e-13;         // ratios nearer than this are equal; the larger pivot wins
constexpr double kGenericCost = 1e-8;  // of the columns besides the length, which costs 1
constexpr int kMostPivots = 500;       // of one program; more mean that rounding has spoilt it
constexpr std::size_t kNone = SIZE_MAX;

// A fixed sequence without pattern in [0.5, 1.5).
double generic(std::size_t k) {
  const std::uint32_t mixed = static_cast<std::uint32_t>(k + 1) * 2654435761U;
  return 0.5 + static_cast<double>(mixed >> 8) / static_cast<double>(1U << 24);
}

}  // namespace

Dictionary::Dictionary(const Columns& columns, bool minimises_length)
    : columns_{columns.count()}, stride_{(columns_ + 2) & ~std::size_t{1}}, cost_(stride_) {
  for (std::size_t k = 0; k < columns_; ++k) {
    free_.push_back({static_cast<std::int32_t>(k), {}});
    where_.push_back(static_cast<std::int32_t>(k));
    cost_[k] = generic(k) * (minimises_length ? kGenericCost : 1);
  }
  cost_[columns.length()] = 1;
}

void Dictionary::add_term(double* into, std::size_t column, double factor) {
  const std::int32_t at = where_[column];
  if (at >= 0) {
    into[at] += factor;
    return;
  }
  const double* const from = row(row_at(at));
  for (std::size_t j = 0; j <= columns_; ++j) into[j] += factor * from[j];
}

void Dictionary::add(const Columns& columns, const Row& added) {
  const std::size_t k = basic_.size();
  entries_.resize((k + 1) * stride_, 0.0);
  double* const into = row(k);
  double constant = -added.plane.c;
  const auto add_body = [&](std::uint32_t body, double nx, double ny) {
    if (body == columns.bodies) return;
    constant += nx * columns.low[body].x + ny * columns.low[body].y;
    if (nx != 0) add_term(into, columns.x(body), nx);
    if (ny != 0) add_term(into, columns.y(body), ny);
  };
  if (added.length) {
    constant += columns.low_length;
    add_term(into, columns.length(), 1);
    add_body(added.second, -added.plane.nx, 0);
  } else {
    add_body(added.first, -added.plane.nx, -added.plane.ny);
    add_body(added.second, added.plane.nx, added.plane.ny);
  }
  into[columns_] += constant * columns.scale;
  basic_.push_back({-1, added});
}

std::size_t Dictionary::most_violated(double tolerance) const {
  std::size_t worst = kNone;
  double least = -tolerance;
  for (std::size_t k = 0; k < basic_.size(); ++k) {
    const double value = row(k)[columns_];
    if (value < least) {
      least = value;
      worst = k;
    }
  }
  return worst;
}

std::size_t Dictionary::entering_for(std::size_t leaving) const {
  const double* const from = row(leaving);
  std::size_t entering = kNone;
  double best = std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t j = 0; j < columns_; ++j) {
    if (from[j] <= kPivot) continue;
    const double ratio = std::max(cost_[j], 0.0) / from[j];
    if (ratio < best - kTie || (ratio < best + kTie && from[j] > largest)) {
      best = ratio;
      largest = from[j];
      entering = j;
    }
  }
  return entering;
}

void Dictionary::pivot(std::size_t leaving, std::size_t entering) {
  double* const from = row(leaving);
  const double factor = -1.0 / from[entering];
  for (std::size_t j = 0; j <= columns_; ++j) from[j] *= factor;
  from[entering] = -factor;
  const auto eliminate = [&](double* into) {
    const double times = into[entering];
    if (times == 0) return;
    into[entering] = 0;
    for (std::size_t j = 0; j <= columns_; ++j) into[j] += times * from[j];
  };
  for (std::size_t k = 0; k < basic_.size(); ++k) {
    if (k != leaving) eliminate(row(k));
  }
  eliminate(cost_.data());
  std::swap(free_[entering], basic_[leaving]);
  note_place(free_[entering], static_cast<std::int32_t>(entering));
  note_place(basic_[leaving], ~static_cast<std::int32_t>(leaving));
}

Dictionary::End Dictionary::solve(const Columns& columns, double ceiling, std::uint64_t& pivots, double tolerance) {
  const double most = (ceiling - columns.low_length) * columns.scale;
  for (int count = 0; count < kMostPivots; ++count) {
    if (cost_[columns_] > most) return End::kAboveCeiling;
    const std::size_t leaving = most_violated(tolerance);
    if (leaving == kNone) return End::kOptimal;
    const std::size_t entering = entering_for(leaving);
    if (entering == kNone) {
      refuted_ = leaving;
      return End::kInfeasible;
    }
    pivot(leaving, entering);
    ++pivots;
  }
  return End::kTrouble;
}

void Dictionary::drop_slack_rows(const Columns& columns, double room) {
  const double most = room * columns.scale;
  for (std::size_t k = basic_.size(); k-- > 0;) {
    if (basic_[k].column >= 0 || basic_[k].row.length || row(k)[columns_] <= most) continue;
    const std::size_t last = basic_.size() - 1;
    if (k != last) {
      std::copy_n(row(last), stride_, row(k));
      basic_[k] = basic_[last];
      note_place(basic_[k], ~static_cast<std::int32_t>(k));
    }
    basic_.pop_back();
  }
  entries_.resize(basic_.size() * stride_);
}

void Dictionary::forget_why() {
  for (Variable& variable : free_) variable.row.why = kUnconditional;
  for (Variable& variable : basic_) variable.row.why = kUnconditional;
}

std::vector<Dictionary::Multiplier> Dictionary::bounding() const {
  std::vector<Multiplier> multipliers;
  multipliers.reserve(columns_);
  for (std::size_t j = 0; j < columns_; ++j) {
    if (free_[j].column < 0 && cost_[j] > 0) multipliers.push_back({free_[j].row, cost_[j]});
  }
  return multipliers;
}

std::vector<Dictionary::Multiplier> Dictionary::refuting() const {
  std::vector<Multiplier> multipliers;
  multipliers.reserve(columns_ + 1);
  const double* const from = row(refuted_);
  for (std::size_t j = 0; j < columns_; ++j) {
    if (free_[j].column < 0 && from[j] < 0) multipliers.push_back({free_[j].row, -from[j]});
  }
  if (basic_[refuted_].column < 0) multipliers.push_back({basic_[refuted_].row, 1});
  return multipliers;
}

}  // namespace selvage::packing::programs
