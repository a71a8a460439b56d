// Orders in the tables of European spreadsheets: sizes in rows, lists, decimal commas, headings in other languages.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "protocol/trade/orders/order.h"

namespace selvage {
namespace {

using protocol::trade::orders::Order;
using protocol::trade::orders::Quantity;
using protocol::trade::orders::read_order;

const std::vector<Quantity> kOrdered{{"rot", "S", 10}, {"rot", "M", 20}, {"blau", "S", 5}, {"blau", "M", 0}};

bool notes(const Order& order, const std::string& text) {
  for (const Note& note : order.notes) {
    if ((note.field + ": " + note.text).find(text) != std::string::npos) return true;
  }
  return false;
}

// The garments of a colour and size; -1 when the order has no such quantity.
int garments(const Order& order, const std::string& colour, const std::string& size) {
  for (const Quantity& one : order.quantities) {
    if (one.colour == colour && one.size == size) return one.garments;
  }
  return -1;
}

TEST(OrderTables, MayHaveTheirSizesInRows) {
  for (const char* table :
       {"Größe;rot;blau\r\nS;10;5\r\nM;20,0;0\r\n",
        "Gr\xf6\xdf"
        "e;rot;blau\nS;10,00;5\nM;20;0\n",
        "taille,rot,blau\nS,10,5\nM,20,0\n", "size\trot\tblau\tTotal\nS\t10\t5\t15\nM\t20\t0\t20\nSumme\t30\t5\t35\n",
        ";rot;blau\nS;10;5\nM;20;0\n", "Style;Size;rot;blau\nA7;S;10;5\nA7;M;20;0\n"}) {
    const auto order = read_order(table);
    ASSERT_TRUE(order) << table << order.error().message;
    for (const Quantity& one : kOrdered) EXPECT_EQ(garments(*order, one.colour, one.size), one.garments) << table;
    const std::vector<std::pair<std::string, int>> ratio{{"S", 3}, {"M", 4}};
    EXPECT_EQ(order->ratio, ratio) << table;
    EXPECT_TRUE(notes(*order, "/line/1: the sizes are read from the rows")) << table;
  }
}

TEST(OrderTables, MayBeLists) {
  for (const char* table : {"Farbe;Größe;Menge\nrot;S;10\nrot;M;20,0\nblau;S;5\nblau;M;0\n",
                            "Menge;Artikel;Farbe;Größe\n10;A;rot;S\n20;A;rot;M\n5;A;blau;S\n0;A;blau;M\n",
                            "variant,size,qty\nrot,S,10\nrot,M,20\nblau,S,5\nblau,M,0\n"}) {
    const auto order = read_order(table);
    ASSERT_TRUE(order) << table << order.error().message;
    EXPECT_EQ(order->quantities, kOrdered) << table;
  }
  const auto plain = read_order("size;quantity\n36;10\n38;20\n");
  ASSERT_TRUE(plain);
  EXPECT_EQ(garments(*plain, "", "38"), 20);
}

TEST(OrderTables, NumbersMayHaveDecimalCommasAndMarksOfThousands) {
  for (const auto& [cell, expected] : {std::pair{"1.200,00", 1200},
                                       {"1200,0", 1200},
                                       {"1.200,000", 1200},
                                       {"1\xc2\xa0"
                                        "200",
                                        1200},
                                       {"1\xe2\x80\xaf"
                                        "200,00",
                                        1200},
                                       {"7,00", 7},
                                       {"7.0", 7},
                                       {"0,0", 0}}) {
    const auto order = read_order("Farbe;S;M\nrot;" + std::string{cell} + ";1\n");
    ASSERT_TRUE(order) << cell << order.error().message;
    EXPECT_EQ(garments(*order, "rot", "S"), expected) << cell;
  }
  EXPECT_TRUE(notes(*read_order("Farbe;S\nrot;12,000\n"), "/line/2: \"12,000\" is read as 12000"));
}

TEST(OrderTables, WithMistakesAreRefused) {
  for (const auto& [table, field] : {std::pair{"Größe;rot\nS;10,5\n", "/line/2"},
                                     {"Größe;rot\n;10\n", "/line/2"},
                                     {"Farbe;Größe\nrot;S\n", "/line/1"},
                                     {"Farbe;Größe;Menge\nrot;S;viele\n", "/line/2"},
                                     {"Größe;rot\nS;1;2\n", "/line/2"}}) {
    const auto order = read_order(table);
    ASSERT_FALSE(order) << table;
    EXPECT_EQ(order.error().field, field) << table;
  }
}

TEST(OrderTables, SizesInColumnsStayThere) {
  for (const char* table : {"colour;36;38\n101;1;2\n", "Farbe;S;M\nrot;1;2\n", ";S;M\nL;1;2\n"}) {
    const auto order = read_order(table);
    ASSERT_TRUE(order) << table << order.error().message;
    EXPECT_FALSE(notes(*order, "the sizes are read from the rows")) << table;
  }
}

TEST(OrderTables, NoteWhatIsOrderedTwiceAndColumnsThatMayBeNoSizes) {
  const auto same = read_order("colour,S,S,M\nred,1,2,0\nblue,3,0,1\n");
  ASSERT_TRUE(same);
  EXPECT_TRUE(notes(*same, "/line/2: garments of colour \"red\" and size \"S\" are ordered again"));
  EXPECT_FALSE(notes(*same, "\"blue\""));
  const auto list = read_order("colour;size;quantity\nred;S;1\nred;S;2\n");
  ASSERT_TRUE(list);
  EXPECT_TRUE(notes(*list, "/line/3: garments of colour \"red\" and size \"S\" are ordered again"));
  const auto remark = read_order("colour,S,XL,remark\nred,1,,\n");
  ASSERT_TRUE(remark);
  EXPECT_TRUE(notes(*remark, "/line/1: no garments are ordered in the column \"remark\""));
  EXPECT_FALSE(notes(*remark, "\"XL\""));
}

TEST(OrderTables, NotesThatDoNotConcernTheRatioStayInPlans) {
  const auto order = read_order("colour;size;quantity;price\nred;S;1;9\nred;M;2;9\n");
  ASSERT_TRUE(order);
  EXPECT_TRUE(notes(*order, "the order gives no ratio"));
  const auto planned = one_of_each_size(*order);
  ASSERT_TRUE(planned);
  EXPECT_FALSE(notes(*planned, "the order gives no ratio"));
  EXPECT_TRUE(notes(*planned, "/line/1: the column \"price\" is left out"));
}

}  // namespace
}  // namespace selvage
