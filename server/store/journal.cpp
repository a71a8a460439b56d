#include "server/store/journal.h"

#include <spdlog/spdlog.h>

#include <exception>
#include <mutex>
#include <utility>

#include "protocol/formats/native.h"
#include "server/store/journal_database.h"
#include "server/store/journal_reader.h"
#include "server/store/journal_tables.h"

namespace selvage::server::store {

struct Journal::Implementation {
  Implementation(const std::string& path, Durability durability) : tables{path, durability} {}

  // Does the work in one transaction.  Returns false, with a line in the log, if it failed.
  template <class Work>
  bool write(const char* what, const Work& work) {
    const std::lock_guard lock{mutex};
    try {
      Transaction transaction{tables.database};
      work();
      transaction.keep();
      return true;
    } catch (const std::exception& error) {
      spdlog::error("the store: {} could not be written: {}", what, error.what());
      return false;
    }
  }

  void put_snapshot(const std::string& id, Revision revision, const MarkerFile& file) {
    const std::string text = protocol::json::to_text(protocol::formats::native_document(file));
    tables.put_snapshot.with(id, revision, name_of(file.format), text).run();
    tables.delete_steps.with(id).run();
    trim_answers(id);
    budget.begin(id, text.size());
  }

  void put_answer(const std::string& id, const std::optional<KeptAnswer>& answer) {
    if (answer) tables.put_answer.with(id, answer->op_id, answer->method, *answer->result).run();
  }

  void trim_answers(const std::string& id) {
    tables.trim_answers.with(id, id, std::uint64_t{KeptAnswers::kMost}).run();
  }

  void put_history(const std::string& id, const Marker& after, const History::Recorded& recorded) {
    const auto& [serial, back] = *recorded.step;
    const std::int64_t direction = column_value(recorded.direction);
    if (const auto* moves = std::get_if<protocol::edits::Moves>(&back)) {
      tables.put_history.with(id, serial, direction, "", protocol::json::to_text(moves_json(after, *moves))).run();
    } else {
      const MarkerFile& file = *std::get<History::File>(back);
      const std::string text = protocol::json::to_text(protocol::formats::native_document(file));
      tables.put_history.with(id, serial, direction, name_of(file.format), text).run();
    }
    for (const std::uint64_t forgotten : recorded.forgotten) tables.delete_history_step.with(id, forgotten).run();
  }

  std::mutex mutex;
  JournalTables tables;
  SnapshotBudget budget;
};

Journal::Journal(const std::string& path, Durability durability)
    : implementation_{std::make_unique<Implementation>(path, durability)} {}
Journal::~Journal() = default;

Restored Journal::restore() {
  const std::lock_guard lock{implementation_->mutex};
  return JournalReader{implementation_->tables, implementation_->budget}.restore();
}

bool Journal::opened(const std::string& id, std::uint64_t number, const MarkerFile& file,
                     const std::optional<KeptAnswer>& answer) {
  Implementation& journal = *implementation_;
  return journal.write("a marker that was opened", [&] {
    journal.tables.put_opened.with(number).run();
    journal.put_snapshot(id, 1, file);
    journal.put_answer("", answer);
    journal.trim_answers("");
  });
}

bool Journal::changed(const std::string& id, const ChangeEntry& entry) {
  Implementation& journal = *implementation_;
  const std::string text =
      entry.moves ? protocol::json::to_text(moves_json(entry.after.marker, *entry.moves)) : std::string{};
  return journal.write("a revision", [&] {
    journal.put_answer(id, entry.answer);
    journal.put_history(id, entry.after.marker, entry.recorded);
    if (entry.moves && journal.budget.use(id, text.size())) {
      journal.tables.put_step.with(id, entry.revision, text).run();
    } else {
      journal.put_snapshot(id, entry.revision, entry.after);
    }
  });
}

bool Journal::closed(const std::string& id, const std::optional<KeptAnswer>& answer) {
  Implementation& journal = *implementation_;
  return journal.write("a marker that was closed", [&] {
    journal.tables.delete_snapshot.with(id).run();
    journal.tables.delete_steps.with(id).run();
    journal.tables.delete_history.with(id).run();
    journal.tables.delete_answers.with(id).run();
    journal.put_answer("", answer);
    journal.trim_answers("");
    journal.budget.remove(id);
  });
}

bool Journal::answered(const std::string& id, const KeptAnswer& answer) {
  Implementation& journal = *implementation_;
  return journal.write("an answer", [&] { journal.put_answer(id, answer); });
}

}  // namespace selvage::server::store
