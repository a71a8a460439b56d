// The tuning constants of sections.  Values were chosen on the tiles of docs/measurements/growth.md.
#pragma once

#include <cstddef>

namespace selvage::motion::sections {

struct SectionTuning {
  std::size_t many{2000};     // markers of at least this many pieces are divided
  std::size_t pieces{1000};   // of a section, about
  std::size_t sampled{5000};  // of at least this many, some sections are asked first (compaction/improve_divided.h)
  double layer{0.1};          // the thickness of a layer; part of the strip's width
  double settled{1e-4};       // part of the width: a section that gains less counts as settled
  double worth_a_pass{2e-6};  // part of the marker's length: a pass that gains less is the last
  int passes{40};             // at most
  friend bool operator==(const SectionTuning&, const SectionTuning&) = default;
};

}  // namespace selvage::motion::sections
