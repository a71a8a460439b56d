// Several explorations from different starts, of which the better ones go on.
//
// A search soon reaches a length from which it hardly gets away, and how good that is depends on its start.  So starts
// are compared after equal work: of two that have made as many moves, the shorter one makes as many again, and is
// compared with the winner of two others [KKS13, JT16].
//
//     start a search and let it make a first share of moves
//     while the last two have made as many moves: drop the longer one, and let the other make as many again
//
// What happens does not depend on the limit in moves.  With a limit in time, a part of it goes into starts, whose share
// is smaller where that leaves time for more of them, and the best search has the rest.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "core/nesting/exploration.h"

namespace selvage::nesting {

class Race {
 public:
  // Begins an exploration.
  using Begin = std::function<std::unique_ptr<Exploration>()>;

  // The moves of a start before it is compared: `most`, or fewer when time is limited; and the part of the time that
  // goes into starts.
  struct Terms {
    std::uint64_t least{}, most{};
    double raced{};
  };

  Race(Begin begin, Terms terms, const Budget& budget)
      : begin_{std::move(begin)}, terms_{terms}, share_{terms.most}, budget_{budget} {}

  // Returns the best exploration.
  [[nodiscard]] std::unique_ptr<Exploration> run(const local_search::GuidedSearch& search);
  // The linear programs of all others.
  [[nodiscard]] int programs() const { return programs_; }

 private:
  struct Runner {
    std::unique_ptr<Exploration> exploration;
    int shares{};  // that it has made: a power of two
  };

  [[nodiscard]] std::uint64_t share_in_time(std::uint64_t moves) const;
  [[nodiscard]] bool may_start(std::uint64_t moves, double first) const;
  void start(const local_search::GuidedSearch& search);
  void compare_last_two();

  Begin begin_;
  Terms terms_;
  std::uint64_t share_;
  const Budget& budget_;
  int programs_{};
  std::vector<Runner> runners_;  // shares fall from the first to the last
};

}  // namespace selvage::nesting
