#include "protocol/calls/motion.h"

#include <algorithm>
#include <cmath>

#include "core/marker/figures.h"
#include "protocol/calls/call_fields.h"
#include "protocol/calls/codec.h"
#include "protocol/formats/decimal_marker.h"

namespace selvage::protocol::calls {
namespace {

// The figures of every motion.
Json motion_fields(const Marker& start, const Motion& motion, const marker::Figures& after) {
  const Marker& end = motion.marker;
  const Coord length_before = motion.before ? motion.before->figures.length : length_of(start);
  const double utilisation_before =
      motion.before ? motion.before->figures.utilisation : utilisation_at(start, length_before);
  Json fields{{"name", end.name},
              {"pieces", end.pieces.size()},
              {"lengthBefore", to_decimal(length_before, start.resolution)},
              {"lengthAfter", to_decimal(after.length, end.resolution)},
              {"utilisationBefore", utilisation_before},
              {"utilisationAfter", after.utilisation}};
  fields.update(motion.figures);
  fields.update(Json{{"valid", after.valid},
                     {"healed", repair_json(motion.repair, end.resolution)},
                     {"placements", changed_placements(start, end)}});
  return fields;
}

}  // namespace

std::shared_ptr<const scene::LaidOut> laid_out(const Marker& marker, const MethodContext& context) {
  const auto make = [&] { return scene::LaidOut{marker, context.run.sums}; };
  return context.laid_out ? context.laid_out->get(make) : std::make_shared<const scene::LaidOut>(make());
}

std::string_view name_of(scene::StopReason reason) {
  return kStopNames[static_cast<std::size_t>(reason)];
}

motion::compaction::CompactionSettings settings_of(const Effort& effort) {
  motion::compaction::CompactionSettings settings = compaction_settings(effort.accuracy);
  settings.rounds = effort.rounds.value_or(settings.rounds);
  settings.simplification = effort.simplification.value_or(settings.simplification);
  return settings;
}

MotionCall read_call(json::Fields& fields, json::Mistake& mistake) {
  MotionCall call;
  call.marker_id = fields.text("markerId");
  call.base_revision = read_base_revision(fields);
  call.commit = fields.flag_or("commit", call.commit);
  call.timing = fields.flag_or("timing", call.timing);
  call.op_id = read_op_id(fields, mistake);
  call.deadline_ms = read_deadline(fields);
  call.progress_token = read_progress_token(fields, mistake);
  return call;
}

std::optional<int> read_rounds(json::Fields& fields) {
  const auto rounds = fields.maybe_integer("rounds", 0, kMaxRounds);
  if (!rounds) return std::nullopt;
  return static_cast<int>(*rounds);
}

Effort read_effort(json::Fields& fields) {
  Effort effort;
  effort.accuracy = static_cast<motion::compaction::Accuracy>(
      fields.word_or("accuracy", static_cast<std::size_t>(effort.accuracy), kAccuracyNames));
  effort.rounds = read_rounds(fields);
  effort.simplification = fields.maybe_number("simplification", {0, kMostSimplification});
  return effort;
}

Direction read_direction(json::Fields& fields, std::string_view key, json::Mistake& mistake) {
  const std::string at = fields.pointer(key);
  const Json& value = fields.array(key);
  if (mistake) return {};
  if (value.size() != 2) {
    mistake.add(ErrorCode::kWrongType, json::shortened(value) + " where [x, y] is required", at);
    return {};
  }
  constexpr json::Range kAllowed{-kLargestForce, kLargestForce};
  const Direction read{checked_number(value[0], kAllowed, mistake, at + "/0"),
                       checked_number(value[1], kAllowed, mistake, at + "/1")};
  if (std::max(std::abs(read.x), std::abs(read.y)) < kLeastForce) {
    mistake.add(ErrorCode::kOutOfRange,
                json::shortened(value) + " leads nowhere; [x, y] with x or y of at least " +
                    json::number_text(kLeastForce) + " either way is allowed",
                at);
  }
  return read;
}

Result<PieceId> piece_of(const Marker& marker, const std::string& id, const std::string& field) {
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    if (marker.pieces[i].id == id) return PieceId{i};
  }
  return Error{ErrorCode::kOutOfRange,
               json::shortened(Json(id)) + " is no piece of this marker; the id of one of its " +
                   std::to_string(marker.pieces.size()) + " pieces is allowed",
               field};
}

Json rounds_json(int rounds, scene::StopReason reason) {
  return {{"rounds", rounds}, {"stop", name_of(reason)}};
}

MethodAnswer answer_of(const Marker& start, Motion motion, bool commit, const MethodContext& context) {
  context.run.observer.on_stage(scene::Stage::kVerify);
  const marker::Figures after =
      motion.before ? figures_after(start, *motion.before, motion.marker) : figures_of(motion.marker);
  context.run.observer.on_stage(scene::Stage::kOther);
  MethodAnswer answer{motion_fields(start, motion, after), std::nullopt};
  const bool changed = !answer.fields["placements"].empty() || motion.marker.pieces.size() != start.pieces.size();
  if (commit && changed && (after.valid || motion.keep_invalid)) answer.next = std::move(motion.marker);
  return answer;
}

}  // namespace selvage::protocol::calls
