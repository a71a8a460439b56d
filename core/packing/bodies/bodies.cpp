#include "core/packing/bodies/bodies.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/marker/clearance.h"
#include "core/marker/validity.h"
#include "core/model/ties.h"
#include "core/packing/bodies/range_by_rules.h"
#include "core/packing/bodies/spaced_rings.h"
#include "core/packing/lines/chords.h"

namespace selvage::packing::bodies {
namespace {

using branching::Chosen;

// One piece in one orientation.
struct Figure {
  outline::OrientedOutline outline;
  Polygon polygon;  // oriented
  Box box;
  outline::OrientedOutline part{};  // the part that accepts less of the cloth's quality, if the piece has one
  Polygon part_polygon{};
};

Figure figure_of(Marker& scratch, std::uint32_t piece, const Orientation& orientation, const scene::Run& run) {
  scratch.pieces[piece].orientation = orientation;
  Polygon polygon = oriented(scratch.shapes[scratch.pieces[piece].shape.value].outline, orientation);
  const Box box = box_of(polygon);
  const Piece& turned = scratch.pieces[piece];
  Figure figure{marker::oriented_outline(scratch, PieceId{piece}, run.sums), std::move(polygon), box};
  if (turned.rules.part) figure.part = marker::oriented_part(turned, run.sums);
  figure.part_polygon = turned_part(turned);
  return figure;
}

Figure figure_of(const Polygon& wall, const scene::Run& run) {
  Figure figure;
  figure.outline.outline = run.sums.outline(wall);
  figure.polygon = wall;
  figure.box = box_of(wall);
  return figure;
}

// Outline and part with the low corner of the outline's box at the origin: equal for equal outlines with equal parts.
std::pair<Polygon, Polygon> normal_form(const Figure& figure) {
  return {geometry::normal_form(figure.polygon, -figure.box.low),
          geometry::normal_form(figure.part_polygon, -figure.box.low)};
}

// Whether the box has more room to move across the strip than along it, relative to its own size.
bool has_more_room_across(const Box& range, const Box& box) {
  const auto real = [](Coord coord) { return static_cast<double>(coord); };
  return real(range.height()) * real(box.width()) > real(range.width()) * real(box.height());
}

// A body being made: its pieces' figures in every variant.
struct Draft {
  std::vector<std::uint32_t> pieces;
  std::vector<std::vector<Figure>> figures;  // by variant
  std::vector<Box> ranges;                   // of the body's position, by variant
  bool alone{};                              // one piece, free on both axes
};

void add_free_cells(branching::Problem& problem) {
  for (std::uint32_t body = 0; body < problem.bodies.size(); ++body) {
    auto& cells = problem.free_cells.emplace_back(problem.bodies[body].variants.size());
    for (std::uint32_t variant = 0; variant < cells.size(); ++variant) {
      const auto fixed = problem.between.find({{problem.world(), 0}, {body, variant}});
      if (fixed == problem.between.end()) continue;
      cells[variant].emplace(problem.bodies[body].variants[variant].range);
      for (const std::uint32_t ring : fixed->second) cells[variant]->exclude(problem.rings[ring]);
    }
  }
}

class BodyMaker {
 public:
  BodyMaker(const Marker& marker, const Freedom& freedom, const scene::Run& run)
      : marker_{marker},
        scratch_{marker},
        freedom_{freedom},
        run_{run},
        ties_{model::ties_of(marker)},
        placed_{marker} {}

  Bodies make() {
    for (std::uint32_t piece = 0; piece < marker_.pieces.size(); ++piece) sort_in(piece);
    bodies_.complete = drafts_.size() <= kMostBodies;
    if (!bodies_.complete) return std::move(bodies_);
    for (Draft& draft : drafts_) add_variants(draft);
    for (const Draft& draft : drafts_) add_body(draft);
    set_kinds();
    add_rings();
    add_free_cells(bodies_.problem);
    add_lines();
    return std::move(bodies_);
  }

 private:
  void sort_in(std::uint32_t piece) {
    if (!freedom_.moving[piece] || ties_.fixed(piece)) {
      fixed_.push_back(piece);
      return;
    }
    for (Draft& draft : drafts_) {
      if (!ties_.joined(draft.pieces.front(), piece)) continue;
      draft.pieces.push_back(piece);
      draft.alone = false;
      return;
    }
    drafts_.push_back({{piece}, {}, {}, ties_.free(piece)});
  }

  void add_variants(Draft& draft) {
    std::vector<Figure> present;
    for (const std::uint32_t piece : draft.pieces) {
      present.push_back(figure_of(scratch_, piece, marker_.pieces[piece].orientation, run_));
    }
    const std::uint32_t piece = draft.pieces.front();
    const Piece& first = marker_.pieces[piece];
    const Shape& shape = marker_.shapes[first.shape.value];
    layouts_.emplace_back();
    if (!freedom_.turns || !draft.alone || first.locked.tilt || shape.rotations.empty()) {
      add_variant(draft, std::move(present));
      return;
    }
    for (const bool flip : {false, true}) {
      if (flip && !shape.may_flip) break;
      for (const Angle rotation : shape.rotations) {
        add_variant(draft, {figure_of(scratch_, piece, {flip, rotation, first.orientation.tilt}, run_)});
      }
    }
    scratch_.pieces[piece].orientation = first.orientation;
  }

  // Adds the variant unless it has the same outline as one before, or fits the room nowhere.
  void add_variant(Draft& draft, std::vector<Figure> figures) {
    if (figures.size() == 1) {
      const auto normal = normal_form(figures.front());
      for (const auto& known : draft.figures) {
        if (normal_form(known.front()) == normal) return;
      }
    }
    BodyLayout layout;
    std::optional<Box> box;
    for (std::size_t k = 0; k < figures.size(); ++k) {
      const Vec at = figures.size() == 1 ? Vec{} : marker_.pieces[draft.pieces[k]].at;
      const Box own = figures[k].box.moved(at);
      box = box ? united(*box, own) : own;
      layout.orientations.push_back(scratch_.pieces[draft.pieces[k]].orientation);
      layout.offsets.push_back(at);
    }
    for (Vec& offset : layout.offsets) offset = offset - box->low;
    const Vec size = box->high - box->low;
    Box range{freedom_.container.box.low, freedom_.container.box.high - size};
    for (std::size_t k = 0; k < figures.size(); ++k) {
      const Box own = figures[k].box.moved(layout.offsets[k]);
      const auto by_rules = range_by_rules(scratch_, placed_, freedom_, draft.pieces[k], own);
      if (!by_rules) return;
      range.low = {std::max(range.low.x, by_rules->low.x), std::max(range.low.y, by_rules->low.y)};
      range.high = {std::min(range.high.x, by_rules->high.x), std::min(range.high.y, by_rules->high.y)};
    }
    if (range.width() < 0 || range.height() < 0) return;
    draft.ranges.push_back(range);
    draft.figures.push_back(std::move(figures));
    layouts_.back().push_back(std::move(layout));
  }

  void add_body(const Draft& draft) {
    const std::size_t number = bodies_.problem.bodies.size();
    const std::uint32_t piece = draft.pieces.front();
    branching::Body body;
    for (std::size_t v = 0; v < draft.figures.size(); ++v) {
      const BodyLayout& layout = layouts_[number][v];
      std::optional<Box> box;
      for (std::size_t k = 0; k < layout.offsets.size(); ++k) {
        const Box own = draft.figures[v][k].box.moved(layout.offsets[k]);
        box = box ? united(*box, own) : own;
      }
      Box range = draft.ranges[v];
      const Vec now = marker_.pieces[piece].at - layout.offsets.front();
      if (ties_.x[piece] == model::Ties::kFixed) range.low.x = range.high.x = now.x;
      if (ties_.y[piece] == model::Ties::kFixed) range.low.y = range.high.y = now.y;
      const RealVec low = geometry::real(range.low);
      const RealVec high = geometry::real(range.high);
      body.variants.push_back({{low.x, low.y, high.x, high.y},
                               static_cast<double>(box->width()),
                               has_more_room_across(draft.ranges[v], *box)});
    }
    if (!draft.figures.empty()) {
      for (const Figure& figure : draft.figures.front()) body.area += geometry::area_of(figure.polygon);
    }
    bodies_.problem.bodies.push_back(std::move(body));
    bodies_.pieces.push_back(draft.pieces);
    bodies_.layouts.push_back(layouts_[number]);
  }

  [[nodiscard]] bool alike(const Draft& a, const Draft& b) const {
    if (!a.alone || !b.alone || a.figures.size() != b.figures.size()) return false;
    const Piece& first = marker_.pieces[a.pieces.front()];
    const Piece& second = marker_.pieces[b.pieces.front()];
    if (first.buffer != second.buffer || first.rules != second.rules) return false;
    for (std::size_t v = 0; v < a.figures.size(); ++v) {
      if (normal_form(a.figures[v].front()) != normal_form(b.figures[v].front())) return false;
    }
    return true;
  }

  void set_kinds() {
    for (std::uint32_t k = 0; k < drafts_.size(); ++k) {
      std::uint32_t first = 0;
      while (first < k && !alike(drafts_[first], drafts_[k])) ++first;
      bodies_.problem.bodies[k].kind = first;
    }
  }

  void add_rings() {
    const auto count = static_cast<std::uint32_t>(drafts_.size());
    for (const Polygon& wall : freedom_.container.walls) {
      const Figure figure = figure_of(wall, run_);
      for (std::uint32_t body = 0; body < count; ++body) {
        for_each_variant(body, [&](const Chosen& chosen) {
          add_rings_of({count, 0}, figure, {}, chosen, std::nullopt);
        });
      }
    }
    for (const std::uint32_t piece : fixed_) {
      const Figure figure = figure_of(scratch_, piece, marker_.pieces[piece].orientation, run_);
      for (std::uint32_t body = 0; body < count; ++body) {
        for_each_variant(body, [&](const Chosen& chosen) {
          add_rings_of({count, 0}, figure, marker_.pieces[piece].at, chosen, piece);
        });
      }
    }
    for (std::uint32_t first = 0; first < count; ++first) {
      for (std::uint32_t second = first + 1; second < count; ++second) {
        for_each_variant(first, [&](const Chosen& own) {
          for_each_variant(second, [&](const Chosen& other) { add_rings_between(own, other); });
        });
      }
    }
  }

  // Whether no part of the two pieces may lie on a part of the other.
  [[nodiscard]] bool keep_apart(std::uint32_t a, std::uint32_t b) const {
    return !placed_.may_share_cloth(a, b) && !placed_.shows_part(a, b) && !placed_.shows_part(b, a);
  }
  [[nodiscard]] bool keep_apart(std::uint32_t piece, const Draft& draft) const {
    return std::ranges::all_of(draft.pieces, [&](std::uint32_t own) { return keep_apart(piece, own); });
  }

  // The outlines of the walls, and of the fixed pieces that no body may lie on.
  [[nodiscard]] std::vector<Polygon> obstacles() const {
    std::vector<Polygon> obstacles = freedom_.container.walls;
    for (const std::uint32_t piece : fixed_) {
      if (!std::ranges::all_of(drafts_, [&](const Draft& draft) { return keep_apart(piece, draft); })) continue;
      const geometry::PlacedPolygon own = placed_[piece];
      obstacles.emplace_back(own.vertices.begin(), own.vertices.end());
      for (Vec& corner : obstacles.back()) corner = corner + own.at;
    }
    return obstacles;
  }

  void add_lines() {
    std::vector<std::vector<std::vector<Polygon>>> figures(drafts_.size());
    for (std::size_t body = 0; body < drafts_.size(); ++body) {
      const Draft& draft = drafts_[body];
      if (draft.figures.empty()) return;
      for (std::size_t other = 0; other < body; ++other) {
        const auto apart = [&](std::uint32_t piece) { return keep_apart(piece, drafts_[other]); };
        if (!std::ranges::all_of(draft.pieces, apart)) return;
      }
      for (std::size_t v = 0; v < draft.figures.size(); ++v) {
        figures[body].emplace_back();
        for (std::size_t k = 0; k < draft.pieces.size(); ++k) {
          Polygon polygon = draft.figures[v][k].polygon;
          for (Vec& corner : polygon) corner = corner + layouts_[body][v].offsets[k];
          figures[body].back().push_back(std::move(polygon));
        }
      }
    }
    const std::vector<Polygon> fixed = obstacles();
    const Box& room = freedom_.container.box;
    bodies_.problem.lines = {lines_across(lines::Crossing::kX, room, fixed, figures),
                             lines_across(lines::Crossing::kY, room, fixed, figures)};
  }

  template <class Visit>
  void for_each_variant(std::uint32_t body, const Visit& visit) {
    for (std::uint32_t v = 0; v < drafts_[body].figures.size(); ++v) visit(Chosen{body, v});
  }

  void add_rings_between(const Chosen& first, const Chosen& second) {
    const Draft& draft = drafts_[first.body];
    for (std::size_t k = 0; k < draft.pieces.size(); ++k) {
      add_rings_of(first, draft.figures[first.variant][k], bodies_.layouts[first.body][first.variant].offsets[k],
                   second, draft.pieces[k]);
    }
  }

  // The rings of one figure of the first body, at `at` from the body, with all pieces of the second.  The figure is
  // that of a piece, or else of a wall.
  void add_rings_of(const Chosen& first, const Figure& figure, Vec at, const Chosen& second,
                    std::optional<std::uint32_t> piece) {
    const Draft& draft = drafts_[second.body];
    for (std::size_t k = 0; k < draft.pieces.size(); ++k) {
      bodies_.complete = bodies_.complete && wedges_ <= kMostWedges && !run_.stopped();
      if (!bodies_.complete) return;
      if (piece && placed_.may_share_cloth(*piece, draft.pieces[k])) continue;
      const Figure& other = draft.figures[second.variant][k];
      const Vec offset = at - bodies_.layouts[second.body][second.variant].offsets[k];
      const Coord spacing = piece ? placed_.spacing(std::minmax(*piece, draft.pieces[k])) : freedom_.clearance;
      if (first.body == drafts_.size() && !may_meet(figure.box.moved(at).grown(spacing), second, k)) continue;
      const bool by_part = piece && placed_.shows_part(draft.pieces[k], *piece);
      const outline::OrientedOutline& met = by_part ? other.part : other.outline;
      auto rings = spaced_rings(figure.outline, met, spacing, offset, run_.sums, run_.stop);
      bodies_.complete = rings.has_value();
      if (!rings) return;
      for (cells::WedgeRing& ring : *rings) {
        if (first.body == drafts_.size() && !reaches(second, ring)) continue;
        bodies_.problem.between[{first, second}].push_back(static_cast<std::uint32_t>(bodies_.problem.rings.size()));
        wedges_ += ring.size();
        bodies_.problem.rings.push_back(std::move(ring));
      }
    }
  }

  // Whether the body's piece k reaches the box from some position of the body.
  [[nodiscard]] bool may_meet(const Box& box, const Chosen& body, std::size_t k) const {
    const RealBox& range = bodies_.problem.bodies[body.body].variants[body.variant].range;
    const Vec offset = bodies_.layouts[body.body][body.variant].offsets[k];
    const Box own = drafts_[body.body].figures[body.variant][k].box.moved(offset);
    const auto real = [](Coord coord) { return static_cast<double>(coord); };
    return real(box.low.x) < range.high_x + real(own.high.x) && range.low_x + real(own.low.x) < real(box.high.x) &&
           real(box.low.y) < range.high_y + real(own.high.y) && range.low_y + real(own.low.y) < real(box.high.y);
  }

  // Whether the ring of a fixed piece meets the positions of the body at all.
  [[nodiscard]] bool reaches(const Chosen& body, const cells::WedgeRing& ring) const {
    const RealBox& range = bodies_.problem.bodies[body.body].variants[body.variant].range;
    const RealBox& box = ring.box();
    return box.low_x < range.high_x + cells::kRaySlack && range.low_x < box.high_x + cells::kRaySlack &&
           box.low_y < range.high_y + cells::kRaySlack && range.low_y < box.high_y + cells::kRaySlack;
  }

  const Marker& marker_;
  Marker scratch_;
  const Freedom& freedom_;
  const scene::Run& run_;
  model::Ties ties_;
  marker::PlacedPieces placed_;
  std::vector<Draft> drafts_;
  std::vector<std::uint32_t> fixed_;
  std::vector<std::vector<BodyLayout>> layouts_;
  std::size_t wedges_{};
  Bodies bodies_;
};

}  // namespace

Bodies bodies_of(const Marker& marker, const Freedom& freedom, const scene::Run& run) {
  return BodyMaker{marker, freedom, run}.make();
}

Marker placed(const Marker& marker, const Bodies& bodies, const branching::Leaf& leaf) {
  Marker result = marker;
  for (std::size_t body = 0; body < bodies.pieces.size(); ++body) {
    const BodyLayout& layout = bodies.layouts[body][leaf.variant[body]];
    const Vec at{std::llround(leaf.positions[body].x), std::llround(leaf.positions[body].y)};
    for (std::size_t k = 0; k < bodies.pieces[body].size(); ++k) {
      Piece& piece = result.pieces[bodies.pieces[body][k]];
      piece.orientation = layout.orientations[k];
      piece.at = at + layout.offsets[k];
    }
  }
  return result;
}

bool lies_inside(const Marker& marker, const marker::PlacedPieces& pieces, std::uint32_t piece,
                 const Freedom& freedom) {
  const Box box = pieces.box(piece);
  if (!freedom.container.box.contains(box) || protrusion_of(pieces, piece, marker.strip) > 0) return false;
  const Coord clearance = marker.pieces[piece].rules.on_fold ? 0 : freedom.clearance;
  if (clearance > 0 && !pieces.room(piece, marker.strip, kLatticeLimit).grown(-clearance).contains(box)) return false;
  return std::ranges::none_of(freedom.container.walls, [&](const Polygon& wall) {
    return marker::collide(pieces[piece], {wall, box_of(wall), {}}, freedom.clearance);
  });
}

}  // namespace selvage::packing::bodies
