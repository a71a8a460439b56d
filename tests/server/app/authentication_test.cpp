#include "server/app/authentication.h"

#include <gtest/gtest.h>

#include "protocol/json/json_text.h"

namespace selvage::server::app {
namespace {

const transport::access::Access kAccess{.token = "correct horse"};

TEST(Authentication, TheTokenIsAccepted) {
  const transport::access::Authentication result = authenticate_first_message(
      R"({"jsonrpc":"2.0","id":7,"method":"auth","params":{"token":"correct horse"}})", kAccess);
  EXPECT_TRUE(result.granted);
  EXPECT_EQ(result.answer, R"({"jsonrpc":"2.0","id":7,"result":{"authorised":true}})");
  const transport::access::Authentication silent =
      authenticate_first_message(R"({"jsonrpc":"2.0","method":"auth","params":{"token":"correct horse"}})", kAccess);
  EXPECT_TRUE(silent.granted);
  EXPECT_EQ(silent.answer, "");
}

TEST(Authentication, AnythingElseIsRefused) {
  for (const auto* line : {"", "{", "null", "correct horse", R"({"jsonrpc":"2.0","id":1,"method":"engine.info"})",
                           R"({"jsonrpc":"2.0","id":1,"method":"auth"})",
                           R"({"jsonrpc":"2.0","id":1,"method":"auth","params":["correct horse"]})",
                           R"({"jsonrpc":"2.0","id":1,"method":"auth","params":{"token":1}})",
                           R"({"jsonrpc":"2.0","id":1,"method":"auth","params":{"token":""}})",
                           R"({"jsonrpc":"2.0","id":1,"method":"auth","params":{"token":"correct"}})",
                           R"({"jsonrpc":"2.0","id":1,"method":"auth","params":{"token":"correct horse","more":1}})",
                           R"([{"jsonrpc":"2.0","id":1,"method":"auth","params":{"token":"correct horse"}}])"}) {
    const transport::access::Authentication result = authenticate_first_message(line, kAccess);
    EXPECT_FALSE(result.granted) << line;
    EXPECT_EQ(Json::parse(result.answer)["error"]["code"], -32015) << line;
    EXPECT_EQ(result.answer.find("horse"), std::string::npos) << result.answer;
  }
}

}  // namespace
}  // namespace selvage::server::app
