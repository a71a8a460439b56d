#include "server/store/disk/reader.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace selvage::server::store::disk {
namespace {

struct Head {
  std::uint64_t revision{}, history{}, answers{};
};

// Reads each table completely, because only a full scan finds rows whose key has been damaged.
class Reading {
 public:
  explicit Reading(Database& database) : database_{database} {}

  StoredContent read() {
    read_heads();
    read_snapshots();
    read_steps();
    read_history();
    read_answers();
    read_total();
    for (auto& [number, marker] : markers_) judge(number, marker);
    for (auto& [number, what] : damaged_) content_.damage.push_back({number, what});
    return std::move(content_);
  }

 private:
  // Calls `take` for each row whose checksum is correct, which the last column says.
  template <class Take>
  void scan(const char* table, const char* columns, int revision_column, const Take& take) {
    const std::string list = columns;
    Statement row{database_.handle(),
                  "SELECT " + list + ", sum = checksum('" + table + "', " + list + ") FROM " + table};
    const int last = static_cast<int>(std::count(list.begin(), list.end(), ',')) + 1;
    while (row.step()) {
      const std::int64_t number = row.integer(0);
      if (row.integer(last) == 1) {
        take(number, row);
        continue;
      }
      std::string what = std::string{"a damaged row of the table "} + table;
      if (revision_column > 0) what += ", revision " + std::to_string(row.whole(revision_column));
      damaged_.try_emplace(number, what);
    }
  }

  void read_heads() {
    scan("head", "marker, revision, history, answers, summary", 1, [this](std::int64_t number, const Statement& row) {
      heads_[number] = {row.whole(1), row.whole(2), row.whole(3)};
      StoredMarker& marker = markers_[number];
      marker.number = number;
      marker.revision = row.whole(1);
      marker.summary = row.text(4);
    });
    found_ = heads_.size();
  }

  void read_snapshots() {
    scan("snapshot", "marker, revision, format, document", 1, [this](std::int64_t number, const Statement& row) {
      StoredMarker& marker = markers_[number];
      marker.snapshot_revision = row.whole(1);
      marker.format = row.text(2);
      marker.document = row.text(3);
      has_snapshot_.insert(number);
    });
  }

  void read_steps() {
    scan("step", "marker, revision, moves", 1, [this](std::int64_t number, const Statement& row) {
      StoredMarker& marker = markers_[number];
      if (row.whole(1) == marker.snapshot_revision + marker.steps.size() + 1) {
        marker.steps.push_back(row.text(2));
      } else if (has_snapshot_.contains(number)) {
        const std::uint64_t wanted = marker.snapshot_revision + marker.steps.size() + 1;
        damaged_.try_emplace(number, "revision " + std::to_string(wanted) + " is missing");
      }
    });
  }

  void read_history() {
    scan("history", "marker, serial, way, format, step", 0, [this](std::int64_t number, const Statement& row) {
      markers_[number].history.push_back({row.whole(1), row.integer(2), row.text(3), row.text(4)});
    });
  }

  void read_answers() {
    scan("answer", "marker, serial, client, op, method, params, result", 0,
         [this](std::int64_t number, const Statement& row) {
           std::vector<StoredAnswer>& answers = number == 0 ? content_.answers : markers_[number].answers;
           answers.push_back({row.whole(1), row.text(2), row.text(3), row.text(4), row.integer(5), row.text(6)});
         });
  }

  // The ids of markers that were opened and closed must not be used again, even if the counter is damaged.
  void read_total() {
    Statement row{database_.handle(),
                  "SELECT opened, markers, answers, sum = checksum('total', opened, markers, answers) FROM total"};
    StoredTotal& total = content_.total;
    if (row.step() && row.integer(3) == 1) {
      total = {row.whole(0), row.whole(1), row.whole(2)};
      if (total.markers != found_) add_damage("it had " + std::to_string(total.markers) + " markers");
      if (total.answers != content_.answers.size())
        add_damage("answers to calls that opened or closed markers are missing");
    } else {
      add_damage("the count of markers");
      total = {0, found_, content_.answers.size()};
    }
    for (const auto& [number, head] : heads_) total.opened = std::max(total.opened, static_cast<std::uint64_t>(number));
  }

  void judge(std::int64_t number, StoredMarker& marker) {
    const auto head = heads_.find(number);
    const auto fail = [&](const std::string& what) { damaged_.try_emplace(number, what); };
    if (head == heads_.end()) return fail("it has rows but no row in the table head");
    if (!has_snapshot_.contains(number)) return fail("it has no snapshot");
    const std::uint64_t reached = marker.snapshot_revision + marker.steps.size();
    if (reached != head->second.revision) {
      return fail("it is at revision " + std::to_string(head->second.revision) + ", and revision " +
                  std::to_string(reached + 1) + " is missing");
    }
    if (marker.history.size() != head->second.history) return fail("steps of its history are missing");
    if (marker.answers.size() != head->second.answers) return fail("answers kept for its calls are missing");
    if (!damaged_.contains(number)) content_.markers.push_back(std::move(marker));
  }

  void add_damage(const std::string& what) { content_.damage.push_back({0, what}); }

  Database& database_;
  std::map<std::int64_t, Head> heads_;
  std::size_t found_{};
  std::set<std::int64_t> has_snapshot_;
  std::map<std::int64_t, StoredMarker> markers_;
  std::map<std::int64_t, std::string> damaged_;  // the first damage of each marker
  StoredContent content_;
};

}  // namespace

StoredContent read_store(Database& database) {
  return Reading{database}.read();
}

}  // namespace selvage::server::store::disk
