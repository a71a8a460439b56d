// Linear equations in rational arithmetic that given doubles nearly satisfy, and an exact solution near them.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <map>
#include <vector>

namespace selvage::test {

using Rational = boost::multiprecision::cpp_rational;

// The sum of coefficient times unknown equals `right`.
struct Equation {
  std::map<std::size_t, Rational> coefficients{};
  Rational right{};
};

// A solution that differs from `near` in as many unknowns as there are independent equations.  An equation that
// contradicts earlier ones is left out; the caller has to check the result.
[[nodiscard]] std::vector<Rational> exact_solution(std::vector<Equation> equations, std::vector<Rational> near);

}  // namespace selvage::test
