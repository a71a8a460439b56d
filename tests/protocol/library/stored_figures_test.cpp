#include "protocol/library/stored_figures.h"

#include <gtest/gtest.h>

#include "protocol/json/json_text.h"
#include "tests/support/garment.h"

namespace selvage::protocol::library {
namespace {

TEST(StoredFigures, AreReadAsTheyWereWritten) {
  const Marker marker = test::garment("jeans_02g");
  const StoredFigures figures = stored_figures_of(marker);
  EXPECT_EQ(figures.utilisation, utilisation_of(marker));
  EXPECT_EQ(figures.signature.pieces, 40);
  const auto document = json::parse(json::to_text(figures_document(figures)));
  ASSERT_TRUE(document);
  EXPECT_EQ(read_stored_figures(*document), figures);
}

TEST(StoredFigures, AreNotReadFromOtherDocuments) {
  const Json good = figures_document(stored_figures_of(test::garment("jeans_02g")));
  EXPECT_FALSE(read_stored_figures(Json::array()));
  EXPECT_FALSE(read_stored_figures(Json::object()));
  for (const char* name : {"name", "length", "utilisation", "unit", "width", "spacing", "pieces", "area", "spread"}) {
    Json wrong = good;
    wrong[name] = Json::array();
    EXPECT_FALSE(read_stored_figures(wrong)) << name;
    wrong[name] = nullptr;
    EXPECT_FALSE(read_stored_figures(wrong)) << name;
  }
}

}  // namespace
}  // namespace selvage::protocol::library
