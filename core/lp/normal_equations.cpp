#include "core/lp/normal_equations.h"

#include <algorithm>
#include <vector>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

namespace selvage {

using Matrix = Eigen::SparseMatrix<double>;
using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

// The matrix is kept in the order that fills in least, so that a factorisation has nothing to move about.
struct NormalEquations::Parts {
  explicit Parts(const InequalityForm& f) : form{f} {}
  const InequalityForm& form;
  Permutation order;          // from the form's columns to the matrix's
  Matrix matrix;              // its upper triangle
  std::vector<int> position;  // of each row's products in the matrix's values, row after row
  std::vector<int> diagonal;  // of each column's diagonal
  Eigen::SimplicialLLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int>> factor;
  Eigen::VectorXd ordered;  // a right side in the matrix's order
};

namespace {

// Neighbouring rows speak of the same two pieces, as a rule: of the same columns.
bool same_columns(const InequalityForm& form, std::size_t row, std::size_t other) {
  const auto columns = [&](std::size_t r) {
    return std::span{form.column}.subspan(static_cast<std::size_t>(form.row_start[r]),
                                          static_cast<std::size_t>(form.row_start[r + 1] - form.row_start[r]));
  };
  return std::ranges::equal(columns(row), columns(other));
}

// Calls visit(row, i, j) for every product of a row's entries, in the form's columns, with i >= j.  Rows of the same
// columns as the row before are told by repeat(row).
template <class Visit, class Repeat>
void for_products(const InequalityForm& form, const Visit& visit, const Repeat& repeat) {
  for (std::size_t r = 0; r < form.bound.size(); ++r) {
    if (r > 0 && same_columns(form, r, r - 1)) {
      repeat(r);
      continue;
    }
    for (int a = form.row_start[r]; a < form.row_start[r + 1]; ++a) {
      for (int b = a; b < form.row_start[r + 1]; ++b) {
        const int i = form.column[static_cast<std::size_t>(a)];
        const int j = form.column[static_cast<std::size_t>(b)];
        visit(std::max(i, j), std::min(i, j));
      }
    }
  }
}

// The lower triangle in the form's columns, each value its own position.
Matrix numbered_pattern(const InequalityForm& form) {
  std::vector<Eigen::Triplet<double>> triplets;
  for (int j = 0; j < form.columns(); ++j) triplets.emplace_back(j, j, 1.0);
  for_products(
      form, [&](int i, int j) { triplets.emplace_back(i, j, 1.0); }, [](std::size_t) {});
  Matrix pattern(form.columns(), form.columns());
  pattern.setFromTriplets(triplets.begin(), triplets.end());
  for (Eigen::Index k = 0; k < pattern.nonZeros(); ++k) pattern.valuePtr()[k] = static_cast<double>(k);
  return pattern;
}

Permutation least_fill(const Matrix& lower) {
  Matrix whole = lower.selfadjointView<Eigen::Lower>();
  Permutation inverse;
  Eigen::AMDOrdering<int>{}(whole, inverse);
  return inverse.inverse();
}

}  // namespace

NormalEquations::NormalEquations(const InequalityForm& form) : parts_{std::make_unique<Parts>(form)} {
  const Matrix pattern = numbered_pattern(form);
  parts_->order = least_fill(pattern);
  auto& m = parts_->matrix;
  m.resize(form.columns(), form.columns());
  m.selfadjointView<Eigen::Upper>() = pattern.selfadjointView<Eigen::Lower>().twistedBy(parts_->order);
  std::vector<int> place(static_cast<std::size_t>(m.nonZeros()));  // in the matrix, of each position in the pattern
  for (Eigen::Index k = 0; k < m.nonZeros(); ++k) {
    place[static_cast<std::size_t>(m.valuePtr()[k])] = static_cast<int>(k);
  }
  const auto find = [&](int i, int j) {
    const int* begin = pattern.innerIndexPtr() + pattern.outerIndexPtr()[j];
    const int* end = pattern.innerIndexPtr() + pattern.outerIndexPtr()[j + 1];
    return place[static_cast<std::size_t>(std::lower_bound(begin, end, i) - pattern.innerIndexPtr())];
  };
  for (int j = 0; j < form.columns(); ++j) parts_->diagonal.push_back(find(j, j));
  auto& position = parts_->position;
  for_products(
      form, [&](int i, int j) { position.push_back(find(i, j)); },
      [&](std::size_t row) {
        const auto size = static_cast<std::size_t>(form.row_start[row + 1] - form.row_start[row]);
        const std::size_t products = size * (size + 1) / 2;
        for (std::size_t k = 0; k < products; ++k) position.push_back(position[position.size() - products]);
      });
  parts_->factor.analyzePattern(m);
}

NormalEquations::~NormalEquations() = default;

bool NormalEquations::factorise(std::span<const double> weight, double rho) {
  const auto& form = parts_->form;
  double* matrix = parts_->matrix.valuePtr();
  std::fill(matrix, matrix + parts_->matrix.nonZeros(), 0.0);
  for (const int d : parts_->diagonal) matrix[d] = rho;
  const int* position = parts_->position.data();
  for (std::size_t r = 0; r < weight.size(); ++r) {
    const double* value = form.value.data() + form.row_start[r];
    with_row_size(form, r, [&](auto size) {
      for (int a = 0; a < size; ++a) {
        const double scaled = weight[r] * value[a];
        for (int b = a; b < size; ++b) matrix[*position++] += scaled * value[b];
      }
    });
  }
  parts_->factor.factorize(parts_->matrix);
  return parts_->factor.info() == Eigen::Success;
}

void NormalEquations::solve(std::span<double> right_side) {
  Eigen::Map<Eigen::VectorXd> r(right_side.data(), static_cast<Eigen::Index>(right_side.size()));
  parts_->ordered = parts_->order * r;
  parts_->factor.matrixL().solveInPlace(parts_->ordered);
  parts_->factor.matrixU().solveInPlace(parts_->ordered);
  r = parts_->order.inverse() * parts_->ordered;
}

}  // namespace selvage
