// The library of stored markers, in memory and in the store's file.
#include "server/library/library.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include "protocol/formats/format.h"
#include "server/store/disk/database.h"
#include "server/store/verification.h"
#include "tests/server/store/temporary_folder.h"

namespace selvage::server::library {
namespace {

using store::Durability;
using store::Journal;

// A valid marker of two rectangles.
MarkerFile file_of(const std::string& name, int height) {
  const std::string h = std::to_string(height);
  return *protocol::formats::read_marker(R"({"format":"selvage-marker","version":1,"name":")" + name +
                                         R"(","strip":{"width":100},
         "shapes":[{"id":"r","outline":[[0,0],[40,0],[40,)" +
                                         h + "],[0," + h + R"(]]}],
         "pieces":[{"id":"a","shape":"r","at":[0,0]},{"id":"b","shape":"r","at":[40,0]}]})");
}

std::uint64_t added(Library& library, const MarkerFile& file, const std::string& style = "") {
  const auto outcome = library.add(file, style);
  EXPECT_TRUE(std::holds_alternative<Added>(outcome));
  return std::get<Added>(outcome).entry.number;
}

TEST(Library, ContainsAddedMarkers) {
  Library library;
  EXPECT_EQ(added(library, file_of("one", 40), "boxes"), 1U);
  const auto entry = library.find(1);
  ASSERT_TRUE(entry);
  EXPECT_EQ(id_of(*entry), "s1");
  EXPECT_EQ(entry->name, "one");
  EXPECT_EQ(entry->style, "boxes");
  EXPECT_EQ(entry->length, 80);
  EXPECT_DOUBLE_EQ(entry->utilisation, 0.4);
  const auto document = library.document(1);
  ASSERT_TRUE(document);
  EXPECT_EQ(protocol::formats::read_marker(*document)->marker, file_of("one", 40).marker);
  EXPECT_FALSE(library.find(2));
  EXPECT_FALSE(library.document(2));
}

TEST(Library, StoresTheSameMarkerOnce) {
  Library library;
  EXPECT_EQ(added(library, file_of("one", 40)), 1U);
  const auto again = library.add(file_of("one", 40), "");
  EXPECT_FALSE(std::get<Added>(again).fresh);
  EXPECT_EQ(std::get<Added>(again).entry.number, 1U);
  EXPECT_EQ(added(library, file_of("one", 40), "another style"), 2U);
  EXPECT_EQ(library.count(), 2U);
}

TEST(Library, FindsTheNearest) {
  Library library;
  for (const int height : {20, 48, 40}) (void)added(library, file_of("h" + std::to_string(height), height));
  const auto near = library.search(file_of("order", 41).marker, 2);
  ASSERT_EQ(near.size(), 2U);
  EXPECT_EQ(near[0].entry.name, "h40");
  EXPECT_EQ(near[1].entry.name, "h48");
  EXPECT_LT(near[0].distance, near[1].distance);
  EXPECT_EQ(library.search(file_of("h48", 48).marker, 1)[0].distance, 0);
  const auto markers = library.markers_near(file_of("order", 41).marker, 5);
  ASSERT_EQ(markers.size(), 3U);
  EXPECT_EQ(markers[0].marker, file_of("h40", 40).marker);
}

TEST(Library, ListsPages) {
  Library library;
  for (int height = 10; height < 15; ++height) (void)added(library, file_of("m", height));
  EXPECT_EQ(library.list(0, 2).size(), 2U);
  EXPECT_EQ(library.list(4, 2).size(), 1U);
  EXPECT_EQ(library.list(4, 2)[0].number, 5U);
  EXPECT_TRUE(library.list(9, 2).empty());
}

TEST(Library, IdsAreNumbersAfterAnS) {
  EXPECT_EQ(number_of("s12"), 12U);
  for (const char* wrong : {"", "s", "m1", "s0", "s01", "s1x", "s-1", "s99999999999999999999999"}) {
    EXPECT_FALSE(number_of(wrong)) << wrong;
  }
}

TEST(Library, FiguresAreReadAsTheyWereWritten) {
  Entry entry = entry_of(file_of("one", 37).marker, "style \"x\"", "text");
  entry.number = 9;
  const auto read = read_figures(9, figures_text(entry));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->name, entry.name);
  EXPECT_EQ(read->style, entry.style);
  EXPECT_EQ(read->content, entry.content);
  EXPECT_EQ(read->utilisation, entry.utilisation);
  EXPECT_EQ(read->signature, entry.signature);
  for (const char* wrong : {"", "{}", "[]", R"({"name":1})"}) EXPECT_FALSE(read_figures(9, wrong)) << wrong;
}

class StoredLibrary : public ::testing::Test {
 protected:
  [[nodiscard]] std::string path() const { return (folder_.path() / "store.db").string(); }
  void damage(const std::string& sql) { store::disk::Database{path()}.run(sql); }

  test::TemporaryFolder folder_;
};

TEST_F(StoredLibrary, SurvivesTheEndOfTheProcess) {
  {
    Journal journal{path(), Durability::kFull};
    Library library{&journal};
    EXPECT_EQ(added(library, file_of("one", 40), "boxes"), 1U);
    EXPECT_EQ(added(library, file_of("two", 41)), 2U);
    EXPECT_EQ(library.remove(2), Removed::kDone);
    EXPECT_EQ(library.remove(2), Removed::kUnknown);
  }
  Journal journal{path(), Durability::kFull};
  Library library{&journal};
  EXPECT_EQ(library.count(), 1U);
  ASSERT_TRUE(library.find(1));
  EXPECT_EQ(library.find(1)->style, "boxes");
  EXPECT_EQ(library.markers_near(file_of("one", 40).marker, 1)[0].marker, file_of("one", 40).marker);
  EXPECT_EQ(added(library, file_of("three", 42)), 3U);  // numbers are never used again
  EXPECT_FALSE(std::get<Added>(library.add(file_of("one", 40), "boxes")).fresh);
}

TEST_F(StoredLibrary, LeavesOutDamagedMarkersAndNamesThem) {
  {
    Journal journal{path(), Durability::kFull};
    Library library{&journal};
    for (int height = 40; height < 43; ++height) (void)added(library, file_of("m", height));
  }
  damage("UPDATE library SET figures = replace(figures, '\"m\"', '\"n\"') WHERE number = 1");
  damage("UPDATE library_document SET document = replace(document, '41', '40') WHERE number = 2");
  const store::Verification found = store::verify_store(path());
  ASSERT_EQ(found.damage.size(), 2U);
  EXPECT_EQ(found.damage[0], "library marker s1: a damaged row");
  EXPECT_EQ(found.damage[1], "library marker s2: a damaged document");
  Journal journal{path(), Durability::kFull};
  Library library{&journal};
  EXPECT_FALSE(library.find(1));
  EXPECT_FALSE(library.document(2));
  EXPECT_EQ(library.markers_near(file_of("m", 41).marker, 3).size(), 1U);
}

TEST_F(StoredLibrary, NoticesAMissingDocument) {
  {
    Journal journal{path(), Durability::kFull};
    Library library{&journal};
    (void)added(library, file_of("m", 40));
  }
  damage("DELETE FROM library_document");
  EXPECT_EQ(store::verify_store(path()).damage.size(), 1U);
  Journal journal{path(), Durability::kFull};
  EXPECT_EQ(Library{&journal}.count(), 0U);
}

}  // namespace
}  // namespace selvage::server::library
