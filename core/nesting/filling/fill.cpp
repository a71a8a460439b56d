#include "core/nesting/filling/fill.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "core/nesting/filling/lying.h"
#include "core/nesting/filling/proved_layout.h"
#include "core/nesting/layout/layout.h"
#include "core/nesting/local_search/guided_search.h"

namespace selvage::nesting::filling {
namespace {

using layout::Layout;

using Pieces = std::vector<std::uint32_t>;

// A piece that is left over, and how many others it could take the place of.
struct Swaps {
  std::size_t in{};
  std::size_t number{};
};

// A piece comes onto the strip, to where it overlaps least or to the place of another one, which comes off.
struct Trial {
  std::size_t in{};
  std::optional<std::size_t> out{};
};

class Filler {
 public:
  Filler(Filling start, const layout::PieceSet& set, const FillSettings& settings, const scene::Run& run)
      : set_{set},
        settings_{settings},
        run_{run},
        best_{std::move(start)},
        search_{set, settings.seed, settings.map_bytes, settings.search, [this] { return run_.stopped(); }},
        last_{*best_.marker.strip.last()} {
    best_.value = value_of(best_.lies, settings_.values);
    double widest = 0;
    for (const layout::Kind& kind : set.kinds) {
      for (const layout::Turned& turned : kind.turned) {
        widest = std::max({widest, turned.box.width(), turned.box.height()});
      }
    }
    apart_ = 3 * widest + 1;
    const double end = static_cast<double>(last_) / set_.lattice_units;
    for (const layout::Kind& kind : set.kinds) fits_.push_back(kind.fits_before(end));
  }

  Filling filled() {
    put_down(ordered([this](std::uint32_t i) { return set_.kind(i).hull_area; }));
    put_down(ordered([this](std::uint32_t i) { return settings_.values[i] / set_.kind(i).area; }));
    while (!over()) {
      const auto trial = drawn();
      if (!trial) break;
      attempt(*trial);
    }
    best_.moves = search_.moves();
    return std::move(best_);
  }

 private:
  [[nodiscard]] bool over() const { return settings_.over(search_.moves()); }

  void park(Layout& layout, std::size_t piece) const {
    layout::Place& place = layout.places[piece];
    const RealBox& box = set_.kind(piece).turned[place.turn].box;
    place.x = layout.length + apart_ * static_cast<double>(2 + piece) - box.low_x;
    place.y = -box.low_y;
  }

  // The best layout, on the whole strip.
  [[nodiscard]] Layout best_layout() const {
    Layout layout = to_layout(set_, best_.marker);
    layout.length = static_cast<double>(last_) / set_.lattice_units;
    for (std::size_t i = 0; i < set_.size(); ++i) {
      if (!best_.lies[i]) park(layout, i);
    }
    return layout;
  }

  // Pieces by falling measure of their kind and value; pieces of one measure keep their order.
  template <class Measure>
  [[nodiscard]] Pieces ordered(const Measure& measure) const {
    Pieces order(set_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&measure](std::uint32_t a, std::uint32_t b) { return measure(a) > measure(b); });
    return order;
  }

  // Puts all pieces down anew, in this order, each where it ends leftmost among those that lie already.
  void put_down(const Pieces& order) {
    if (over() || std::find(best_.lies.begin(), best_.lies.end(), false) == best_.lies.end()) return;
    Layout layout = best_layout();
    std::vector<bool> lies(set_.fixed.begin(), set_.fixed.end());
    Pieces down;
    for (std::uint32_t i = 0; i < set_.size(); ++i) {
      if (set_.fixed[i]) down.push_back(i);
      if (!set_.fixed[i]) park(layout, i);
    }
    std::set<std::uint32_t> hopeless;  // kinds: once one of them does not fit, none does
    for (const std::uint32_t piece : order) {
      if (over()) break;
      if (set_.fixed[piece] || hopeless.contains(set_.kind_of[piece])) continue;
      if (!search_.insert(layout, piece, down)) {
        hopeless.insert(set_.kind_of[piece]);
        continue;
      }
      down.push_back(piece);
      lies[piece] = true;
    }
    keep_what_is_apart(std::move(layout), std::move(lies), std::nullopt);
  }

  // Takes pieces off, but not the one that is spared, until the others are apart or worth no more than the best.
  void keep_what_is_apart(Layout layout, std::vector<bool> lies, std::optional<std::size_t> spared) {
    while (value_of(lies, settings_.values) > best_.value) {
      if (room_besides(lies) >= 0) {
        auto outcome = separated(layout);
        if (outcome.loss == 0) {
          (void)keep(outcome.layout, lies);
          return;
        }
        layout = std::move(outcome.layout);
      }
      const auto worst = search_.most_overlapping(layout, spared);
      if (!worst || over()) return;
      park(layout, *worst);
      lies[*worst] = false;
    }
  }

  // The area that pieces may cover, less that of the pieces that lie.
  [[nodiscard]] double room_besides(const std::vector<bool>& lies) const {
    double room = (static_cast<double>(last_) / set_.lattice_units - set_.left) * set_.across();
    if (settings_.room) room = std::min(room, *settings_.room / (set_.lattice_units * set_.lattice_units));
    for (std::size_t i = 0; i < set_.size(); ++i) room -= lies[i] && !set_.is_zone(i) ? set_.kind(i).area : 0;
    return room;
  }

  // A trial that the area allows and that may raise the value; pieces of one kind and value count once.
  [[nodiscard]] std::optional<Trial> drawn() {
    const double room = room_besides(best_.lies);
    std::vector<std::size_t> additions, wedgings;
    std::vector<Swaps> swaps;
    std::size_t all_swaps = 0;
    std::set<std::pair<std::uint32_t, double>> seen;
    for (std::size_t in = 0; in < set_.size(); ++in) {
      const double value = settings_.values[in];
      if (best_.lies[in] || value <= 0 || !fits_[set_.kind_of[in]]) continue;
      if (!seen.emplace(set_.kind_of[in], value).second) continue;
      const double area = set_.kind(in).area;
      if (area <= room) additions.push_back(in);
      Swaps own{in};
      bool above_any = false;
      for (std::size_t out = 0; out < set_.size(); ++out) {
        if (!is_worth_less(out, in)) continue;
        above_any = true;
        if (leaves_room(out, in, room)) ++own.number;
      }
      if (own.number > 0) swaps.push_back(own);
      all_swaps += own.number;
      if (above_any && (area > room || own.number > 0)) wedgings.push_back(in);
    }
    if (search_.dice().unit() < settings_.tuning.added && !additions.empty()) return one_of(additions);
    if (search_.dice().unit() < settings_.tuning.swapped && all_swaps > 0) return one_of(swaps, all_swaps, room);
    if (!wedgings.empty()) return one_of(wedgings);
    if (all_swaps > 0) return one_of(swaps, all_swaps, room);
    if (!additions.empty()) return one_of(additions);
    return std::nullopt;
  }
  [[nodiscard]] bool is_worth_less(std::size_t out, std::size_t in) const {
    return best_.lies[out] && !set_.fixed[out] && settings_.values[out] < settings_.values[in];
  }
  [[nodiscard]] bool leaves_room(std::size_t out, std::size_t in, double room) const {
    return set_.kind(in).area - set_.kind(out).area <= room;
  }
  [[nodiscard]] Trial one_of(const std::vector<std::size_t>& pieces) {
    return {pieces[search_.dice().below(pieces.size())]};
  }
  // Every swap is equally likely.
  [[nodiscard]] Trial one_of(const std::vector<Swaps>& swaps, std::size_t number, double room) {
    std::size_t k = search_.dice().below(number);
    auto of = swaps.begin();
    for (; k >= of->number; ++of) k -= of->number;
    std::size_t out = 0;
    for (;; ++out) {
      if (is_worth_less(out, of->in) && leaves_room(out, of->in, room) && k-- == 0) return {of->in, out};
    }
  }

  void attempt(const Trial& trial) {
    Layout layout = best_layout();
    std::vector<bool> lies = best_.lies;
    lies[trial.in] = true;
    if (trial.out) {
      const RealBox box = placed_box(set_, layout, *trial.out);
      park(layout, *trial.out);
      lies[*trial.out] = false;
      centre_at(set_, layout, trial.in, box.middle_x(), box.middle_y());
    } else {
      const double x = search_.dice().unit() * layout.length;
      centre_at(set_, layout, trial.in, x, search_.dice().unit() * set_.high);
      search_.settle(layout, trial.in);
    }
    keep_what_is_apart(std::move(layout), std::move(lies), trial.in);
  }

  [[nodiscard]] local_search::GuidedSearch::Outcome separated(Layout layout) {
    return search_.separate(std::move(layout), {settings_.tuning.patience, 1}, [this] { return over(); });
  }

  // Makes a valid marker of the pieces that lie; false when that fails or they reach beyond the strip.
  bool keep(const Layout& layout, const std::vector<bool>& lies) {
    Marker lying = with_lying_pieces(to_marker(set_, layout, best_.marker), lies);
    lying.strip = lying.strip.ending(std::nullopt);
    const auto done = proved(lying, {.separation_rounds = settings_.tuning.separation_rounds}, run_);
    if (!done) return false;
    best_.programs += done->programs;
    if (done->length_after > last_) return false;
    std::size_t next = 0;
    for (std::size_t i = 0; i < lies.size(); ++i) {
      if (lies[i]) best_.marker.pieces[i] = done->marker.pieces[next++];
    }
    best_.lies = lies;
    best_.value = value_of(lies, settings_.values);
    return true;
  }

  const layout::PieceSet& set_;
  const FillSettings& settings_;
  const scene::Run& run_;
  Filling best_;
  local_search::GuidedSearch search_;
  Coord last_;
  double apart_{};          // between parked pieces
  std::vector<bool> fits_;  // by kind: some orientation fits the strip
};

}  // namespace

double value_of(const std::vector<bool>& lies, const std::vector<double>& values) {
  double value = 0;
  for (std::size_t i = 0; i < lies.size(); ++i) value += lies[i] ? values[i] : 0;
  return value;
}

Filling fill(Filling start, const layout::PieceSet& set, const FillSettings& settings, const scene::Run& run) {
  if (settings.over(0)) {  // without a search to prepare
    start.value = value_of(start.lies, settings.values);
    return start;
  }
  return Filler{std::move(start), set, settings, run}.filled();
}

}  // namespace selvage::nesting::filling
