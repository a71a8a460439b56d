// protocol/README.md is correct: its examples work, and it lists exactly the error codes that exist.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/calls/answer.h"
#include "protocol/methods/method_table.h"
#include "protocol/rpc/json_rpc.h"
#include "tests/protocol/formats/samples.h"
#include "tests/support/repository.h"

namespace selvage::protocol::methods {
namespace {

// The documents of the fenced json blocks, in order.
std::vector<Json> examples(const std::string& text) {
  constexpr std::string_view kOpen = "```json\n", kClose = "```";
  std::vector<Json> found;
  for (std::size_t at = text.find(kOpen); at != std::string::npos; at = text.find(kOpen, at)) {
    at += kOpen.size();
    const std::size_t end = text.find(kClose, at);
    found.push_back(test::json(text.substr(at, end - at)));
    at = end + kClose.size();
  }
  return found;
}

TEST(Readme, ItsExamplesWork) {
  const auto found = examples(test::repository_text("protocol/README.md"));
  ASSERT_EQ(found.size(), 3u);
  const Json& marker = found[0];

  const rpc::Incoming in = rpc::parse_incoming(json::to_text(found[1]), 1000);
  const MarkerFile file = test::read(marker);
  SumCache sums;
  const auto call = find_method("motion.compact")->read(std::get<rpc::Request>(in.calls.at(0)).params);
  ASSERT_TRUE(call);
  const auto answer = call->run(file, calls::MethodContext{scene::Run{sums}});
  ASSERT_TRUE(answer);
  Json result = calls::result_json("m1", 2, answer->fields);
  Json shown = found[2]["result"];
  for (Json* each : {&result, &shown})
    (*each)["placements"][0].erase("at");  // any value of the same length is acceptable
  EXPECT_EQ(json::to_text(result), json::to_text(shown));
}

// The section below this heading, up to the next.
std::string section(const std::string& text, const std::string& heading) {
  const std::size_t at = text.find("\n### " + heading + "\n");
  return at == std::string::npos ? "" : text.substr(at + 1, text.find("\n#", at + 1) - at);
}

// Whether the text has this name in code quotes, as that of a field or of a list.
bool names(const std::string& text, std::string_view name) {
  const std::string quoted = "`" + std::string{name};
  return text.find(quoted + "`") != std::string::npos || text.find(quoted + "[]`") != std::string::npos;
}

TEST(Readme, ExplainsAllParametersAndResultsOfMotionsAndSearches) {
  const std::string text = test::repository_text("protocol/README.md");
  for (const calls::Method& method : method_table().all()) {
    const std::string name{method.name};
    EXPECT_NE(text.find("| `" + name + "` |"), std::string::npos) << name;
    const std::string own = section(text, name);
    const bool search = method.kind == calls::MethodKind::kSearch;
    if (own.empty() && !method.motion && !search) continue;
    EXPECT_FALSE(own.empty()) << name;
    const std::string explained = search ? own : own + section(text, "Motions");
    for (const auto fields : {method.params, method.results})
      for (const schema::FieldDescription& field : fields())
        EXPECT_TRUE(names(explained, field.name)) << name << " " << field.name;
  }
}

TEST(Readme, ListsEveryErrorCode) {
  using enum ErrorCode;
  constexpr std::array kCodes{
      kSyntax,          kDepth,          kMissingField,   kUnknownField,          kWrongType,    kOutOfRange,
      kUnknownFormat,   kFile,           kDuplicateField, kTooFewVertices,        kZeroArea,     kSelfIntersecting,
      kTooManyVertices, kBeyondLattice,  kEmptyMarker,    kUnknownShape,          kDuplicateId,  kPieceTooWide,
      kOutsideStrip,    kMarkerOverlaps, kTooManyPieces,  kOrientationNotAllowed, kRepairFailed, kStoppedEarly,
      kNothingToUndo};
  const std::string text = test::repository_text("protocol/README.md");
  for (const ErrorCode code : kCodes) {
    const std::string row =
        "| " + std::to_string(static_cast<int>(code)) + " | `" + std::string{wire_name(code)} + "` |";
    EXPECT_NE(text.find(row), std::string::npos) << row;
  }
}

TEST(Readme, ListsEveryRpcCode) {
  using enum rpc::RpcCode;
  const std::string text = test::repository_text("protocol/README.md");
  for (const rpc::RpcCode code :
       {kParseError, kInvalidRequest, kMethodNotFound, kInvalidParams, kInternalError, kMotionRefused, kBusy, kTooLarge,
        kUnknownMarker, kLimit, kDraining, kUnauthorised, kCancelled, kRevisionMismatch, kSuperseded}) {
    EXPECT_NE(text.find("| " + std::to_string(static_cast<int>(code)) + " |"), std::string::npos);
  }
}

}  // namespace
}  // namespace selvage::protocol::methods
