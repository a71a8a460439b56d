#include "core/model/active_set.h"

#include <algorithm>
#include <utility>

namespace selvage::model {
namespace {

constexpr double kDualResidual = 1e-6;  // a fraction of the price: dual values may be off by this

// The force on all pieces of one tie along one axis, and how far they can move.
struct TieLoad {
  double load{};
  Coord down{kLatticeLimit}, up{kLatticeLimit};
};

bool moves(const TieLoad& tie, double price) {
  const double most = price * (1 + kDualResidual);
  return (tie.load > most && tie.up > 0) || (tie.load < -most && tie.down > 0);
}

}  // namespace

ActiveSet::ActiveSet(Ties ties, std::size_t growth) : ties_{std::move(ties)}, growth_{growth}, active_(ties_.x.size()) {
  for (std::size_t i = 0; i < active_.size(); ++i) left_ += ties_.fixed(i) ? 0 : 1;
}

void ActiveSet::add(std::size_t piece) {
  if (!may_hold(piece)) return;
  std::vector<std::size_t> entering{piece};
  active_[piece] = 1;
  while (!entering.empty()) {
    const std::size_t entered = entering.back();
    entering.pop_back();
    --left_;
    ++count_;
    for (std::size_t i = 0; i < active_.size(); ++i) {
      const bool tied = (ties_.x[i] == ties_.x[entered] && ties_.x[i] != Ties::kFixed) ||
                        (ties_.y[i] == ties_.y[entered] && ties_.y[i] != Ties::kFixed);
      if (!tied || holds(i)) continue;
      active_[i] = 1;
      entering.push_back(i);
    }
  }
}

void ActiveSet::add_all() {
  for (std::size_t i = 0; i < active_.size(); ++i) active_[i] = ties_.fixed(i) ? 0 : 1;
  count_ += left_;
  left_ = 0;
}

void ActiveSet::grow(std::vector<std::uint32_t> missed, std::span<const marker::PiecePair> neighbours) {
  const std::size_t enough = growth_ * count_;
  while (!missed.empty()) {
    std::vector<char> ring(active_.size());
    for (const std::uint32_t piece : missed) {
      add(piece);
      ring[piece] = 1;
    }
    if (count_ >= enough) return;
    missed.clear();
    for (const auto& [p, q] : neighbours) {
      if (ring[p] != 0 && may_hold(q)) missed.push_back(q);
      if (ring[q] != 0 && may_hold(p)) missed.push_back(p);
    }
  }
}

void ActiveSet::join(std::size_t p, std::size_t q) {
  const bool either = holds_any({static_cast<std::uint32_t>(p), static_cast<std::uint32_t>(q)});
  ties_.join(p, q);
  active_[p] = active_[q] = 0;
  count_ = left_ = 0;
  for (std::size_t i = 0; i < active_.size(); ++i) {
    if (ties_.fixed(i)) {
      active_[i] = 0;
    } else {
      ++(holds(i) ? count_ : left_);
    }
  }
  if (either) add(p);
}

Ties ActiveSet::with_others_fixed() const {
  Ties ties = ties_;
  for (std::size_t i = 0; i < active_.size(); ++i) {
    if (!holds(i)) ties.x[i] = ties.y[i] = Ties::kFixed;
  }
  return ties;
}

std::vector<std::uint32_t> ActiveSet::missed(const marker::PlacedPieces& pieces, const std::vector<RealVec>& load,
                                             double price, const Strip& strip, Coord end) const {
  if (complete()) return {};
  std::vector<TieLoad> x(pieces.size()), y(pieces.size());  // by tie
  const auto add_load = [](TieLoad& tie, double more, Coord down, Coord up) {
    tie = {tie.load + more, std::min(tie.down, down), std::min(tie.up, up)};
  };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (holds(i)) continue;
    const Box box = pieces.box(i);
    const Box room = pieces.room(i, strip, end);
    if (ties_.x[i] != Ties::kFixed) {
      add_load(x[ties_.x[i]], load[i].x, box.low.x - room.low.x, room.high.x - box.high.x);
    }
    if (ties_.y[i] != Ties::kFixed) {
      add_load(y[ties_.y[i]], load[i].y, box.low.y - room.low.y, room.high.y - box.high.y);
    }
  }
  std::vector<std::uint32_t> missed;
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    if (holds(i)) continue;
    const bool along = ties_.x[i] != Ties::kFixed && moves(x[ties_.x[i]], price);
    const bool across = ties_.y[i] != Ties::kFixed && moves(y[ties_.y[i]], price);
    if (along || across) missed.push_back(i);
  }
  return missed;
}

void Pressure::add(const PairRow& row, double dual) {
  const auto& [p, q] = row.pair;
  load_[q] = {load_[q].x + dual * row.nx, load_[q].y + dual * row.ny};
  load_[p] = {load_[p].x - dual * row.nx, load_[p].y - dual * row.ny};
}

void Pressure::add_shades(const PositionModel& model, std::span<const double> dual) {
  for (const ShadeRow& row : model.shade_rows()) {
    const auto r = static_cast<std::size_t>(row.in_program);
    if (r < dual.size()) load_[row.piece].x += dual[r] * row.nx;
  }
}

}  // namespace selvage::model
