#include "server/store/journal.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <map>
#include <mutex>
#include <utility>

#include "protocol/formats/native.h"
#include "protocol/json/json_text.h"
#include "server/store/disk/copy.h"
#include "server/store/disk/reader.h"
#include "server/store/disk/tables.h"

namespace selvage::server::store {
namespace {

constexpr std::size_t kMinBudget = std::size_t{64} << 10;  // bytes of steps after a snapshot

// A marker's row in the table `head`, as it is on disk.
struct Head {
  Revision revision{};
  std::uint64_t history{}, answers{};  // rows
  std::string summary;
  std::size_t budget{};  // bytes of steps until the next snapshot
};

using Total = disk::StoredTotal;

std::string document_text(const MarkerFile& file) {
  return protocol::json::to_text(protocol::formats::native_document(file));
}

}  // namespace

struct Journal::Implementation {
  Implementation(const std::string& path, Durability durability, std::stop_token stop)
      : file{path, durability, disk::StoreFile::Missing::kCreate, std::move(stop)}, tables{file.database()} {}

  // Does the work in one transaction; it changes copies of the head and the total.  If it fails or the file is gone,
  // logs that and returns false.  Afterwards a head at revision 0 is removed.
  template <class Work>
  bool write(const char* what, std::uint64_t number, const Work& work) {
    const std::lock_guard lock{mutex};
    const auto began = std::chrono::steady_clock::now();
    try {
      file.require_in_place();
      const auto known = heads.find(number);
      Head head = known == heads.end() ? Head{} : known->second;
      Total next = total;
      disk::Transaction transaction{file.database()};
      work(head, next);
      transaction.keep();
      file.require_in_place();
      if (head.revision == 0) {
        heads.erase(number);
      } else {
        heads.insert_or_assign(number, std::move(head));
      }
      total = next;
      count(began, {});
      return true;
    } catch (const std::exception& error) {
      spdlog::error("the store: {} could not be written: {}", what, error.what());
      count(began, error.what());
      return false;
    }
  }

  // Called when a write has ended; `reason` says why it failed, or is empty.
  void count(std::chrono::steady_clock::time_point began, std::string reason) {
    const std::lock_guard lock{outcome_mutex};
    ++(reason.empty() ? writes.written : writes.failed);
    writes.seconds += std::chrono::duration<double>{std::chrono::steady_clock::now() - began}.count();
    failure = std::move(reason);
  }

  void put_snapshot(std::uint64_t number, Head& head, const MarkerFile& after) {
    const std::string text = document_text(after);
    tables.put_snapshot.with(number, head.revision, name_of(after.format), text).run();
    tables.delete_steps.with(number).run();
    head.budget = std::max(text.size(), kMinBudget);
  }
  void put_head(std::uint64_t number, const Head& head) {
    tables.put_head.with(number, head.revision, head.history, head.answers, head.summary).run();
  }
  void put_total(const Total& next) { tables.put_total.with(next.opened, next.markers, next.answers).run(); }

  // `count`: the number of rows of these answers.  Marker 0 stands for calls that open or close markers.
  void put_answer(std::uint64_t number, const std::optional<KeptChange>& change, std::uint64_t& count) {
    if (!change) return;
    for (const std::uint64_t serial : change->forgotten) tables.delete_answer.with(number, serial).run();
    const KeptAnswer& answer = change->answer;
    tables.put_answer
        .with(number, answer.serial, answer.client, answer.op_id, answer.method, answer.params, *answer.result)
        .run();
    count += 1 - change->forgotten.size();
  }

  void put_history(std::uint64_t number, Head& head, const Marker& after, const History::Recorded& recorded) {
    const auto& [serial, back] = *recorded.step;
    const std::int64_t way = way_of(recorded.direction);
    if (const auto* moves = std::get_if<protocol::edits::Moves>(&back)) {
      tables.put_history.with(number, serial, way, "", protocol::json::to_text(moves_json(after, *moves))).run();
    } else {
      const MarkerFile& before = *std::get<History::File>(back);
      tables.put_history.with(number, serial, way, name_of(before.format), document_text(before)).run();
    }
    for (const std::uint64_t forgotten : recorded.forgotten) tables.delete_history_step.with(number, forgotten).run();
    head.history += 1 - recorded.forgotten.size();
  }

  disk::StoreFile file;
  std::mutex mutex;
  disk::Tables tables;
  std::map<std::uint64_t, Head> heads;  // of the open markers
  Total total;
  std::mutex backup_mutex;
  mutable std::mutex outcome_mutex;
  WriteCounts writes;
  std::string failure;  // of the last write
};

Journal::Journal(const std::string& path, Durability durability, std::stop_token stop)
    : implementation_{std::make_unique<Implementation>(path, durability, std::move(stop))} {}
Journal::~Journal() = default;

disk::StoredContent Journal::restore(std::stop_token stop) {
  Implementation& journal = *implementation_;
  const std::lock_guard lock{journal.mutex};
  const disk::Stoppable reading{journal.file.database(), std::move(stop)};
  disk::StoredContent content = disk::read_store(journal.file.database());
  for (const disk::Damage& damage : content.damage) {
    spdlog::error("the store is damaged: {}", disk::text_of(damage));
  }
  for (const disk::StoredMarker& marker : content.markers) {
    std::size_t used = 0;
    for (const std::string& step : marker.steps) used += step.size();
    const std::size_t budget = std::max(marker.document.size(), kMinBudget);
    journal.heads[static_cast<std::uint64_t>(marker.number)] = {
        marker.revision, marker.history.size(), marker.answers.size(), marker.summary, budget - std::min(used, budget)};
  }
  journal.total = content.total;
  return content;
}

bool Journal::opened(std::uint64_t number, const MarkerFile& file, const std::string& summary,
                     const std::optional<KeptChange>& answer) {
  Implementation& journal = *implementation_;
  return journal.write("a marker that was opened", number, [&](Head& head, Total& total) {
    head = {.revision = 1, .history = 0, .answers = 0, .summary = summary, .budget = 0};
    total.opened = std::max(total.opened, number);
    ++total.markers;
    journal.put_snapshot(number, head, file);
    journal.put_head(number, head);
    journal.put_answer(0, answer, total.answers);
    journal.put_total(total);
  });
}

bool Journal::changed(std::uint64_t number, const ChangeEntry& entry) {
  Implementation& journal = *implementation_;
  const std::string text =
      entry.moves ? protocol::json::to_text(moves_json(entry.after.marker, *entry.moves)) : std::string{};
  return journal.write("a revision", number, [&](Head& head, Total&) {
    head.revision = entry.revision;
    head.summary = entry.summary;
    journal.put_answer(number, entry.answer, head.answers);
    journal.put_history(number, head, entry.after.marker, entry.recorded);
    if (entry.moves && head.budget > text.size()) {
      head.budget -= text.size();
      journal.tables.put_step.with(number, entry.revision, text).run();
    } else {
      journal.put_snapshot(number, head, entry.after);
    }
    journal.put_head(number, head);
  });
}

bool Journal::closed(std::uint64_t number, const std::optional<KeptChange>& answer) {
  Implementation& journal = *implementation_;
  return journal.write("a marker that was closed", number, [&](Head& head, Total& total) {
    head = {};
    total.markers -= std::min<std::uint64_t>(total.markers, 1);
    disk::Tables& tables = journal.tables;
    for (disk::Statement* remove : {&tables.delete_head, &tables.delete_snapshot, &tables.delete_steps,
                                    &tables.delete_history, &tables.delete_answers}) {
      remove->with(number).run();
    }
    journal.put_answer(0, answer, total.answers);
    journal.put_total(total);
  });
}

bool Journal::answered(std::uint64_t number, const KeptChange& answer) {
  Implementation& journal = *implementation_;
  return journal.write("an answer", number, [&](Head& head, Total&) {
    journal.put_answer(number, answer, head.answers);
    journal.put_head(number, head);
  });
}

bool Journal::write(const char* what, const std::function<void(disk::Database&)>& work) {
  Implementation& journal = *implementation_;
  return journal.write(what, 0, [&](Head&, Total&) { work(journal.file.database()); });
}

void Journal::read(const std::function<void(disk::Database&)>& work) {
  Implementation& journal = *implementation_;
  const std::lock_guard lock{journal.mutex};
  work(journal.file.database());
}

std::string Journal::failure() const {
  try {
    implementation_->file.require_in_place();
  } catch (const std::exception& error) {
    return error.what();
  }
  const std::lock_guard lock{implementation_->outcome_mutex};
  return implementation_->failure;
}

WriteCounts Journal::writes() const {
  const std::lock_guard lock{implementation_->outcome_mutex};
  return implementation_->writes;
}

std::uint64_t Journal::back_up(const std::string& name) {
  const std::lock_guard lock{implementation_->backup_mutex};
  const std::string copy = implementation_->file.path() + ".backup-" + name;
  return disk::copy_store(implementation_->file.path(), copy, disk::Existing::kRefuse);
}

const std::string& Journal::identity() const {
  return implementation_->file.identity();
}

const std::string& Journal::path() const {
  return implementation_->file.path();
}

}  // namespace selvage::server::store
