// Equations in rationals that some doubles all but satisfy, and what satisfies them exactly.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <map>
#include <vector>

namespace selvage::test {

using Rational = boost::multiprecision::cpp_rational;

// The sum of coefficient times unknown is `right`.
struct Equation {
  std::map<std::size_t, Rational> coefficients{};
  Rational right{};
};

// The solution in which as many unknowns as there are independent equations are not as they were in `near`.  An
// equation that contradicts those before it is left out: the caller looks at what comes of it.
[[nodiscard]] std::vector<Rational> exact_solution(std::vector<Equation> equations, std::vector<Rational> near);

}  // namespace selvage::test
