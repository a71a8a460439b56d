#include "protocol/formats/jagua/orientations.h"

#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace selvage::protocol::formats::jagua {
namespace {

constexpr json::Range kAngles{-360, 360};
constexpr double kTurn = 360;
constexpr double kSlack = 1e-4;  // degrees; steps in single precision are closer
constexpr const char* kReflections = "reflection_axes";

std::vector<Angle> read_angles(const Json& list, const std::string& at, json::Mistake& mistake) {
  std::vector<Angle> angles;
  for (std::size_t k = 0; k < list.size() && !mistake; ++k) {
    angles.push_back(Angle::of_degrees(json::checked_number(list[k], kAngles, mistake, at + "/" + std::to_string(k))));
  }
  return angles;
}

// A whole number of steps in a turn.
std::vector<Angle> read_steps(json::Fields& rotation, json::Mistake& mistake) {
  const double step = rotation.number("step", {kTurn / kMostSteps, kTurn});
  if (mistake) return {};
  const double count = std::round(kTurn / step);
  if (std::abs(count * step - kTurn) > kSlack) {
    mistake.add(ErrorCode::kOutOfRange, "is no whole part of a turn of 360 degrees", rotation.pointer("step"));
  }
  std::vector<Angle> angles;
  for (int k = 0; k < static_cast<int>(count); ++k) angles.push_back(Angle::of_degrees(k * kTurn / count));
  return angles;
}

std::vector<Angle> read_object(const Json& value, const std::string& at, json::Mistake& mistake) {
  enum Mode : std::size_t { kDiscrete, kStepped, kContinuous };
  static constexpr std::array<std::string_view, 3> kModes{"discrete", "stepped", "continuous"};
  json::Fields orientation{value, at, mistake};
  json::Fields rotation{orientation.object("rotation"), orientation.pointer("rotation"), mistake};
  (void)rotation.text("mode");  // a mistake when it is missing
  switch (rotation.word_or("mode", kContinuous, kModes)) {
    case kDiscrete: {
      std::vector<Angle> angles = read_angles(rotation.array("angles"), rotation.pointer("angles"), mistake);
      if (angles.empty()) {
        mistake.add(ErrorCode::kOutOfRange, "is empty; at least one angle is allowed", rotation.pointer("angles"));
      }
      return angles;
    }
    case kStepped: return read_steps(rotation, mistake);
    default: return {};
  }
}

}  // namespace

std::vector<Angle> read_orientations(json::Fields& item, json::Mistake& mistake) {
  const Json* const object = item.maybe_object(kOrientation);
  const Json* const list = item.maybe_array("allowed_orientations");
  if (object != nullptr && list != nullptr) {
    mistake.add(ErrorCode::kOutOfRange, "is given together with allowed_orientations; one of them is allowed",
                item.pointer(kOrientation));
  }
  if (object != nullptr) return read_object(*object, item.pointer(kOrientation), mistake);
  if (list == nullptr) return {};
  std::vector<Angle> rotations = read_angles(*list, item.pointer("allowed_orientations"), mistake);
  if (rotations.empty()) rotations.push_back(Angle{});  // an empty list means no rotation
  return rotations;
}

bool permits_reflections(const Json& item) {
  const Json* const orientation = item.find(kOrientation);
  const Json* const axes = orientation != nullptr ? orientation->find(kReflections) : nullptr;
  return axes != nullptr && !axes->empty();
}

Json angles_json(const std::vector<Angle>& angles) {
  Json list = Json::array();
  for (const Angle angle : angles) list.push_back(angle.degrees);
  return list;
}

Json orientation_json(Json as_read, const std::vector<Angle>& rotations) {
  Json& rotation = as_read["rotation"] = Json::object();
  rotation["mode"] = rotations.empty() ? "continuous" : "discrete";
  if (!rotations.empty()) rotation["angles"] = angles_json(rotations);
  return as_read;
}

}  // namespace selvage::protocol::formats::jagua
