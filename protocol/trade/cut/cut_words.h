// The commands of a cut file: ASTM D6672 (a subset of EIA-274-D) with Gerber's codes.
//
// A file is a list of blocks that end with *, each of words: a letter and a number.  Coordinates are absolute and
// modal.  The reader supports X, Y, N (a piece begins), M14 and B (knife down), M15 and A (knife up), D1 and D2 (pen
// down and up, for the move of their own block, too), M20 (message), M31 (label), M43, M44 and R (drill), M0 and M30
// (end), G70 and G71 (unit); it ignores other commands, as the standard requires.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/trade/loops.h"
#include "protocol/trade/style.h"

namespace selvage::protocol::trade::cut {

struct CutLabel {
  std::string text;
  Spot at;
};

struct CutPiece {
  std::vector<CutLabel> labels;
  std::vector<Run> runs;   // of the lowered knife
  std::vector<Run> drawn;  // of the lowered pen
  std::vector<Spot> drills;
  std::size_t number{};  // of its N; 0: none
};

// Units: those of the file's numbers.
struct CutCommands {
  std::string message;      // of M20
  std::optional<int> unit;  // 70 or 71
  std::vector<CutPiece> pieces;
  bool numbered{};  // the file says by N where a piece begins
  std::vector<Note> notes;
};

// Whether the text begins like a cut file: with blocks of words.
[[nodiscard]] bool looks_like_cut(std::string_view text);

[[nodiscard]] CutCommands read_commands(std::string_view text);

}  // namespace selvage::protocol::trade::cut
