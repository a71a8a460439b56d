// protocol/README.md tells the truth: its examples work, its codes are the ones there are.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "protocol/codec.h"
#include "protocol/json_rpc.h"
#include "tests/protocol/samples.h"

namespace selvage {
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
  const auto found = examples(test::file_text("protocol/README.md"));
  ASSERT_EQ(found.size(), 3u);
  const Json& marker = found[0];
  EXPECT_EQ(test::read(marker).marker.pieces.size(), 2u);

  const Incoming in = parse_incoming(to_text(found[1]), 1000);
  const auto compact = decode_motion_compact(std::get<Request>(in.calls.at(0)).params);
  ASSERT_TRUE(compact);

  MotionCompacted compacted{.marker_id = compact->marker_id, .revision = 2, .figures = {}, .placements = {}};
  compacted.timing = compact->timing;
  const Json written = encode(compacted);
  const Json& shown = found[2]["result"];
  EXPECT_EQ(shown.size(), written.size());
  for (const auto& [key, value] : written.items()) EXPECT_TRUE(shown.contains(key)) << key;
}

TEST(Readme, ListsEveryErrorCode) {
  using enum ErrorCode;
  constexpr std::array kCodes{kSyntax,          kDepth,
                              kMissingField,    kUnknownField,
                              kWrongType,       kOutOfRange,
                              kUnknownFormat,   kFile,
                              kDuplicateField,  kTooFewVertices,
                              kZeroArea,        kSelfIntersecting,
                              kTooManyVertices, kBeyondLattice,
                              kEmptyMarker,     kUnknownShape,
                              kDuplicateId,     kPieceTooWide,
                              kOutsideStrip,    kMarkerOverlaps,
                              kTooManyPieces,   kOrientationNotAllowed,
                              kHealingFailed};
  const std::string text = test::file_text("protocol/README.md");
  for (const ErrorCode code : kCodes) {
    const std::string row =
        "| " + std::to_string(static_cast<int>(code)) + " | `" + std::string{wire_name(code)} + "` |";
    EXPECT_NE(text.find(row), std::string::npos) << row;
  }
}

TEST(Readme, ListsEveryRpcCode) {
  using enum RpcCode;
  const std::string text = test::file_text("protocol/README.md");
  for (const RpcCode code :
       {kParseError, kInvalidRequest, kMethodNotFound, kInvalidParams, kInternalError, kMotionRefused, kBusy,
        kTooLarge, kUnknownMarker, kLimit, kDraining, kCancelled, kRevisionMismatch, kSuperseded}) {
    EXPECT_NE(text.find("| " + std::to_string(static_cast<int>(code)) + " |"), std::string::npos);
  }
}

}  // namespace
}  // namespace selvage
