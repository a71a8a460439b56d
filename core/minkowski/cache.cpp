#include "core/minkowski/cache.h"

#include <iterator>
#include <list>
#include <mutex>
#include <unordered_map>

#include "core/outline/outward.h"

namespace selvage::minkowski {
namespace {

// Relative orientation and the outlines themselves: equal keys have equal sums.
struct Key {
  std::shared_ptr<const outline::Outline> p, q;
  Symmetry relative;

  friend bool operator==(const Key& a, const Key& b) {
    const auto same = [](const auto& x, const auto& y) {
      return x == y || (x->hash == y->hash && x->polygon == y->polygon);
    };
    return a.relative == b.relative && same(a.p, b.p) && same(a.q, b.q);
  }
};
struct KeyHash {
  std::size_t operator()(const Key& key) const {
    return key.p->hash * 0x9e3779b97f4a7c15U ^ (key.q->hash + static_cast<std::size_t>(key.relative.index()));
  }
};

// True when the pair (p, q) is kept as (q, p): so that both orders share one entry.
bool kept_swapped(const outline::OrientedOutline& p, const outline::OrientedOutline& q) {
  const outline::Outline& a = *p.outline;
  const outline::Outline& b = *q.outline;
  if (a.hash != b.hash) return a.hash > b.hash;
  if (a.polygon != b.polygon) return a.polygon > b.polygon;
  const Symmetry forth = p.symmetry.inverse().after(q.symmetry);
  return forth.inverse().index() < forth.index();
}

// Under which key the sum of a pair is kept, and how the pair sees it.
struct Kept {
  Key key;
  Symmetry frame;
  bool swapped{};
};
Kept kept_as(const outline::OrientedOutline& p, const outline::OrientedOutline& q) {
  const bool swapped = kept_swapped(p, q);
  const outline::OrientedOutline& first = swapped ? q : p;
  const outline::OrientedOutline& second = swapped ? p : q;
  return {{first.outline, second.outline, first.symmetry.inverse().after(second.symmetry)}, first.symmetry, swapped};
}

using Sum = std::shared_ptr<const MinkowskiSum>;
Sum make(const Key& key) {
  return std::make_shared<const MinkowskiSum>(obstacle_sum(*key.p, *key.q, key.relative));
}

constexpr std::size_t kBlock = 4;  // sums that one hand makes in a row

}  // namespace

struct SumCache::Store {
  struct Held {
    Key key;
    Sum sum;
    std::size_t bytes{};
    std::uint64_t used{};  // the number of its last use
  };
  // What an outline was simplified to, as long as somebody keeps that.
  struct Grown {
    Coord tolerance{};
    std::weak_ptr<const outline::Outline> outline;
  };
  static constexpr std::size_t kGrown = 4;  // tolerances that one outline remembers
  struct Known {
    std::shared_ptr<const outline::Outline> outline;
    std::size_t bytes{};
    std::uint64_t used{};  // that of its last use, or its sums': they are forgotten before it
    std::vector<Grown> grown{};
  };
  // Most recently used first.
  using Sums = std::list<Held>;
  using Outlines = std::list<Known>;

  std::size_t limit{};
  mutable std::mutex mutex;
  Sums sums;
  Outlines outlines;
  std::unordered_map<Key, Sums::iterator, KeyHash> sum_at;
  std::unordered_multimap<std::uint64_t, Outlines::iterator> outline_at;  // by hash
  std::uint64_t uses{};
  CacheCounts counts;

  Sum find(const Key& key) {
    const std::lock_guard lock{mutex};
    const auto at = sum_at.find(key);
    if (at == sum_at.end()) return nullptr;
    use(at->second);
    return at->second->sum;
  }

  void count(std::size_t hits, std::size_t misses) {
    const std::lock_guard lock{mutex};
    counts.hits += hits;
    counts.misses += misses;
  }

  // Keeps the sum, unless another thread was faster.
  void keep(const Key& key, const Sum& sum) {
    const std::lock_guard lock{mutex};
    if (sum_at.contains(key)) return;
    sums.push_front({key, sum, sum->bytes()});
    sum_at.emplace(key, sums.begin());
    counts.bytes += sums.front().bytes;
    use(sums.begin());
    make_room();
  }

  // The outline of the polygon when it is known.
  std::shared_ptr<const outline::Outline> find(const Polygon& polygon, std::uint64_t hash) {
    const std::lock_guard lock{mutex};
    const auto known = use(polygon, hash);
    return known == outlines.end() ? nullptr : known->outline;
  }

  // What the outline was simplified to, when that is remembered.
  std::shared_ptr<const outline::Outline> find_grown(const outline::Outline& outline, Coord tolerance) {
    const std::lock_guard lock{mutex};
    const auto known = use(outline.polygon, outline.hash);
    if (known == outlines.end()) return nullptr;
    for (const Grown& grown : known->grown) {
      if (grown.tolerance == tolerance) return grown.outline.lock();
    }
    return nullptr;
  }
  // Remembers it as long as the outline is known.
  void keep_grown(const outline::Outline& outline, Coord tolerance,
                  const std::shared_ptr<const outline::Outline>& simplified) {
    const std::lock_guard lock{mutex};
    const auto known = use(outline.polygon, outline.hash);
    if (known == outlines.end()) return;
    std::vector<Grown>& grown = known->grown;
    std::erase_if(grown, [&](const Grown& one) { return one.tolerance == tolerance; });
    if (grown.size() == kGrown) grown.erase(grown.begin());
    grown.push_back({tolerance, simplified});
  }

  // The outline, or that of another thread that was faster.
  std::shared_ptr<const outline::Outline> keep(const std::shared_ptr<const outline::Outline>& made) {
    const std::lock_guard lock{mutex};
    if (const auto known = use(made->polygon, made->hash); known != outlines.end()) return known->outline;
    outlines.push_front({made, made->bytes(), ++uses});
    outline_at.emplace(made->hash, outlines.begin());
    counts.bytes += outlines.front().bytes;
    make_room();
    return made;
  }

 private:
  void use(Sums::iterator sum) {
    sum->used = ++uses;
    sums.splice(sums.begin(), sums, sum);
    use(sum->key.p->polygon, sum->key.p->hash);
    use(sum->key.q->polygon, sum->key.q->hash);
  }
  Outlines::iterator use(const Polygon& polygon, std::uint64_t hash) {
    const auto [first, last] = outline_at.equal_range(hash);
    for (auto at = first; at != last; ++at) {
      const auto known = at->second;
      if (&known->outline->polygon != &polygon && known->outline->polygon != polygon) continue;
      known->used = ++uses;
      outlines.splice(outlines.begin(), outlines, known);
      return known;
    }
    return outlines.end();
  }

  // Forgets the least recently used until what is kept fits.
  void make_room() {
    while (counts.bytes > limit && !(sums.empty() && outlines.empty())) {
      if (outlines.empty() || (!sums.empty() && sums.back().used < outlines.back().used)) {
        counts.bytes -= sums.back().bytes;
        sum_at.erase(sums.back().key);
        sums.pop_back();
      } else {
        forget(std::prev(outlines.end()));
      }
    }
  }
  void forget(Outlines::iterator outline) {
    counts.bytes -= outline->bytes;
    auto at = outline_at.equal_range(outline->outline->hash).first;
    while (at->second != outline) ++at;
    outline_at.erase(at);
    outlines.erase(outline);
  }
};

std::shared_ptr<const outline::Outline> SumCache::outline(const Polygon& polygon) {
  if (auto known = store_->find(polygon, outline::hash_of(polygon))) return known;
  return store_->keep(outline::make_outline(polygon));
}

std::shared_ptr<const outline::Outline> SumCache::grown(const std::shared_ptr<const outline::Outline>& outline,
                                                        Coord tolerance) {
  if (auto known = store_->find_grown(*outline, tolerance)) return known;
  Polygon simplified = outline::simplified_outward(outline->polygon, tolerance);
  auto made = simplified.size() == outline->polygon.size() ? outline : this->outline(simplified);
  store_->keep_grown(*outline, tolerance, made);
  return made;
}

SumCache::SumCache(std::size_t limit_bytes) : store_{std::make_unique<Store>()} {
  store_->limit = limit_bytes;
}
SumCache::~SumCache() = default;

Obstacle SumCache::obstacle(const outline::OrientedOutline& p, const outline::OrientedOutline& q) {
  const Kept kept = kept_as(p, q);
  Sum sum = store_->find(kept.key);
  store_->count(sum ? 1 : 0, sum ? 0 : 1);
  if (!sum) {
    sum = make(kept.key);
    store_->keep(kept.key, sum);
  }
  return {std::move(sum), kept.frame, kept.swapped};
}

std::vector<Obstacle> SumCache::obstacles(std::span<const OutlinePair> pairs, const Executor& executor) {
  std::vector<Kept> kept;
  std::vector<Sum> sums;
  kept.reserve(pairs.size());
  sums.reserve(pairs.size());
  std::vector<Key> missing;
  std::unordered_map<Key, std::size_t, KeyHash> number;  // of each that is missing
  for (const auto& [p, q] : pairs) {
    const Key& key = kept.emplace_back(kept_as(*p, *q)).key;
    sums.push_back(store_->find(key));
    if (!sums.back() && number.try_emplace(key, missing.size()).second) missing.push_back(key);
  }
  store_->count(pairs.size() - missing.size(), missing.size());

  const auto made = gathered<Sum>(executor, missing.size(), kBlock,
                                  [&](std::size_t k, std::vector<Sum>& out) { out.push_back(make(missing[k])); });
  for (std::size_t k = 0; k < missing.size(); ++k) store_->keep(missing[k], made[k]);

  std::vector<Obstacle> obstacles;
  obstacles.reserve(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!sums[k]) sums[k] = made[number.at(kept[k].key)];
    obstacles.emplace_back(std::move(sums[k]), kept[k].frame, kept[k].swapped);
  }
  return obstacles;
}

CacheCounts SumCache::counts() const {
  const std::lock_guard lock{store_->mutex};
  CacheCounts counts = store_->counts;
  counts.entries = store_->sums.size();
  counts.limit = store_->limit;
  return counts;
}

}  // namespace selvage::minkowski
