#include "core/lp/normal_equations.h"

#include <algorithm>
#include <vector>

#include <Eigen/SparseCholesky>

namespace selvage {

using Matrix = Eigen::SparseMatrix<double>;

struct NormalEquations::Parts {
  explicit Parts(const InequalityForm& f) : form{f} {}
  const InequalityForm& form;
  Matrix matrix;              // its lower triangle
  std::vector<int> position;  // of each row's products in the matrix's values, row after row
  std::vector<int> diagonal;  // of each column's diagonal
  Eigen::SimplicialLLT<Matrix, Eigen::Lower> factor;
};

NormalEquations::NormalEquations(const InequalityForm& form) : parts_{std::make_unique<Parts>(form)} {
  std::vector<Eigen::Triplet<double>> triplets;
  for (int j = 0; j < form.columns(); ++j) triplets.emplace_back(j, j, 1.0);
  for (std::size_t r = 0; r < form.bound.size(); ++r) {
    for (int a = form.row_start[r]; a < form.row_start[r + 1]; ++a) {
      for (int b = a; b < form.row_start[r + 1]; ++b) {
        const int i = form.column[static_cast<std::size_t>(a)];
        const int j = form.column[static_cast<std::size_t>(b)];
        triplets.emplace_back(std::max(i, j), std::min(i, j), 1.0);
      }
    }
  }
  auto& m = parts_->matrix;
  m.resize(form.columns(), form.columns());
  m.setFromTriplets(triplets.begin(), triplets.end());
  const auto find = [&](int i, int j) {
    const int* begin = m.innerIndexPtr() + m.outerIndexPtr()[j];
    const int* end = m.innerIndexPtr() + m.outerIndexPtr()[j + 1];
    return static_cast<int>(std::lower_bound(begin, end, i) - m.innerIndexPtr());
  };
  for (int j = 0; j < form.columns(); ++j) parts_->diagonal.push_back(find(j, j));
  for (std::size_t k = static_cast<std::size_t>(form.columns()); k < triplets.size(); ++k) {
    parts_->position.push_back(find(triplets[k].row(), triplets[k].col()));
  }
  parts_->factor.analyzePattern(m);
}

NormalEquations::~NormalEquations() = default;

bool NormalEquations::factorise(std::span<const double> weight, double rho) {
  const auto& form = parts_->form;
  double* value = parts_->matrix.valuePtr();
  std::fill(value, value + parts_->matrix.nonZeros(), 0.0);
  for (const int d : parts_->diagonal) value[d] = rho;
  const int* position = parts_->position.data();
  for (std::size_t r = 0; r < weight.size(); ++r) {
    for (int a = form.row_start[r]; a < form.row_start[r + 1]; ++a) {
      const double scaled = weight[r] * form.value[static_cast<std::size_t>(a)];
      for (int b = a; b < form.row_start[r + 1]; ++b)
        value[*position++] += scaled * form.value[static_cast<std::size_t>(b)];
    }
  }
  parts_->factor.factorize(parts_->matrix);
  return parts_->factor.info() == Eigen::Success;
}

void NormalEquations::solve(std::span<double> right_side) {
  Eigen::Map<Eigen::VectorXd> r(right_side.data(), static_cast<Eigen::Index>(right_side.size()));
  r = parts_->factor.solve(r);
}

}  // namespace selvage
