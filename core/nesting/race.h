// A race of explorations from different starts, of which the better ones continue.
//
// A search soon reaches a length that it hardly improves any more, and how short that is depends on its start.  So
// explorations are compared after equal numbers of moves: of two, the one with the shorter marker makes as many moves
// again, and is then compared with the winner of two others (successive halving [KKS13, JT16]).
//
//     repeat: begin an exploration and let it make a first share of moves
//       while the last two explorations have made equally many moves:
//         drop the one with the longer marker, and let the other make as many moves again
//
// With a limit on moves, what a race does next does not depend on the limit.  With a time limit, a part of the time is
// spent on starts, and the first share is what several of them can make in it.  Then the best exploration goes on:
//
//     repeat: let the best exploration make as many moves again as it has made, at most eight shares
//       if that has hardly shortened its marker: let it take turns from now on, and race new starts for as many moves
//       as it has made, of which a better one takes its place
//
// Whether a stalled search gains more by walks or by attempts (exploration.h) depends on the pieces.  So of two starts,
// one walks and the other attempts.  The first one takes turns as long as there is no other, and so does the best one
// once it hardly gains any more: the other kind may still shorten its marker.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

#include "core/nesting/exploration.h"

namespace selvage::nesting {

class Race {
 public:
  // Begins an exploration, which does this when it has stalled.
  using Begin = std::function<std::unique_ptr<Exploration>(OnStall)>;

  struct Terms {
    std::uint64_t share{};                          // moves of a start before it is compared, with a limit on moves
    std::uint64_t least_in_time{}, most_in_time{};  // the same with a time limit, at least and at most
    double raced{};                                 // part of a time limit that is spent on starts at first
    double least_gain{};  // the best exploration goes on while doubling its moves would gain more than this part
  };

  Race(Begin begin, Terms terms, const Budget& budget)
      : begin_{std::move(begin)}, terms_{terms}, share_{terms.share}, budget_{budget} {}

  // Returns the best exploration.
  [[nodiscard]] std::unique_ptr<Exploration> run(const local_search::GuidedSearch& search);
  // The number of linear programs that the other explorations have solved.
  [[nodiscard]] int programs() const { return programs_; }

 private:
  struct Runner {
    std::unique_ptr<Exploration> exploration;
    std::uint64_t moves{};  // that it was to make: in a race a share times a power of two
  };

  [[nodiscard]] Runner best_of_starts(const local_search::GuidedSearch& search, const std::function<bool()>& another);
  [[nodiscard]] Runner start(const local_search::GuidedSearch& search);
  [[nodiscard]] OnStall next_on_stall() const;
  [[nodiscard]] bool gains(Runner& best) const;
  static void advance(Runner& runner, std::uint64_t moves);
  [[nodiscard]] std::uint64_t share_in_time(std::uint64_t moves) const;
  [[nodiscard]] bool may_start(std::uint64_t moves, double first) const;
  [[nodiscard]] bool may_continue(const Runner& best, std::uint64_t moves) const;

  Begin begin_;
  Terms terms_;
  std::uint64_t share_;
  const Budget& budget_;
  std::size_t starts_{};  // so far
  int programs_{};
};

}  // namespace selvage::nesting
