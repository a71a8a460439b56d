// The laws of dissections on graphs whose best dissection is known, and on random ones.
#include "core/lp/elimination/dissection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "tests/support/random.h"

namespace selvage::lp::elimination {
namespace {

void add_net(Nets& nets, std::initializer_list<int> vertices) {
  nets.vertex.insert(nets.vertex.end(), vertices);
  nets.start.push_back(static_cast<int>(nets.vertex.size()));
}

Nets isolated(int vertices) {
  Nets nets;
  nets.vertices = vertices;
  return nets;
}
Nets path(int vertices) {
  Nets nets = isolated(vertices);
  for (int v = 0; v + 1 < vertices; ++v) add_net(nets, {v, v + 1});
  return nets;
}
Nets grid(int along, int across) {
  Nets nets = isolated(along * across);
  for (int v = 0; v < nets.vertices; ++v) {
    if (v % across + 1 < across) add_net(nets, {v, v + 1});
    if (v + across < nets.vertices) add_net(nets, {v, v + across});
  }
  return nets;
}
// The vertices under other names.
Nets shuffled(const Nets& nets, test::Random& random) {
  std::vector<int> name(static_cast<std::size_t>(nets.vertices));
  for (std::size_t v = 0; v < name.size(); ++v) {
    name[v] = static_cast<int>(v);
    std::swap(name[v], name[static_cast<std::size_t>(random.between(0, static_cast<Coord>(v)))]);
  }
  Nets named = nets;
  for (int& v : named.vertex) v = name[static_cast<std::size_t>(v)];
  return named;
}

int size_of(const Dissection& divided, int domain) {
  return static_cast<int>(std::ranges::count(divided.domain_of, domain));
}

void expect_laws(const Nets& nets, const Dissection& divided) {
  ASSERT_EQ(divided.domain_of.size(), static_cast<std::size_t>(nets.vertices));
  for (int k = 0; k < nets.count(); ++k) {
    int domain = Dissection::kBorder;
    for (int i = nets.start[static_cast<std::size_t>(k)]; i < nets.start[static_cast<std::size_t>(k) + 1]; ++i) {
      const int v = nets.vertex[static_cast<std::size_t>(i)];
      const int own = divided.domain_of[static_cast<std::size_t>(v)];
      if (own == Dissection::kBorder) continue;
      EXPECT_TRUE(domain == Dissection::kBorder || domain == own) << "net " << k;
      domain = own;
    }
  }
  EXPECT_LE(size_of(divided, Dissection::kBorder), Dissection::kMostBorder * nets.vertices);
  for (int domain = 0; domain < divided.domains; ++domain) {
    EXPECT_GE(size_of(divided, domain), 1);
    EXPECT_LE(size_of(divided, domain), (1 + Dissection::kMostExcess) * nets.vertices / divided.domains);
  }
}

TEST(Dissection, CutsAPathAtSingleVertices) {
  test::Random random{1};
  for (const Nets& nets : {path(100), shuffled(path(100), random)}) {
    for (const int domains : {2, 3, 8}) {
      const Dissection divided = dissection(nets, domains);
      EXPECT_EQ(divided.domains, domains);
      EXPECT_EQ(size_of(divided, Dissection::kBorder), domains - 1);
      expect_laws(nets, divided);
    }
  }
}

TEST(Dissection, CutsALongGridAcross) {
  test::Random random{2};
  for (const Nets& nets : {grid(200, 7), shuffled(grid(200, 7), random)}) {
    const Dissection divided = dissection(nets, 4);
    EXPECT_EQ(divided.domains, 4);
    EXPECT_EQ(size_of(divided, Dissection::kBorder), 3 * 7);
    expect_laws(nets, divided);
  }
}

TEST(Dissection, PutsTheHubOfAStarOnTheBorder) {
  constexpr int kLeaves = 2000;
  Nets nets = isolated(kLeaves + 1);
  for (int v = 0; v < kLeaves; ++v) add_net(nets, {v, kLeaves});
  const Dissection divided = dissection(nets, 4);
  EXPECT_EQ(divided.domains, 4);
  EXPECT_EQ(divided.domain_of.back(), Dissection::kBorder);
  EXPECT_EQ(size_of(divided, Dissection::kBorder), 1);
  expect_laws(nets, divided);
}

TEST(Dissection, CutsBetweenComponents) {
  Nets nets = isolated(400);  // 40 paths
  for (int v = 0; v + 1 < nets.vertices; ++v) {
    if (v % 10 != 9) add_net(nets, {v, v + 1});
  }
  const Dissection divided = dissection(nets, 5);
  EXPECT_EQ(divided.domains, 5);
  EXPECT_EQ(size_of(divided, Dissection::kBorder), 0);
  expect_laws(nets, divided);
}

TEST(Dissection, DoesNotDivideWhatCannotBeCut) {
  EXPECT_EQ(dissection({}, 4).domains, 1);
  EXPECT_EQ(dissection(path(100), 1).domains, 1);
  EXPECT_EQ(dissection(path(3), 4).domains, 1);
  EXPECT_EQ(dissection(grid(20, 20), 16).domains, 1);  // the border would be too large
  Nets all = isolated(1000);
  for (int v = 0; v < all.vertices; ++v) all.vertex.push_back(v);
  all.start.push_back(all.vertices);
  const Dissection divided = dissection(all, 2);
  EXPECT_EQ(divided.domains, 1);
  expect_laws(all, divided);
}

TEST(Dissection, KeepsItsLawsOnRandomStrips) {
  test::Random random{3};
  int divided_at_all = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Nets nets = isolated(static_cast<int>(random.between(1, 600)));
    const Coord reach = random.between(1, 20);
    for (Coord k = random.between(0, 4 * nets.vertices); k > 0; --k) {
      const auto first = static_cast<int>(random.between(0, nets.vertices - 1));
      std::vector<int> net{first};
      for (int v = first + static_cast<int>(random.between(1, reach)); v < nets.vertices && net.size() < 4;
           v += static_cast<int>(random.between(1, reach))) {
        net.push_back(v);
      }
      nets.vertex.insert(nets.vertex.end(), net.begin(), net.end());
      nets.start.push_back(static_cast<int>(nets.vertex.size()));
    }
    const Nets named = shuffled(nets, random);
    const Dissection divided = dissection(named, static_cast<int>(random.between(1, 6)));
    divided_at_all += divided.domains > 1 ? 1 : 0;
    expect_laws(named, divided);
  }
  EXPECT_GT(divided_at_all, 100);
}

}  // namespace
}  // namespace selvage::lp::elimination
