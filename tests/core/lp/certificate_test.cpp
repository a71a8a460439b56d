// Tests of certificates: an optimal solution is accepted, and each of the three kinds of violation is detected.
#include "core/lp/certificate.h"

#include <gtest/gtest.h>

#include <vector>

namespace selvage::lp {
namespace {

// Minimise x + y with x + 2 y >= 4 and 3 x + y >= 6: the optimum is (1.6, 1.2), with dual prices 0.4 and 0.2.
LinearProgram two_rows() {
  LinearProgram program;
  program.add_column(1, 0, kInfinity);
  program.add_column(1, 0, kInfinity);
  program.add_row(std::vector<LinearProgram::Entry>{{0, 1}, {1, 2}}, 4);
  program.add_row(std::vector<LinearProgram::Entry>{{0, 3}, {1, 1}}, 6);
  return program;
}
Certificate certificate_with(std::vector<double> x, std::vector<double> dual) {
  return certificate_of(two_rows(), {.status = LpStatus::kOptimal, .x = std::move(x), .dual = std::move(dual)});
}

TEST(Certificate, AcceptsTheOptimum) {
  const Certificate certificate = certificate_with({1.6, 1.2}, {0.4, 0.2});
  EXPECT_NEAR(certificate.primal, 0, 1e-15);
  EXPECT_NEAR(certificate.dual, 0, 1e-15);
  EXPECT_NEAR(certificate.gap, 0, 1e-15);
  EXPECT_TRUE(certificate.closes());
}

TEST(Certificate, DetectsAViolatedRow) {
  const Certificate certificate = certificate_with({1.6, 1.1}, {0.4, 0.2});
  EXPECT_NEAR(certificate.primal, 0.2, 1e-15);
  EXPECT_FALSE(certificate.closes());
}

TEST(Certificate, DetectsANegativePrice) {
  const Certificate certificate = certificate_with({4, 0}, {1, -0.25});
  EXPECT_NEAR(certificate.dual, 0.75,
              1e-15);  // the reduced cost of the second column, which has no upper bound, is -0.75
  EXPECT_FALSE(certificate.closes());
}

TEST(Certificate, DetectsAFeasiblePointThatIsNotOptimal) {
  const Certificate certificate = certificate_with({3, 3}, {0.4, 0.2});
  EXPECT_EQ(certificate.primal, 0);
  EXPECT_NEAR(certificate.gap, (6 - 2.8) / (1 + 6), 1e-15);
  EXPECT_FALSE(certificate.closes());
}

TEST(Certificate,
     AcceptsAColumnBoundAsProof) {  // minimise -x for x <= 5: there are no rows, and the bound proves optimality
  LinearProgram program;
  program.add_column(-1, 0, 5);
  EXPECT_TRUE(certificate_of(program, {.x = {5}}).closes());
  EXPECT_FALSE(certificate_of(program, {.x = {4}}).closes());
}

}  // namespace
}  // namespace selvage::lp
