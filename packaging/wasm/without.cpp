// What this build leaves out.  Clp: every program goes to the interior point method, which is the fallback of simplex
// (core/lp/solver/solve.h).  Exceptions: they are faults, and end the program.
#include <cstdlib>

#include "core/lp/solver/clp.h"

namespace selvage::lp::solver {

LpSolution solve_by_simplex(const LinearProgram&, int, std::stop_token) {
  return {.status = LpStatus::kFailed};
}

}  // namespace selvage::lp::solver

extern "C" {
void* __cxa_allocate_exception(unsigned long) {
  std::abort();
}
void __cxa_throw(void*, void*, void (*)(void*)) {
  std::abort();
}
void* __cxa_begin_catch(void*) {
  std::abort();
}
void __cxa_end_catch() {
  std::abort();
}
void __cxa_rethrow() {
  std::abort();
}
}
