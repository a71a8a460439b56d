#include "protocol/calls/call_fields.h"

namespace selvage::protocol::calls {
namespace {

constexpr std::int64_t kLargestRevision = std::int64_t{1} << 53;

}  // namespace

std::optional<Revision> read_revision(json::Fields& fields, std::string_view key) {
  const auto revision = fields.maybe_integer(key, 1, kLargestRevision);
  if (!revision) return std::nullopt;
  return static_cast<Revision>(*revision);
}

std::optional<std::string> read_op_id(json::Fields& fields, json::Mistake& mistake) {
  if (!fields.maybe_any("opId")) return std::nullopt;
  std::string id = fields.text("opId");
  if (!mistake && (id.empty() || id.size() > kLongestOpId)) {
    mistake.add(
        ErrorCode::kOutOfRange,
        json::shortened(Json(id)) + " is out of range; 1 to " + std::to_string(kLongestOpId) + " bytes are allowed",
        fields.pointer("opId"));
  }
  return id;
}

std::optional<double> read_deadline(json::Fields& fields) {
  return fields.maybe_number("deadlineMs", kDeadlines);
}

Json read_progress_token(json::Fields& fields, json::Mistake& mistake) {
  const Json* token = fields.maybe_any("progressToken");
  if (!token) return nullptr;
  const bool fine =
      token->is_number() || (token->is_string() && token->get_ref<const std::string&>().size() <= kLongestToken);
  if (fine) return *token;
  mistake.add(ErrorCode::kWrongType,
              json::shortened(*token) + " where a number, or a string of at most " + std::to_string(kLongestToken) +
                  " bytes, is required",
              fields.pointer("progressToken"));
  return nullptr;
}

}  // namespace selvage::protocol::calls
