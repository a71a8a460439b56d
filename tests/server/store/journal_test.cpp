// The journal restores what was acknowledged and removes what cannot be read.
#include "server/store/journal.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "server/store/journal_database.h"
#include "tests/server/dispatch/local_server.h"

namespace selvage::test {
namespace {

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

TEST_F(JournalTest, AHistoryIsCutOffWhereItCannotBeRead) {
  {
    server::store::Journal journal{path(), server::store::Durability::kFull};
    LocalServer local{0, pushing_methods(), {}, &journal};
    (void)local.open_small();
    for (int x = 1; x <= 4; ++x) {
      (void)local.result("marker.apply",
                         "{'markerId':'m1','ops':[{'op':'move','piece':'low','at':[" + std::to_string(x) + ",0]}]}");
    }
    (void)local.result("marker.undo", "{'markerId':'m1'}");
  }
  server::store::Database{path()}.run("UPDATE history SET step = substr(step, 1, 20) WHERE way = 0 AND serial = 2");
  for (int start = 0; start < 2; ++start) {  // the second start finds nothing to remove
    server::store::Journal journal{path(), server::store::Durability::kFull};
    LocalServer local{0, pushing_methods(), {}, &journal};
    const auto undo = local.store().peek("m1", server::store::UndoDirection::kUndo);
    EXPECT_EQ(undo->undo_steps, 1U);
    EXPECT_EQ(undo->redo_steps, 1U);
  }
}

TEST_F(JournalTest, AStoreWithoutHistoryIsUpgraded) {
  std::string before;
  {
    server::store::Journal journal{path(), server::store::Durability::kFull};
    LocalServer local{0, pushing_methods(), {}, &journal};
    (void)local.open_small();
    (void)local.result("motion.compact", "{'markerId':'m1'}");
    before = all_of(local);
  }
  server::store::Database{path()}.run("DROP TABLE history; PRAGMA user_version = 1");
  for (std::size_t start = 0; start < 2; ++start) {
    server::store::Journal journal{path(), server::store::Durability::kFull};
    LocalServer local{0, pushing_methods(), {}, &journal};
    EXPECT_EQ(local.store().peek("m1", server::store::UndoDirection::kUndo)->undo_steps, start);
    if (start > 0) break;
    EXPECT_EQ(all_of(local), before);
    (void)local.result("motion.compact", "{'markerId':'m1'}");
  }
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

TEST_F(JournalTest, StepsAfterAMissingRevisionAreRemoved) {
  {
    server::store::Journal journal{path(), server::store::Durability::kFull};
    LocalServer local{0, pushing_methods(), {}, &journal};
    (void)local.open_small();
    for (int i = 0; i < 3; ++i) (void)local.result("motion.compact", "{'markerId':'m1'}");
  }
  {
    server::store::Database database{path()};
    database.run("UPDATE step SET moves = substr(moves, 1, 20) WHERE revision = 3");
  }
  for (int start = 0; start < 2; ++start) {  // the second start finds nothing to remove
    server::store::Journal journal{path(), server::store::Durability::kFull};
    LocalServer local{0, pushing_methods(), {}, &journal};
    EXPECT_EQ(local.store().current("m1")->revision, 2U);
    EXPECT_EQ(local.result("marker.check", "{'markerId':'m1'}")["valid"], true);
    EXPECT_EQ(code_of(local.result("marker.undo", "{'markerId':'m1'}")), -32000);
  }
  server::store::Journal journal{path(), server::store::Durability::kFull};
  LocalServer local{0, pushing_methods(), {}, &journal};
  EXPECT_EQ(local.result("motion.compact", "{'markerId':'m1'}")["revision"], 3);
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
  const std::string other = (folder_ / "other.db").string();
  server::store::Database{other}.run("CREATE TABLE theirs(x)");
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
    ASSERT_TRUE(journal.changed("m1", {2, moves, *now.file, recorded, std::nullopt}));
  }
  EXPECT_EQ(code_of(local.result("motion.compact", "{'markerId':'m1'}")), -32603);
  EXPECT_EQ(local.store().current("m1")->revision, 1U);
  EXPECT_EQ(watching.pending(), 0U);
}

}  // namespace
}  // namespace selvage::test
