#include "server/journal.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <exception>
#include <map>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "protocol/formats/native.h"
#include "server/journal_database.h"

namespace selvage {
namespace {

constexpr int kSchema = 1;
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
  if (schema == 0 && number_of(database, "SELECT count(*) FROM sqlite_master") == 0) {
    database.run(kTables);
    database.run("PRAGMA user_version = " + std::to_string(kSchema));
  } else if (schema != kSchema) {
    throw std::runtime_error{"not a store of this version of selvaged"};
  }
  transaction.keep();
  Statement check{database.handle(), "PRAGMA quick_check(1)"};
  if (!check.step() || check.text(0) != "ok") throw std::runtime_error{"the file is damaged"};
}

// A database whose tables are there, which statements need.
struct Ledger : Database {
  Ledger(const std::string& path, Durability durability) : Database{path} { set_up(*this, durability); }
};

std::optional<Format> format_named(const std::string& name) {
  const auto* const found = std::find(std::begin(kFormatNames), std::end(kFormatNames), name);
  if (found == std::end(kFormatNames)) return std::nullopt;
  return static_cast<Format>(found - std::begin(kFormatNames));
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
    const std::string text = to_text(native_document(file));
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
    auto file = read_marker(document);
    const auto form = format_named(format);
    if (!file || !form) {
      spdlog::error("the store: marker {} cannot be read and is left out: {}", id,
                    file ? "a format of no name" : file.error().message);
      return std::nullopt;
    }
    file->format = *form;
    file->notes.clear();
    RestoredMarker marker{id, revision, *std::move(file), answers_of(id)};
    room[id] = std::max(document.size(), kLeastSnapshot);
    replay(marker);
    return marker;
  }

  // Takes the steps since the snapshot, up to the first that does not follow.
  void replay(RestoredMarker& marker) {
    read_steps.with(marker.id, marker.revision);
    while (read_steps.step()) {
      const auto revision = static_cast<Revision>(read_steps.integer(0));
      const std::string text = read_steps.text(1);
      const auto list = parse(text);
      const auto moves = list ? read_moves(*list, marker.file.marker) : Result<Moves>{list.error()};
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

bool Journal::changed(const std::string& id, Revision revision, const std::optional<Moves>& moves,
                      const MarkerFile& after, const std::optional<KeptAnswer>& answer) {
  const std::string text = moves ? to_text(moves_json(after.marker, *moves)) : std::string{};
  return inside_->write("a revision", [&] {
    inside_->keep(id, answer);
    if (moves && !inside_->use_room(id, text.size())) {
      inside_->put_step.with(id, revision, text).run();
    } else {
      inside_->snapshot(id, revision, after);
    }
  });
}

bool Journal::closed(const std::string& id, const std::optional<KeptAnswer>& answer) {
  return inside_->write("a marker that was closed", [&] {
    inside_->forget_snapshot.with(id).run();
    inside_->forget_steps.with(id).run();
    inside_->forget_answers.with(id).run();
    inside_->keep("", answer);
    inside_->trim_answers.with("", "", std::uint64_t{KeptAnswers::kMost}).run();
    inside_->room.erase(id);
  });
}

bool Journal::answered(const std::string& id, const KeptAnswer& answer) {
  return inside_->write("an answer", [&] { inside_->keep(id, answer); });
}

}  // namespace selvage
