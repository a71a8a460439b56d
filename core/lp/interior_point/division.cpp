#include "core/lp/interior_point/division.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "core/lp/elimination/dissection.h"

namespace selvage::lp::interior_point {
namespace {

using elimination::Dissection;
using elimination::Nets;

constexpr int kNone = -1;
constexpr int kMostDomains = 32;  // more would leave too much to the border

std::size_t to_index(int k) {
  return static_cast<std::size_t>(k);
}

// The first rows of the groups of consecutive rows with the same columns, and the end: the rows of a pair of pieces
// form few groups.
std::vector<int> row_groups(const LinearProgram& program) {
  std::vector<int> start;
  std::span<const LinearProgram::Entry> last;
  for (int r = 0; r < program.rows(); ++r) {
    const auto row = program.row(r);
    if (r == 0 || !std::ranges::equal(row, last, {}, &LinearProgram::Entry::column, &LinearProgram::Entry::column)) {
      start.push_back(r);
    }
    last = row;
  }
  start.push_back(program.rows());
  return start;
}

bool moves(const LinearProgram& program, std::size_t column) {
  return program.lower[column] != program.upper[column];
}

// Consecutive columns that occur in a common row, such as those of a piece, are one vertex of the graph to be divided.
// Columns that cannot move are no vertex.
struct Vertices {
  std::vector<int> of;  // of each column
  int count{};
};
Vertices vertices_of_columns(const LinearProgram& program, std::span<const int> groups) {
  constexpr std::size_t kLookAhead = 3;  // entries among which the next column is looked for
  std::vector<char> with_next(program.cost.size(), 0);
  for (const int r : groups.first(groups.size() - 1)) {
    const auto row = program.row(r);
    for (std::size_t a = 0; a < row.size(); ++a) {
      for (std::size_t b = a + 1; b < std::min(row.size(), a + kLookAhead); ++b) {
        if (row[b].column == row[a].column + 1) with_next[to_index(row[a].column)] = 1;
      }
    }
  }
  Vertices vertices{std::vector<int>(program.cost.size(), kNone), 0};
  for (std::size_t j = 0; j < program.cost.size(); ++j) {
    if (!moves(program, j)) continue;
    vertices.of[j] = vertices.count;
    if (with_next[j] != 0 && moves(program, j + 1)) vertices.of[++j] = vertices.count;
    ++vertices.count;
  }
  return vertices;
}

// A net for the vertices of each group of rows; one for several consecutive groups with the same.
Nets nets_of_rows(const LinearProgram& program, std::span<const int> groups, const Vertices& vertices) {
  Nets nets;
  nets.vertices = vertices.count;
  std::vector<int> net, last;
  for (const int r : groups.first(groups.size() - 1)) {
    net.clear();
    for (const auto& entry : program.row(r)) {
      const int v = vertices.of[to_index(entry.column)];
      if (v == kNone || (!net.empty() && net.back() == v) || (net.size() == 2 && net.front() == v)) continue;
      net.push_back(v);
    }
    if (net.size() == 2) {  // as of all rows of a pair
      if (net[0] > net[1]) std::swap(net[0], net[1]);
    } else {
      std::sort(net.begin(), net.end());
      net.erase(std::unique(net.begin(), net.end()), net.end());
    }
    if (net.size() < 2 || net == last) continue;
    nets.vertex.insert(nets.vertex.end(), net.begin(), net.end());
    nets.start.push_back(static_cast<int>(nets.vertex.size()));
    last = net;
  }
  return nets;
}

// The columns and rows of each domain, from the domain of each column.
class Distribution {
 public:
  Distribution(const LinearProgram& program, std::span<const int> groups, const std::vector<int>& domain_of,
               int domains)
      : program_{program}, groups_{groups}, domain_of_{domain_of}, index_in_border_(domain_of.size(), kNone) {
    division_.domains.resize(to_index(domains));
    for (std::size_t j = 0; j < domain_of.size(); ++j) {
      if (!moves(program, j)) continue;
      if (domain_of[j] != Dissection::kBorder) {
        of(domain_of[j]).columns.push_back(static_cast<int>(j));
        continue;
      }
      index_in_border_[j] = static_cast<int>(division_.border.size());
      division_.border.push_back(static_cast<int>(j));
    }
    for (Division::Domain& domain : division_.domains) domain.own = static_cast<int>(domain.columns.size());
  }

  [[nodiscard]] Division divided() && {
    std::vector<std::vector<int>> border_of(division_.domains.size());  // with repetitions
    std::vector<std::size_t> on_border_only;
    division_.owner.assign(division_.border.size(), kNone);
    for (std::size_t group = 0; group + 1 < groups_.size(); ++group) {
      const int domain = domain_of_group(group);
      if (domain == kNone) {
        on_border_only.push_back(group);
      } else {
        add_group(group, domain, border_of[to_index(domain)]);
      }
    }
    for (int& owner : division_.owner) owner = std::max(owner, 0);
    for (const std::size_t group : on_border_only) {
      const int domain = owner_of_group(group);
      add_group(group, domain, border_of[to_index(domain)]);
    }
    for (std::size_t k = 0; k < division_.owner.size(); ++k) {
      border_of[to_index(division_.owner[k])].push_back(static_cast<int>(k));
    }
    for (std::size_t d = 0; d < division_.domains.size(); ++d) {
      Division::Domain& domain = division_.domains[d];
      std::sort(domain.rows.begin(), domain.rows.end());
      std::sort(border_of[d].begin(), border_of[d].end());
      border_of[d].erase(std::unique(border_of[d].begin(), border_of[d].end()), border_of[d].end());
      domain.border = std::move(border_of[d]);
      for (const int k : domain.border) domain.columns.push_back(division_.border[to_index(k)]);
    }
    return std::move(division_);
  }

 private:
  [[nodiscard]] Division::Domain& of(int domain) { return division_.domains[to_index(domain)]; }

  // kNone: no column of these rows is a domain's own.
  [[nodiscard]] int domain_of_group(std::size_t group) const {
    for (const auto& entry : program_.row(groups_[group])) {
      const auto j = to_index(entry.column);
      if (moves(program_, j) && domain_of_[j] != Dissection::kBorder) return domain_of_[j];
    }
    return kNone;
  }
  // Of rows on the border: the owner of their first column.
  [[nodiscard]] int owner_of_group(std::size_t group) const {
    for (const auto& entry : program_.row(groups_[group])) {
      const int k = index_in_border_[to_index(entry.column)];
      if (k != kNone) return division_.owner[to_index(k)];
    }
    return 0;
  }
  // The first domain with a row of a column owns it.
  void add_group(std::size_t group, int domain, std::vector<int>& border) {
    for (int r = groups_[group]; r < groups_[group + 1]; ++r) of(domain).rows.push_back(r);
    for (const auto& entry : program_.row(groups_[group])) {
      const int k = index_in_border_[to_index(entry.column)];
      if (k == kNone) continue;
      border.push_back(k);
      int& owner = division_.owner[to_index(k)];
      if (owner == kNone) owner = domain;
    }
  }

  const LinearProgram& program_;
  std::span<const int> groups_;  // of rows
  const std::vector<int>& domain_of_;
  std::vector<int> index_in_border_;  // of each column
  Division division_;
};

}  // namespace

Division division(const LinearProgram& program, int size) {
  if (program.columns() / 2 < size) return {};  // spares small programs the counting
  const std::vector<int> groups = row_groups(program);
  const Vertices vertices = vertices_of_columns(program, groups);
  const int domains = std::min(kMostDomains, vertices.count / size);
  if (domains < 2) return {};
  const Dissection dissected = elimination::dissection(nets_of_rows(program, groups, vertices), domains);
  if (dissected.domains == 1) return {};
  std::vector<int> domain_of(program.cost.size(), kNone);
  for (std::size_t j = 0; j < domain_of.size(); ++j) {
    if (vertices.of[j] != kNone) domain_of[j] = dissected.domain_of[to_index(vertices.of[j])];
  }
  return Distribution{program, groups, domain_of, dissected.domains}.divided();
}

LinearProgram domain_program(const LinearProgram& program, const Division& division, std::size_t domain) {
  const Division::Domain& part = division.domains[domain];
  LinearProgram made;
  std::vector<int> column_of(program.cost.size(), kNone);
  for (std::size_t k = 0; k < part.columns.size(); ++k) {
    const auto j = to_index(part.columns[k]);
    const bool own = k < to_index(part.own);
    const bool owns = own || division.owner[to_index(part.border[k - to_index(part.own)])] == static_cast<int>(domain);
    column_of[j] = owns ? made.add_column(program.cost[j], program.lower[j], program.upper[j])
                        : made.add_column(0, -kInfinity, kInfinity);
  }
  std::vector<LinearProgram::Entry> entries;
  for (const int r : part.rows) {
    double bound = program.bound[to_index(r)];
    entries.clear();
    for (const auto& [column, value] : program.row(r)) {
      const auto j = to_index(column);
      if (column_of[j] != kNone) {
        entries.push_back({column_of[j], value});
      } else {
        bound -= value * program.lower[j];
      }
    }
    made.add_row(entries, bound);
  }
  return made;
}

}  // namespace selvage::lp::interior_point
