// The content of a pattern file, a style: the pieces of a garment, in one or several sizes, each drawn once.
//
// Units: millimetres.  Every outline and its annotations are rotated so that the grain lies along +x, which is the
// length of the strip.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "protocol/document/annotations.h"
#include "protocol/document/marker_file.h"

namespace selvage::protocol::trade {

using document::Spot;

// How many copies of a piece a garment needs: as drawn, and mirrored about the grain.
struct Quantity {
  int right{1}, left{0};
  friend bool operator==(const Quantity&, const Quantity&) = default;
};
inline constexpr int kMostCopies = 1000;  // of one piece in one garment

struct PatternPiece {
  std::string name, size;
  std::string material, category, annotation;  // empty: the file does not say
  Quantity quantity;
  std::vector<Spot> outline;
  document::Annotations annotations;
  bool half{};                       // its lower side is its mirror line, which lies on the fold of the cloth
  std::vector<double> rotations;     // degrees; empty: what the nap of the cloth allows
  Json attributes = Json::object();  // further properties of the piece in the file, by their names there
  std::size_t line{};                // of the file, where the piece begins; 1 is the first
};

struct Style {
  std::string name, sample_size;
  std::vector<std::string> sizes;  // in the file's order
  std::vector<PatternPiece> pieces;
  Json attributes = Json::object();  // such as author and date
  std::vector<Note> notes;
};

// For cloth in two layers, folded or tubular: a half piece on the fold is cut as a whole one, and any other piece as a
// pair, one the mirror image of the other.  If a quantity does not state the sides, two copies form a pair.  Pieces cut
// beyond the quantity are noted.
void cut_from_two_layers(Style& style);

// Rounds to a millionth of a millimetre, which is fine enough for any file and exact on the lattice of a marker.
[[nodiscard]] double rounded(double millimetres);
[[nodiscard]] Spot rounded(Spot spot);
[[nodiscard]] document::Annotations rounded(document::Annotations annotations);

// Whether every point is finite and at most 100 km from the origin.
[[nodiscard]] bool within_reach(const std::vector<Spot>& points);

// A note on a line of a text file, and an error; 1 is the first line.
[[nodiscard]] Note note_at(std::size_t line, std::string text);
[[nodiscard]] Error error_at(std::size_t line, ErrorCode code, const std::string& text);

}  // namespace selvage::protocol::trade
