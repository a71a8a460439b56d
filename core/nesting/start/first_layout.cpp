#include "core/nesting/start/first_layout.h"

#include <optional>
#include <utility>

#include "core/marker/clearance.h"
#include "core/marker/placed_pieces.h"
#include "core/nesting/filling/proved_layout.h"
#include "core/nesting/layout/layout.h"
#include "core/nesting/local_search/guided_search.h"
#include "core/nesting/start/shelves.h"

namespace selvage::nesting::start {
namespace {

constexpr int kLengths = 4;            // strips that are tried,
constexpr double kLonger = 1.25;       // each by this factor longer than the one before
constexpr std::size_t kPatience = 60;  // iterations without progress on one of them, as in a bold attempt (../tuning.h)

class FirstLayout {
 public:
  FirstLayout(const Marker& shelves, const layout::PieceSet& set, const FirstLayoutSettings& settings,
              const scene::Run& run)
      : shelves_{shelves}, set_{set}, settings_{settings}, run_{run} {}

  Result<Marker> found() {
    if (set_.size() <= settings_.most_pieces) {
      if (auto marker = searched()) return *std::move(marker);
    }
    if (auto marker = proved(shelves_)) return *std::move(marker);
    if (settings_.out_of_time()) {
      return Error{ErrorCode::kStoppedEarly, "stopped before a layout was found in which all pieces keep their rules",
                   ""};
    }
    return Error{ErrorCode::kOutOfRange,
                 "no layout was found in which all pieces keep their rules" +
                     (crowded_ ? "; piece \"" + shelves_.pieces[*crowded_].id + "\" found no room" : std::string{}),
                 ""};
  }

 private:
  std::optional<Marker> searched() {
    const auto& over = settings_.out_of_time;
    local_search::GuidedSearch search{set_, settings_.seed, settings_.map_bytes, settings_.search, over};
    layout::Layout layout = to_layout(set_, shelves_);
    search.build(layout, set_.fixed, over);
    for (int k = 0; k < kLengths && !over(); ++k) {
      auto outcome = search.separate(layout, {kPatience, 1}, over);
      if (outcome.loss == 0) {
        if (auto marker = proved(to_marker(set_, outcome.layout, shelves_))) return marker;
      }
      layout = std::move(outcome.layout);
      crowded_ = search.most_overlapping(layout, std::nullopt);
      set_length(set_, layout, layout.length * kLonger, layout.length / 2);
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Marker> proved(const Marker& marker) const {
    auto done = filling::proved(marker, {.separation_rounds = settings_.separation_rounds}, run_);
    if (!done) return std::nullopt;
    return std::move(done->marker);
  }

  const Marker& shelves_;
  const layout::PieceSet& set_;
  const FirstLayoutSettings& settings_;
  const scene::Run& run_;
  std::optional<std::size_t> crowded_;
};

}  // namespace

Result<Marker> first_layout(const Marker& start, const layout::PieceSet& set, const std::vector<bool>& kept,
                            const FirstLayoutSettings& settings, const scene::Run& run) {
  auto shelves = on_shelves(start, set, kept);
  if (!shelves) return shelves;
  const marker::PlacedPieces pieces{*shelves};
  if (are_inside(pieces, shelves->strip)) return shelves;
  return FirstLayout{*shelves, set, settings, run}.found();
}

}  // namespace selvage::nesting::start
