// usage: trial drags|malformed|soak|slow|deadlines|damage|memory|loading [COUNT]
// Exit codes: 0 no faults; 1 faults; 2 bad command line.
#include <array>
#include <charconv>
#include <cstdio>
#include <optional>
#include <string_view>

#include "tests/trials/trials.h"

namespace selvage::trials {
namespace {

struct Trial {
  std::string_view name;
  std::size_t full;  // the count unless another one is given
  void (*run)(std::size_t, Faults&);
};
constexpr std::array kTrials{
    Trial{"drags", 100'000, drags}, Trial{"malformed", 1'000'000, malformed}, Trial{"soak", 1800, soak},
    Trial{"slow", 10, slow},        Trial{"deadlines", 100, deadlines},       Trial{"damage", 1000, damage},
    Trial{"memory", 3, memory},     Trial{"loading", 10'000, loading},
};

std::optional<std::size_t> count_of(std::string_view word) {
  std::size_t count{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (error != std::errc{} || end != word.data() + word.size() || count == 0) return std::nullopt;
  return count;
}

int run(const Trial& trial, std::size_t count) {
  Faults faults;
  faults.guard(trial.name, [&] { trial.run(count, faults); });
  std::printf("%s: %zu faults\n", trial.name.data(), faults.count());
  return faults.count() == 0 ? 0 : 1;
}

}  // namespace
}  // namespace selvage::trials

int main(int argc, char** argv) {
  using namespace selvage::trials;
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  for (const Trial& trial : kTrials) {
    if (argc < 2 || argc > 3 || trial.name != argv[1]) continue;
    const auto count = argc == 3 ? count_of(argv[2]) : trial.full;
    if (count) return run(trial, *count);
  }
  std::fprintf(stderr, "usage: trial drags|malformed|soak|slow|deadlines|damage|memory|loading [COUNT]\n");
  return 2;
}
