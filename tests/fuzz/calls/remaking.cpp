// Fuzz target: an order and a library.  The input is the text of marker.remake's parameters, in which "stored" is the
// library, with the additional field "order".
//
// For any order and stored markers, the answer is valid and has the order's pieces, or the marker does not
// change.
#include <string>

#include "protocol/calls/method.h"
#include "protocol/formats/format.h"
#include "protocol/json/json_text.h"
#include "protocol/methods/method_table.h"
#include "tests/fuzz/entry.h"

namespace selvage::test {
namespace {

constexpr std::size_t kMostPieces = 40;

void judge(const MarkerFile& order, const protocol::calls::MethodAnswer& answer) {
  const std::string outcome = answer.fields["outcome"].get<std::string>();
  const bool made = outcome == "remade" || outcome == "nested";
  demand(!made || answer.fields["valid"] == true, "an answer is not valid");
  demand(made || !answer.next, "an order that was not remade has moved");
  if (!made || !answer.next) return;
  const std::size_t count = order.marker.pieces.size() + order.marker.unplaced.size();
  demand(answer.next->pieces.size() == count && answer.next->unplaced.empty(), "pieces are missing");
}

}  // namespace
}  // namespace selvage::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace selvage;
  using namespace selvage::test;
  auto given = protocol::json::parse(std::string{bytes, bytes + size});
  if (!given || !given->is_object() || !given->contains("order")) return 0;
  const auto order = protocol::formats::read_document((*given)["order"]);
  if (!order || order->marker.pieces.size() + order->marker.unplaced.size() > kMostPieces) return 0;
  given->erase("order");
  (*given)["markerId"] = "m1";
  (*given)["tries"] = 2;
  (*given)["fine"] = false;
  (*given)["nestMoves"] = 20;
  const auto call = protocol::methods::find_method("marker.remake")->read(*given);
  if (!call) {
    demand(!call.error().message.empty() && call.error().field.starts_with("/"), "an error without its field");
    return 0;
  }
  SumCache sums;
  const auto answer = call->run(*order, protocol::calls::MethodContext{scene::Run{sums}});
  if (answer) judge(*order, *answer);
  if (!answer) demand(!answer.error().message.empty(), "an error without a message");
  return 0;
}
