#include "protocol/calls/motion.h"

#include "core/marker/figures.h"

namespace selvage::protocol::calls {
namespace {

MotionBefore figures_of(const Marker& start, const MotionEnd& end, const marker::Figures& after) {
  const Coord length_before = end.before ? end.before->figures.length : length_of(start);
  return {.name = end.marker.name,
          .pieces = piece_count(end.marker),
          .length_before = to_decimal(length_before, start.resolution),
          .length_after = to_decimal(after.length, end.marker.resolution),
          .utilisation_before = end.before ? end.before->figures.utilisation : utilisation_at(start, length_before),
          .utilisation_after = after.utilisation};
}

}  // namespace

std::shared_ptr<const scene::LaidOut> laid_out(const Marker& marker, const MethodContext& context) {
  const auto make = [&] { return scene::LaidOut{marker, context.run}; };
  return context.laid_out ? context.laid_out->get(make) : std::make_shared<const scene::LaidOut>(make());
}

StopCause stop_cause(scene::StopReason reason, const MethodContext& context) {
  if (reason == scene::StopReason::kCancelled && context.past_deadline()) return StopCause::kDeadline;
  return static_cast<StopCause>(reason);
}

motion::compaction::CompactionSettings settings_of(const Effort& effort) {
  motion::compaction::CompactionSettings settings = compaction_settings(effort.accuracy);
  settings.rounds = effort.rounds.value_or(settings.rounds);
  settings.simplification = effort.simplification.value_or(settings.simplification);
  return settings;
}

MethodAnswer answer_of(const Marker& start, MotionEnd end, const Json& own, bool commit, const MethodContext& context) {
  context.run.observer.on_stage(scene::Stage::kVerify);
  const marker::Figures after =
      end.before ? figures_after(start, *end.before, end.marker) : marker::figures_of(end.marker);
  context.run.observer.on_stage(scene::Stage::kOther);
  MotionAfter proved{.valid = after.valid,
                     .healed = healing_of(end.repair, end.marker.resolution),
                     .placements = changed_placements(start, end.marker),
                     .ms = {},
                     .cache = {}};
  const bool changed = !proved.placements.empty() || end.marker.pieces.size() != start.pieces.size();
  MethodAnswer answer{schema::encode(figures_of(start, end, after)), std::nullopt};
  answer.fields.update(own);
  answer.fields.update(schema::encode(proved));
  if (commit && changed && (after.valid || end.keep_invalid)) answer.next = std::move(end.marker);
  return answer;
}

}  // namespace selvage::protocol::calls
