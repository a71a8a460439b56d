// The journal restores what was acknowledged and removes what cannot be read.
#include "server/store/journal.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>

#include "server/store/disk/database.h"
#include "server/store/disk/schema.h"
#include "tests/server/dispatch/local_server.h"

namespace selvage::test {
namespace {

// Converts a store of the current schema to schema 2.
constexpr const char* kIntoSchema2 = R"(
  ALTER TABLE snapshot RENAME TO s; ALTER TABLE step RENAME TO t; ALTER TABLE history RENAME TO h;
  ALTER TABLE answer RENAME TO a;
  CREATE TABLE opened(number INTEGER NOT NULL);
  INSERT INTO opened SELECT opened FROM total;
  CREATE TABLE snapshot(marker TEXT PRIMARY KEY, revision INTEGER NOT NULL, format TEXT NOT NULL, document TEXT NOT NULL);
  INSERT INTO snapshot SELECT 'm' || marker, revision, format, document FROM s;
  CREATE TABLE step(marker TEXT NOT NULL, revision INTEGER NOT NULL, moves TEXT NOT NULL,
                    PRIMARY KEY(marker, revision)) WITHOUT ROWID;
  INSERT INTO step SELECT 'm' || marker, revision, moves FROM t;
  CREATE TABLE answer(serial INTEGER PRIMARY KEY AUTOINCREMENT, marker TEXT NOT NULL, op TEXT NOT NULL,
                      method TEXT NOT NULL, result TEXT NOT NULL);
  CREATE INDEX answers_of_a_marker ON answer(marker, serial);
  INSERT INTO answer(marker, op, method, result) SELECT 'm' || marker, op, method, result FROM a;
  CREATE TABLE history(marker TEXT NOT NULL, serial INTEGER NOT NULL, way INTEGER NOT NULL, format TEXT NOT NULL,
                       step TEXT NOT NULL, PRIMARY KEY(marker, serial)) WITHOUT ROWID;
  INSERT INTO history SELECT 'm' || marker, serial, way, format, step FROM h;
  DROP TABLE s; DROP TABLE t; DROP TABLE h; DROP TABLE a; DROP TABLE head; DROP TABLE total;
  DROP TABLE library; DROP TABLE library_document;
  PRAGMA user_version = 2;
)";

constexpr const char* kIntoSchema3 = "DROP TABLE library; DROP TABLE library_document; PRAGMA user_version = 3";

rlimit file_size_limit() {
  rlimit limit{};
  ::getrlimit(RLIMIT_FSIZE, &limit);
  return limit;
}
void set_file_size_limit(const rlimit& limit) {
  ::setrlimit(RLIMIT_FSIZE, &limit);
}

class JournalTest : public ::testing::Test {
 protected:
  JournalTest() {
    std::string name = (std::filesystem::temp_directory_path() / "selvage-store-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~JournalTest() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string path() const { return (folder_ / "store.db").string(); }
  // The content of all open markers, as text.
  static std::string all_of(LocalServer& local) {
    std::string text = local.ask(call(1, "marker.list"));
    const Json list = Json::parse(text);
    for (const Json& marker : list["result"]["markers"]) {
      text += local.ask(call(1, "marker.get", R"({"markerId":)" + protocol::json::to_text(marker["markerId"]) + "}"));
    }
    return text;
  }

  std::filesystem::path folder_;
};

TEST_F(JournalTest, RestoresEverything) {
  std::string before;
  std::string answered;
  const std::string retry = call(1, "motion.compact", R"({"markerId":"m1","opId":"mine"})");
  {
    server::store::Journal journal{path(), server::store::Durability::kFull};
    LocalServer local{0, pushing_methods(), {}, &journal};
    for (int i = 0; i < 3; ++i) (void)local.open_small();
    answered = local.ask(retry);
    (void)local.result("marker.apply", R"({'markerId':'m1','ops':[{'op':'lock','piece':'low'},
        {'op':'move','piece':'high','at':[0.125,5]}]})");
    (void)local.result("marker.apply", R"({'markerId':'m3','ops':[{'op':'setSpacing','spacing':0.5},
        {'op':'add','piece':{'id':'new','shape':'tri','at':[5,5],'attributes':{'colour':'red'}},
         'shape':{'id':'tri','outline':[[0,0],[1,0],[0,1]],'rotations':'any','tilt_limit':3}},
        {'op':'tilt','piece':'new','to':1.5},{'op':'rotate','piece':'new','to':33}]})");
    (void)local.result("marker.close", "{'markerId':'m2'}");
    before = all_of(local);
  }
  server::store::Journal journal{path(), server::store::Durability::kFull};
  LocalServer local{0, pushing_methods(), {}, &journal};
  EXPECT_EQ(all_of(local), before);
  EXPECT_EQ(local.ask(retry), answered);
  EXPECT_EQ(local.open_small(), "m4");  // m2 is never used twice
}

// Two servers get the same calls; one of them is restarted every few calls.
TEST_F(JournalTest, RestoresTheUndoAndRedoHistory) {
  std::mt19937 random{20'26};
  const auto some_call = [&random](int number) -> std::pair<std::string, std::string> {
    const std::string n = std::to_string(number);
    switch (random() % 8) {
      case 0:
      case 1:
      case 2: return {"marker.undo", "{'markerId':'m1'}"};
      case 3: return {"marker.redo", "{'markerId':'m1'}"};
      case 4:
        return {"marker.apply", "{'markerId':'m1','ops':[{'op':'add','piece':{'id':'n" + n + "','shape':'t" + n +
                                    "','at':[5,5]},'shape':{'id':'t" + n + "','outline':[[0,0],[1,0],[0,1]]}}]}"};
      case 5: return {"motion.compact", "{'markerId':'m1'}"};
      default: return {"marker.apply", "{'markerId':'m1','ops':[{'op':'move','piece':'low','at':[" + n + ".25,0]}]}"};
    }
  };
  LocalServer steady;
  (void)steady.open_small();
  {
    server::store::Journal journal{path(), server::store::Durability::kRelaxed};
    LocalServer local{0, pushing_methods(), {}, &journal};
    (void)local.open_small();
  }
  for (int start = 0; start < 60; ++start) {
    server::store::Journal journal{path(), server::store::Durability::kRelaxed};
    LocalServer local{0, pushing_methods(), {}, &journal};
    for (int k = 0; k < 5; ++k) {
      const auto [method, params] = some_call(5 * start + k);
      ASSERT_EQ(local.result(method, params), steady.result(method, params)) << method << params;
    }
    ASSERT_EQ(all_of(local), all_of(steady));
  }
}

TEST_F(JournalTest, ARestoredHistoryKeepsItsLimits) {
  {
    server::store::Journal journal{path(), server::store::Durability::kRelaxed};
    LocalServer local{0, pushing_methods(), {}, &journal};
    (void)local.open_small();
    for (std::size_t i = 0; i < server::store::History::kMaxSteps + 50; ++i) {
      (void)local.result("marker.apply",
                         "{'markerId':'m1','ops':[{'op':'move','piece':'low','at':[" + std::to_string(i) + ".25,0]}]}");
    }
  }
  server::store::Journal journal{path(), server::store::Durability::kRelaxed};
  LocalServer local{0, pushing_methods(), {}, &journal};
  std::size_t undone = 0;
  while (local.result("marker.undo", "{'markerId':'m1'}").contains("revision")) ++undone;
  EXPECT_EQ(undone, server::store::History::kMaxSteps);
}

TEST_F(JournalTest, AMarkerWithADamagedRowIsQuarantinedAndTheOthersServe) {
  const std::vector<std::pair<std::string, std::string>> damages{
      {"UPDATE step SET moves = substr(moves, 1, 20) WHERE marker = 1 AND revision = 3", "revision 3"},
      {"DELETE FROM step WHERE marker = 1 AND revision = 3", "revision 3"},
      {"DELETE FROM step WHERE marker = 1 AND revision = 5", "revision 5"},
      {"UPDATE step SET marker = 2 WHERE marker = 1 AND revision = 5", "revision 5"},
      {"UPDATE history SET way = 1 - way WHERE marker = 1 AND serial = 2", "history"},
      {"DELETE FROM history WHERE marker = 1 AND serial = 2", "history"},
      {"UPDATE answer SET result = '{}' WHERE marker = 1", "answer"},
      {"DELETE FROM answer WHERE marker = 1", "answers"},
      {"UPDATE snapshot SET document = replace(document, 'low', 'lov') WHERE marker = 1", "snapshot"},
      {"DELETE FROM snapshot WHERE marker = 1", "snapshot"},
      {"DELETE FROM head WHERE marker = 1", "head"},
      {"UPDATE head SET revision = 4 WHERE marker = 1", "head"}};
  const std::string sound = (folder_ / "sound.db").string();
  std::string second;
  {
    server::store::Journal journal{sound, server::store::Durability::kFull};
    LocalServer local{0, pushing_methods(), {}, &journal};
    (void)local.open_small();
    (void)local.open_small();
    for (int x = 1; x <= 4; ++x) {
      (void)local.result("marker.apply", "{'markerId':'m1','opId':'" + std::to_string(x) +
                                             "','ops':[{'op':'move','piece':'low','at':[" + std::to_string(x) +
                                             ",0]}]}");
    }
    second = local.ask(call(1, "marker.get", R"({"markerId":"m2"})"));
  }
  for (const auto& [damage, named] : damages) {
    std::filesystem::copy_file(sound, path(), std::filesystem::copy_options::overwrite_existing);
    server::store::disk::Database{path()}.run(damage);
    server::store::Journal journal{path(), server::store::Durability::kFull};
    LocalServer local{0, pushing_methods(), {}, &journal};
    const Json answer = local.result("marker.get", "{'markerId':'m1'}");
    EXPECT_EQ(code_of(answer), -32012) << damage;
    EXPECT_NE(answer["error"]["message"].text().find(named), std::string::npos) << damage << answer;
    if (damage.find("marker = 2") != std::string::npos) continue;  // m2 has a row that is not its own
    EXPECT_EQ(local.ask(call(1, "marker.get", R"({"markerId":"m2"})")), second) << damage;
    EXPECT_EQ(local.result("marker.list", "{}")["markers"].size(), 1U) << damage;
    EXPECT_EQ(local.open_small(), "m3") << damage;
    EXPECT_EQ(local.result("marker.close", "{'markerId':'m1'}")["closed"], true) << damage;
    EXPECT_EQ(local.store().quarantined(), 0U) << damage;
  }
}

TEST_F(JournalTest, StoresOfEarlierSchemasAreUpgradedAndCopiedBefore) {
  const std::string retry = call(1, "motion.compact", R"({"markerId":"m2","opId":"mine"})");
  for (const int schema : {1, 2, 3}) {
    const std::string file = (folder_ / ("schema" + std::to_string(schema))).string();
    std::string before;
    std::string answered;
    {
      server::store::Journal journal{file, server::store::Durability::kFull};
      LocalServer local{0, pushing_methods(), {}, &journal};
      for (int i = 0; i < 3; ++i) (void)local.open_small();
      answered = local.ask(retry);
      (void)local.result("marker.close", "{'markerId':'m3'}");
      before = all_of(local);
    }
    server::store::disk::Database{file}.run(schema == 3 ? kIntoSchema3 : kIntoSchema2);
    if (schema == 1) server::store::disk::Database{file}.run("DROP TABLE history; PRAGMA user_version = 1");
    for (int start = 0; start < 2; ++start) {
      server::store::Journal journal{file, server::store::Durability::kFull};
      LocalServer local{0, pushing_methods(), {}, &journal};
      EXPECT_EQ(all_of(local), before);
      EXPECT_EQ(local.ask(retry), answered);
      EXPECT_EQ(local.store().peek("m2", server::store::UndoDirection::kUndo)->undo_steps, schema == 1 ? 0U : 1U);
      EXPECT_EQ(local.open_small(), "m" + std::to_string(4 + start));
      (void)local.result("marker.close", "{'markerId':'m" + std::to_string(4 + start) + "'}");
    }
    const std::string copy = file + ".schema" + std::to_string(schema);
    EXPECT_EQ(server::store::disk::Database{copy}.number("PRAGMA user_version"), schema);
    EXPECT_EQ(server::store::disk::Database{copy}.number("SELECT count(*) FROM snapshot"), 2);
  }
}

TEST_F(JournalTest, AStoreIsRecognisedAfterARestart) {
  const auto instance = [](server::store::Journal* journal) {
    LocalServer local{0, pushing_methods(), {}, journal};
    return local.result("engine.info", "{}")["instance"].get<std::string>();
  };
  const auto of_store = [&](const std::string& file) {
    server::store::Journal journal{file, server::store::Durability::kFull};
    return instance(&journal);
  };
  const std::string first = of_store(path());
  EXPECT_EQ(of_store(path()), first);
  EXPECT_NE(of_store(path() + ".other"), first);
  server::store::disk::Database{path()}.run("PRAGMA application_id = 0");  // as in stores of earlier versions
  const std::string numbered = of_store(path());
  EXPECT_EQ(of_store(path()), numbered);
  EXPECT_NE(instance(nullptr), instance(nullptr));
}

TEST_F(JournalTest, AStoreOfALaterVersionIsRefused) {
  { const server::store::Journal journal{path(), server::store::Durability::kFull}; }
  server::store::disk::Database{path()}.run("PRAGMA user_version = 5");
  EXPECT_THROW(server::store::Journal(path(), server::store::Durability::kFull), server::store::disk::NewerStore);
}

TEST_F(JournalTest, ManyStepsAndSnapshotsRestoreTheSameMarker) {
  std::string before;
  {
    server::store::Journal journal{path(), server::store::Durability::kRelaxed};
    LocalServer local{0, pushing_methods(), {}, &journal};
    (void)local.open_small();
    for (int i = 0; i < 1500; ++i) {
      (void)local.result("marker.apply", "{'markerId':'m1','opId':'" + std::to_string(i) +
                                             "','ops':[{'op':'move','piece':'low','at':[" + std::to_string(i % 77) +
                                             ".25,0]}]}");
    }
    before = all_of(local);
  }
  EXPECT_LT(std::filesystem::file_size(path()), 4U << 20);  // snapshots replace steps
  server::store::Journal journal{path(), server::store::Durability::kRelaxed};
  LocalServer local{0, pushing_methods(), {}, &journal};
  EXPECT_EQ(all_of(local), before);
  EXPECT_FALSE(local.store().answer("m1", std::to_string(1499 - server::store::KeptAnswers::kMost)));
  EXPECT_TRUE(local.store().answer("m1", "1499"));
}

TEST_F(JournalTest, IdsAreNotUsedAgainWhenTheirCountIsDamaged) {
  {
    server::store::Journal journal{path(), server::store::Durability::kFull};
    LocalServer local{0, pushing_methods(), {}, &journal};
    for (int i = 0; i < 3; ++i) (void)local.open_small();
  }
  server::store::disk::Database{path()}.run("UPDATE total SET opened = 0, markers = 7");
  server::store::Journal journal{path(), server::store::Durability::kFull};
  LocalServer local{0, pushing_methods(), {}, &journal};
  EXPECT_EQ(local.store().count(), 3U);
  EXPECT_EQ(local.open_small(), "m4");
}

TEST_F(JournalTest, AClosingThatIsNotWrittenIsAnError) {
  server::store::Journal journal{path(), server::store::Durability::kFull};
  LocalServer local{0, pushing_methods(), {}, &journal};
  (void)local.open_small();
  EXPECT_EQ(local.backend.why_not_ready(), "");
  std::filesystem::remove(path());
  EXPECT_NE(local.backend.why_not_ready().find(path() + " has been deleted"), std::string::npos);
  for (const char* method : {"marker.close", "motion.compact"}) {
    EXPECT_EQ(code_of(local.result(method, "{'markerId':'m1','opId':'a'}")), -32603) << method;
  }
  EXPECT_EQ(code_of(local.result("marker.open", "{'marker':" + kSmallMarker + "}")), -32603);
  EXPECT_EQ(local.result("marker.get", "{'markerId':'m1'}")["revision"], 1);
}

TEST_F(JournalTest, AWriteErrorMakesTheServerUnreadyUntilAWriteSucceeds) {
  server::store::Journal journal{path(), server::store::Durability::kFull};
  LocalServer local{0, pushing_methods(), {}, &journal};
  (void)local.open_small();
  const rlimit unlimited = file_size_limit();
  std::signal(SIGXFSZ, SIG_IGN);
  set_file_size_limit({1000, unlimited.rlim_max});  // as on a full disk
  EXPECT_EQ(code_of(local.result("motion.compact", "{'markerId':'m1'}")), -32603);
  EXPECT_EQ(code_of(local.result("marker.close", "{'markerId':'m1'}")), -32603);
  EXPECT_EQ(journal.writes().written, 1U);
  EXPECT_EQ(journal.writes().failed, 2U);
  EXPECT_NE(local.backend.why_not_ready().find("the store cannot be written"), std::string::npos);
  set_file_size_limit(unlimited);
  EXPECT_EQ(local.result("motion.compact", "{'markerId':'m1'}")["revision"], 2);
  EXPECT_EQ(local.backend.why_not_ready(), "");
  EXPECT_EQ(journal.writes().written, 2U);
  EXPECT_GT(journal.writes().seconds, 0);
}

TEST_F(JournalTest, AMarkerForWhichThereIsNoRoomIsNotReadUntilThereIs) {
  const std::size_t before = [&] {
    server::store::Journal journal{path(), server::store::Durability::kRelaxed};
    LocalServer local{0, pushing_methods(), {}, &journal};
    for (int i = 0; i < 50; ++i) (void)local.open_small();
    return local.store().room().account->held();
  }();
  server::store::Journal journal{path(), server::store::Durability::kRelaxed};
  server::calls::Limits limits;
  limits.markers_bytes = before * 9 / 10;
  LocalServer local{0, pushing_methods(), limits, &journal};
  EXPECT_LT(local.store().room().account->held(), before);  // rows are smaller than what is made of them
  const auto get = [&](int k) { return local.result("marker.get", "{'markerId':'m" + std::to_string(k) + "'}"); };
  int read = 0;
  while (read < 50 && get(read + 1).contains("marker")) ++read;
  EXPECT_GT(read, 0);
  ASSERT_LT(read, 50);
  EXPECT_EQ(code_of(get(read + 1)), -32013);
  EXPECT_LE(local.store().room().account->held(), limits.markers_bytes);
  EXPECT_EQ(local.result("marker.list", "{}")["markers"].size(), 50U);
  for (int k = 1; k <= 10; ++k) (void)local.result("marker.close", "{'markerId':'m" + std::to_string(k) + "'}");
  EXPECT_TRUE(get(read + 1).contains("marker"));
}

TEST_F(JournalTest, KeptAnswersTakeBoundedRoom) {
  const auto kept = static_cast<std::int64_t>(server::store::KeptAnswers::kMost);
  {
    server::store::Journal journal{path(), server::store::Durability::kRelaxed};
    LocalServer local{0, pushing_methods(), {}, &journal};
    (void)local.open_small();
    for (int i = 0; i < 2 * kept; ++i) {  // calls that change nothing
      (void)local.result("marker.apply", "{'markerId':'m1','opId':'" + std::to_string(i) +
                                             "','ops':[{'op':'move','piece':'low','at':[3,0]}]}");
    }
    EXPECT_EQ(local.store().current("m1")->revision, 1U);
    EXPECT_TRUE(local.store().answer("m1", std::to_string(2 * kept - 1)));
  }
  EXPECT_EQ(server::store::disk::Database{path()}.number("SELECT count(*) FROM answer"), kept);
}

TEST_F(JournalTest, AnIncompleteEndOfTheFileIsIgnored) {
  const std::string log = path() + "-wal";
  const std::string incomplete = (folder_ / "incomplete.db").string();
  {
    server::store::Journal journal{path(), server::store::Durability::kFull};
    LocalServer local{0, pushing_methods(), {}, &journal};
    (void)local.open_small();
    (void)local.result("motion.compact", "{'markerId':'m1'}");
    (void)local.result("motion.compact", "{'markerId':'m1'}");
    // As after a crash in the middle of the last write.
    std::filesystem::copy(path(), incomplete);
    std::filesystem::copy(log, incomplete + "-wal");
  }
  std::filesystem::resize_file(incomplete + "-wal", std::filesystem::file_size(incomplete + "-wal") - 100);
  server::store::Journal journal{incomplete, server::store::Durability::kFull};
  LocalServer local{0, pushing_methods(), {}, &journal};
  EXPECT_EQ(local.store().current("m1")->revision, 2U);
  EXPECT_EQ(local.result("motion.compact", "{'markerId':'m1'}")["revision"], 3);
}

TEST_F(JournalTest, RefusesFilesThatAreNotStores) {
  std::ofstream{path()} << "this is no database, and is long enough to be seen as none";
  EXPECT_THROW(server::store::Journal(path(), server::store::Durability::kFull), std::runtime_error);
  EXPECT_THROW(server::store::Journal((folder_ / "no" / "where").string(), server::store::Durability::kFull),
               std::runtime_error);
  const std::string empty = (folder_ / "empty.db").string();
  std::ofstream{empty}.flush();
  EXPECT_THROW(server::store::Journal(empty, server::store::Durability::kFull), std::runtime_error);
  const std::string other = (folder_ / "other.db").string();
  server::store::disk::Database{other}.run("CREATE TABLE theirs(x)");
  EXPECT_THROW(server::store::Journal(other, server::store::Durability::kFull), std::runtime_error);
  const std::string mine = (folder_ / "mine.db").string();
  server::store::Journal first{mine, server::store::Durability::kFull};
  EXPECT_THROW(server::store::Journal(mine, server::store::Durability::kFull),
               std::runtime_error);  // one daemon at a time
}

TEST_F(JournalTest, AStoreThatCannotBeWrittenChangesNothing) {
  server::store::Journal journal{path(), server::store::Durability::kFull};
  LocalServer local{0, pushing_methods(), {}, &journal};
  (void)local.open_small();
  Client watching;
  (void)local.ask(call(1, "marker.watch", R"({"markerId":"m1"})"), watching.session());
  // The store cannot write a revision that it already contains.
  {
    server::store::Committed now = *local.store().current("m1");
    const std::optional<protocol::edits::Moves> moves = protocol::edits::Moves{{0, now.file->marker.pieces[0]}};
    const auto recorded = server::store::History{}.record(server::store::Origin::kChange, now.file, moves);
    ASSERT_TRUE(journal.changed(1, {2, moves, *now.file, "", recorded, std::nullopt}));
  }
  EXPECT_EQ(code_of(local.result("motion.compact", "{'markerId':'m1'}")), -32603);
  EXPECT_EQ(local.store().current("m1")->revision, 1U);
  EXPECT_EQ(watching.pending(), 0U);
}

}  // namespace
}  // namespace selvage::test
