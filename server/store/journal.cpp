#include "server/store/journal.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <exception>
#include <map>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "protocol/formats/native.h"
#include "server/store/journal_database.h"

namespace selvage::server::store {
namespace {

constexpr int kSchema = 2;
constexpr std::size_t kLeastSnapshot = std::size_t{64} << 10;  // bytes of steps that never make a new snapshot

// The answers of marker "" are those to calls that opened and closed markers.
constexpr const char* kTables = R"(
  CREATE TABLE opened(number INTEGER NOT NULL);
  INSERT INTO opened VALUES(0);
  CREATE TABLE snapshot(marker TEXT PRIMARY KEY, revision INTEGER NOT NULL, format TEXT NOT NULL, document TEXT NOT NULL);
  CREATE TABLE step(marker TEXT NOT NULL, revision INTEGER NOT NULL, moves TEXT NOT NULL,
                    PRIMARY KEY(marker, revision)) WITHOUT ROWID;
  CREATE TABLE answer(serial INTEGER PRIMARY KEY AUTOINCREMENT, marker TEXT NOT NULL, op TEXT NOT NULL,
                      method TEXT NOT NULL, result TEXT NOT NULL);
  CREATE INDEX answers_of_a_marker ON answer(marker, serial);
)";
// A step is moves, when it has no format, or a document.  Stores of schema 1 had no such table.
constexpr const char* kHistoryTable = R"(
  CREATE TABLE history(marker TEXT NOT NULL, serial INTEGER NOT NULL, way INTEGER NOT NULL, format TEXT NOT NULL,
                       step TEXT NOT NULL, PRIMARY KEY(marker, serial)) WITHOUT ROWID;
)";

std::int64_t number_of(Database& database, const char* sql) {
  Statement statement{database.handle(), sql};
  return statement.step() ? statement.integer(0) : 0;
}

void set_up(Database& database, Durability durability) {
  database.run("PRAGMA locking_mode = EXCLUSIVE");
  database.run("PRAGMA journal_mode = WAL");
  database.run(durability == Durability::kFull ? "PRAGMA synchronous = FULL" : "PRAGMA synchronous = NORMAL");
  Transaction transaction{database};  // takes the file for this process
  const std::int64_t schema = number_of(database, "PRAGMA user_version");
  const bool empty = schema == 0 && number_of(database, "SELECT count(*) FROM sqlite_master") == 0;
  if (!empty && schema != 1 && schema != kSchema) throw std::runtime_error{"not a store of this version of selvaged"};
  if (empty) database.run(kTables);
  if (schema < kSchema) {
    database.run(kHistoryTable);
    database.run("PRAGMA user_version = " + std::to_string(kSchema));
  }
  transaction.keep();
  Statement check{database.handle(), "PRAGMA quick_check(1)"};
  if (!check.step() || check.text(0) != "ok") throw std::runtime_error{"the file is damaged"};
}

// A database whose tables are there, which statements need.
struct Ledger : Database {
  Ledger(const std::string& path, Durability durability) : Database{path} { set_up(*this, durability); }
};

Result<Format> format_named(const std::string& name) {
  const auto* const found =
      std::find(std::begin(protocol::document::kFormatNames), std::end(protocol::document::kFormatNames), name);
  if (found == std::end(protocol::document::kFormatNames))
    return Error{ErrorCode::kWrongType, "a format of no name", ""};
  return static_cast<Format>(found - std::begin(protocol::document::kFormatNames));
}

std::int64_t number_of(Way way) {
  return way == Way::kUndo ? 0 : 1;
}

// A document as the journal wrote it.
Result<MarkerFile> read_document(const std::string& format, const std::string& document) {
  auto file = protocol::formats::read_marker(document);
  if (!file) return file;
  const auto form = format_named(format);
  if (!form) return form.error();
  file->format = *form;
  file->notes.clear();
  return file;
}

// `marker`: what the step leads away from.
Result<History::Back> read_back(const std::string& format, const std::string& text, const Marker& marker) {
  if (!format.empty()) {
    auto file = read_document(format, text);
    if (!file) return file.error();
    return History::Back{std::make_shared<const MarkerFile>(*std::move(file))};
  }
  const auto list = protocol::json::parse(text);
  if (!list) return list.error();
  auto moves = protocol::edits::read_moves(*list, marker);
  if (!moves) return moves.error();
  return History::Back{*std::move(moves)};
}

}  // namespace

struct Journal::Inside {
  Inside(const std::string& path, Durability durability) : database{path, durability} {}

  // One transaction; false, with a line in the log, when it failed.
  template <class Work>
  bool write(const char* what, const Work& work) {
    const std::lock_guard lock{mutex};
    try {
      Transaction transaction{database};
      work();
      transaction.keep();
      return true;
    } catch (const std::exception& error) {
      spdlog::error("the store: {} could not be written: {}", what, error.what());
      return false;
    }
  }

  void snapshot(const std::string& id, Revision revision, const MarkerFile& file) {
    const std::string text = protocol::json::to_text(protocol::formats::native_document(file));
    put_snapshot.with(id, revision, name_of(file.format), text).run();
    forget_steps.with(id).run();
    trim_answers.with(id, id, std::uint64_t{KeptAnswers::kMost}).run();
    room[id] = std::max(text.size(), kLeastSnapshot);
  }

  void keep(const std::string& id, const std::optional<KeptAnswer>& answer) {
    if (answer) put_answer.with(id, answer->op_id, answer->method, *answer->result).run();
  }

  std::vector<KeptAnswer> answers_of(const std::string& id) {
    std::vector<KeptAnswer> answers;
    read_answers.with(id, std::uint64_t{KeptAnswers::kMost});
    while (read_answers.step()) {
      answers.push_back(
          {read_answers.text(0), read_answers.text(1), std::make_shared<const std::string>(read_answers.text(2))});
    }
    std::reverse(answers.begin(), answers.end());
    return answers;
  }

  std::optional<RestoredMarker> marker_of(const std::string& id, Revision revision, const std::string& format,
                                          const std::string& document) {
    auto file = read_document(format, document);
    if (!file) {
      spdlog::error("the store: marker {} cannot be read and is left out: {}", id, file.error().message);
      return std::nullopt;
    }
    RestoredMarker marker{id, revision, *std::move(file), answers_of(id)};
    room[id] = std::max(document.size(), kLeastSnapshot);
    replay(marker);
    marker.history = {steps_of(marker, Way::kUndo), steps_of(marker, Way::kRedo)};
    return marker;
  }

  // Takes the steps since the snapshot, up to the first that does not follow.
  void replay(RestoredMarker& marker) {
    read_steps.with(marker.id, marker.revision);
    while (read_steps.step()) {
      const auto revision = static_cast<Revision>(read_steps.integer(0));
      const std::string text = read_steps.text(1);
      const auto list = protocol::json::parse(text);
      const auto moves =
          list ? protocol::edits::read_moves(*list, marker.file.marker) : Result<protocol::edits::Moves>{list.error()};
      if (!moves || revision != marker.revision + 1) {
        cut(marker, moves ? "a revision is missing" : moves.error().message);
        return;
      }
      marker.file = moved(std::move(marker.file), *moves);
      marker.revision = revision;
      use_room(marker.id, text.size());
    }
  }

  void cut(const RestoredMarker& marker, const std::string& reason) {
    spdlog::warn("the store: the tail of marker {} after revision {} is torn and was cut off: {}", marker.id,
                 marker.revision, reason);
    read_steps.with(marker.id, marker.revision);
    forget_steps_after.with(marker.id, marker.revision).run();
    forget_history.with(marker.id).run();  // it leads back from the revisions that were cut off
  }

  void record(const std::string& id, const Marker& after, const History::Recorded& recorded) {
    const auto& [serial, back] = *recorded.step;
    if (const auto* moves = std::get_if<protocol::edits::Moves>(&back)) {
      put_back.with(id, serial, number_of(recorded.way), "", protocol::json::to_text(moves_json(after, *moves))).run();
    } else {
      const MarkerFile& file = *std::get<History::File>(back);
      put_back
          .with(id, serial, number_of(recorded.way), name_of(file.format),
                protocol::json::to_text(protocol::formats::native_document(file)))
          .run();
    }
    for (const std::uint64_t forgotten : recorded.forgotten) forget_back.with(id, forgotten).run();
  }

  // The oldest first.  Each is read as seen from where the next newer one leads to.
  std::vector<History::Step> steps_of(const RestoredMarker& marker, Way way) {
    std::vector<History::Step> steps;
    MarkerFile at = marker.file;
    read_history.with(marker.id, number_of(way));
    while (read_history.step()) {
      const auto serial = static_cast<std::uint64_t>(read_history.integer(0));
      auto back = read_back(read_history.text(1), read_history.text(2), at.marker);
      if (!back) {
        spdlog::warn("the store: {} steps of marker {} beyond the last {} cannot be read and were cut off: {}",
                     way == Way::kUndo ? "undo" : "redo", marker.id, steps.size(), back.error().message);
        read_history.with(marker.id, number_of(way));
        forget_history_before.with(marker.id, number_of(way), serial).run();
        break;
      }
      at = taken(*back, std::move(at));
      steps.push_back({serial, *std::move(back)});
    }
    std::reverse(steps.begin(), steps.end());
    return steps;
  }

  // True when the steps have outgrown the snapshot.
  bool use_room(const std::string& id, std::size_t bytes) {
    std::size_t& left = room[id];
    const bool spent = left <= bytes;
    left = spent ? 0 : left - bytes;
    return spent;
  }

  std::mutex mutex;
  Ledger database;
  std::map<std::string, std::size_t> room;  // bytes of steps until the next snapshot, by marker
  Statement put_snapshot{database.handle(), "INSERT OR REPLACE INTO snapshot VALUES(?, ?, ?, ?)"};
  Statement put_step{database.handle(), "INSERT INTO step VALUES(?, ?, ?)"};
  Statement put_answer{database.handle(), "INSERT INTO answer(marker, op, method, result) VALUES(?, ?, ?, ?)"};
  Statement put_opened{database.handle(), "UPDATE opened SET number = max(number, ?)"};
  Statement forget_snapshot{database.handle(), "DELETE FROM snapshot WHERE marker = ?"};
  Statement forget_steps{database.handle(), "DELETE FROM step WHERE marker = ?"};
  Statement forget_steps_after{database.handle(), "DELETE FROM step WHERE marker = ? AND revision > ?"};
  Statement put_back{database.handle(), "INSERT INTO history VALUES(?, ?, ?, ?, ?)"};
  Statement forget_back{database.handle(), "DELETE FROM history WHERE marker = ? AND serial = ?"};
  Statement forget_history{database.handle(), "DELETE FROM history WHERE marker = ?"};
  Statement forget_history_before{database.handle(),
                                  "DELETE FROM history WHERE marker = ? AND way = ? AND serial <= ?"};
  Statement read_history{database.handle(),
                         "SELECT serial, format, step FROM history WHERE marker = ? AND way = ? ORDER BY serial DESC"};
  Statement forget_answers{database.handle(), "DELETE FROM answer WHERE marker = ?"};
  Statement trim_answers{database.handle(),
                         "DELETE FROM answer WHERE marker = ? AND serial NOT IN "
                         "(SELECT serial FROM answer WHERE marker = ? ORDER BY serial DESC LIMIT ?)"};
  Statement read_snapshots{database.handle(), "SELECT marker, revision, format, document FROM snapshot"};
  Statement read_steps{database.handle(),
                       "SELECT revision, moves FROM step WHERE marker = ? AND revision > ? ORDER BY revision"};
  Statement read_answers{database.handle(),
                         "SELECT op, method, result FROM answer WHERE marker = ? ORDER BY serial DESC LIMIT ?"};
};

Journal::Journal(const std::string& path, Durability durability)
    : inside_{std::make_unique<Inside>(path, durability)} {}
Journal::~Journal() = default;

Restored Journal::restore() {
  const std::lock_guard lock{inside_->mutex};
  Restored all;
  all.opened = static_cast<std::uint64_t>(number_of(inside_->database, "SELECT number FROM opened"));
  all.answers = inside_->answers_of("");
  inside_->read_snapshots.with();
  while (inside_->read_snapshots.step()) {
    const Statement& row = inside_->read_snapshots;
    auto marker = inside_->marker_of(row.text(0), static_cast<Revision>(row.integer(1)), row.text(2), row.text(3));
    if (marker) all.markers.push_back(*std::move(marker));
  }
  inside_->read_snapshots.with();  // ends the reading
  return all;
}

bool Journal::opened(const std::string& id, std::uint64_t number, const MarkerFile& file,
                     const std::optional<KeptAnswer>& answer) {
  return inside_->write("a marker that was opened", [&] {
    inside_->put_opened.with(number).run();
    inside_->snapshot(id, 1, file);
    inside_->keep("", answer);
    inside_->trim_answers.with("", "", std::uint64_t{KeptAnswers::kMost}).run();
  });
}

bool Journal::changed(const std::string& id, const ChangeEntry& entry) {
  const std::string text =
      entry.moves ? protocol::json::to_text(moves_json(entry.after.marker, *entry.moves)) : std::string{};
  return inside_->write("a revision", [&] {
    inside_->keep(id, entry.answer);
    inside_->record(id, entry.after.marker, entry.recorded);
    if (entry.moves && !inside_->use_room(id, text.size())) {
      inside_->put_step.with(id, entry.revision, text).run();
    } else {
      inside_->snapshot(id, entry.revision, entry.after);
    }
  });
}

bool Journal::closed(const std::string& id, const std::optional<KeptAnswer>& answer) {
  return inside_->write("a marker that was closed", [&] {
    inside_->forget_snapshot.with(id).run();
    inside_->forget_steps.with(id).run();
    inside_->forget_history.with(id).run();
    inside_->forget_answers.with(id).run();
    inside_->keep("", answer);
    inside_->trim_answers.with("", "", std::uint64_t{KeptAnswers::kMost}).run();
    inside_->room.erase(id);
  });
}

bool Journal::answered(const std::string& id, const KeptAnswer& answer) {
  return inside_->write("an answer", [&] { inside_->keep(id, answer); });
}

}  // namespace selvage::server::store
