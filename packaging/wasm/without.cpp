// What these builds leave out.  Clp: every linear program goes to the interior point method, which is the fallback of
// simplex (core/lp/solver/solve.h).  Cbc: integer programs are not solved, so plans are not the cheapest.  The store:
// markers and the library live in memory.  Threads: there is one.  Exceptions: they are faults, and end the program.
#include <cstdlib>

#include "core/lp/integer/cbc.h"
#include "core/lp/solver/clp.h"
#include "server/jobs/prompt_thread.h"
#include "server/store/journal.h"
#include "server/store/library/library_rows.h"

namespace selvage::lp::solver {

LpSolution solve_by_simplex(const LinearProgram&, int, std::stop_token) {
  return {.status = LpStatus::kFailed};
}

}  // namespace selvage::lp::solver

namespace selvage::lp::integer {

IntegerSolution solve_by_branch_and_cut(const IntegerProgram&, const IntegerLimits&, std::span<const double>,
                                        std::stop_token) {
  return {.status = IntegerStatus::kFailed};
}

}  // namespace selvage::lp::integer

namespace selvage::server::jobs {

void run_promptly(Promptness) {}
void woke_up_after(std::chrono::steady_clock::duration) {}

}  // namespace selvage::server::jobs

// There is never a journal, so nobody calls these.
namespace selvage::server::store {

struct Journal::Implementation {};
Journal::~Journal() = default;
disk::StoredContent Journal::restore(std::stop_token) {
  std::abort();
}
bool Journal::opened(std::uint64_t, const MarkerFile&, const std::string&, const std::optional<KeptChange>&) {
  std::abort();
}
bool Journal::changed(std::uint64_t, const ChangeEntry&) {
  std::abort();
}
bool Journal::closed(std::uint64_t, const std::optional<KeptChange>&) {
  std::abort();
}
bool Journal::answered(std::uint64_t, const KeptChange&) {
  std::abort();
}
bool Journal::write(const char*, const std::function<void(disk::Database&)>&) {
  std::abort();
}
void Journal::read(const std::function<void(disk::Database&)>&) {
  std::abort();
}
std::string Journal::failure() const {
  std::abort();
}
std::uint64_t Journal::back_up(const std::string&) {
  std::abort();
}

namespace library {

LibraryRows read_library(disk::Database&) {
  std::abort();
}
std::optional<std::string> read_document(disk::Database&, std::uint64_t) {
  std::abort();
}
std::uint64_t add_row(disk::Database&, const std::string&, const std::string&) {
  std::abort();
}
void remove_row(disk::Database&, std::uint64_t) {
  std::abort();
}

}  // namespace library
}  // namespace selvage::server::store

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
