#include "protocol/drawing/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <tuple>

namespace selvage::protocol::drawing {
namespace {

struct Colour {
  int red{}, green{}, blue{};
};

// Muted colours of nearly the same lightness, different enough that neighbours can be distinguished.
constexpr std::array<Colour, 12> kPalette{{{142, 172, 201},
                                           {226, 184, 142},
                                           {156, 190, 152},
                                           {213, 158, 160},
                                           {184, 166, 205},
                                           {229, 211, 140},
                                           {136, 190, 190},
                                           {205, 176, 152},
                                           {178, 193, 222},
                                           {190, 200, 140},
                                           {222, 178, 205},
                                           {168, 178, 178}}};

std::string text_of(Colour c, double shade) {
  const auto part = [&](int value) {
    return static_cast<unsigned>(std::lround(static_cast<double>(value) * shade)) & 0xffU;
  };
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", part(c.red), part(c.green), part(c.blue));
  return text.data();
}

// Shapes of one area, vertex count and boundary length: copies and mirror images of each other.
struct Families {
  std::vector<std::size_t> of_shape;
  std::vector<std::size_t> rank;  // of a shape within its family
  std::size_t count{};
};

Families families_of(const Marker& marker) {
  using Key = std::tuple<std::size_t, Wide, Wide>;
  std::map<Key, std::size_t> number;
  std::vector<std::size_t> members;
  Families families;
  for (const Shape& shape : marker.shapes) {
    Wide lengths = 0;
    for (std::size_t i = 0; i < shape.outline.size(); ++i) {
      const Vec edge = shape.outline[(i + 1) % shape.outline.size()] - shape.outline[i];
      lengths += dot(edge, edge);
    }
    const auto [at, fresh] =
        number.try_emplace({shape.outline.size(), doubled_area(shape.outline), lengths}, members.size());
    if (fresh) members.push_back(0);
    families.of_shape.push_back(at->second);
    families.rank.push_back(members[at->second]++);
  }
  families.count = members.size();
  return families;
}

using Weights = std::vector<std::map<std::size_t, int>>;  // per family, others: pairs of pieces side by side

Weights neighbourhood(const Marker& marker, const std::vector<Polygon>& placed, const Families& families) {
  Weights weights(families.count);
  const Coord reach = marker.strip.width / 100;
  std::vector<Box> boxes;
  boxes.reserve(placed.size());
  for (const Polygon& outline : placed) boxes.push_back(box_of(outline).grown(reach));
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return boxes[a].low.x < boxes[b].low.x; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (std::size_t m = k + 1; m < order.size() && boxes[order[m]].low.x <= boxes[order[k]].high.x; ++m) {
      if (!boxes[order[k]].touches(boxes[order[m]])) continue;
      const std::size_t a = families.of_shape[marker.pieces[order[k]].shape.value];
      const std::size_t b = families.of_shape[marker.pieces[order[m]].shape.value];
      if (a == b) continue;
      ++weights[a][b];
      ++weights[b][a];
    }
  }
  return weights;
}

// Gives each family the colour that occurs least among its neighbours; of several, the one used least so far.
std::vector<std::size_t> choose_colours(const Weights& weights) {
  std::vector<std::size_t> chosen;
  std::array<int, kPalette.size()> used{};
  for (std::size_t family = 0; family < weights.size(); ++family) {
    std::array<int, kPalette.size()> clash{};
    for (const auto& [other, pairs] : weights[family]) {
      if (other < family) clash[chosen[other]] += pairs;
    }
    std::size_t best = 0;
    for (std::size_t colour = 1; colour < kPalette.size(); ++colour) {
      if (std::pair{clash[colour], used[colour]} < std::pair{clash[best], used[best]}) best = colour;
    }
    ++used[best];
    chosen.push_back(best);
  }
  return chosen;
}

}  // namespace

std::vector<std::string> shape_colours(const Marker& marker, const std::vector<Polygon>& placed) {
  constexpr double kMirrored = 0.9;  // the second of a family, usually the mirror image, is a shade darker
  const Families families = families_of(marker);
  const auto chosen = choose_colours(neighbourhood(marker, placed, families));
  std::vector<std::string> colours;
  for (std::size_t shape = 0; shape < marker.shapes.size(); ++shape) {
    const double shade = families.rank[shape] % 2 == 1 ? kMirrored : 1.0;
    colours.push_back(text_of(kPalette[chosen[families.of_shape[shape]]], shade));
  }
  return colours;
}

}  // namespace selvage::protocol::drawing
