// The names of the core's enumerators in messages.  Each name is defined only here.
#pragma once

#include <string_view>

#include "core/motion/compaction/compact.h"
#include "core/motion/compaction/critical_path.h"
#include "core/motion/dragging/drag.h"
#include "core/motion/floating/float_apart.h"
#include "core/motion/separation/separate.h"
#include "core/motion/tilting/tilt.h"
#include "core/scene/strip_edge.h"
#include "protocol/document/marker_file.h"
#include "protocol/schema/choices.h"

namespace selvage::protocol::calls {

// Why a motion ended.  The first five are those of scene::StopReason; the core does not know about deadlines.
enum class StopCause { kConverged, kWorkLimit, kCancelled, kSolverFailed, kLatticeEnd, kDeadline };

}  // namespace selvage::protocol::calls

namespace selvage::protocol::schema {

template <>
struct Choices<calls::StopCause> {
  static constexpr std::string_view kName = "StopReason";
  static constexpr std::string_view kMeaning =
      "Why a motion ended; in every case the result is the best valid marker so far.";
  static constexpr std::string_view kWords[] = {"converged",     "work_limit",  "cancelled",
                                                "solver_failed", "lattice_end", "deadline"};
};

template <>
struct Choices<motion::compaction::Accuracy> {
  static constexpr std::string_view kName = "Accuracy";
  static constexpr std::string_view kMeaning = "How much work a motion invests: draft, standard or fine.";
  static constexpr std::string_view kWords[] = {"draft", "standard", "fine"};
};

template <>
struct Choices<motion::compaction::Rule> {
  static constexpr std::string_view kName = "ClothRule";
  static constexpr std::string_view kMeaning = "One of cloth's rules, which say where on the strip a piece may lie.";
  static constexpr std::string_view kWords[] = {"below", "above", "from", "to", "fold", "shade", "matchX", "matchY"};
};

template <>
struct Choices<motion::dragging::DragMode> {
  static constexpr std::string_view kName = "DragMode";
  static constexpr std::string_view kMeaning =
      "How a dragged piece affects the others: not at all (place), or it pushes them out of the way (push).";
  static constexpr std::string_view kWords[] = {"place", "push"};
};

template <>
struct Choices<motion::floating::FloatMode> {
  static constexpr std::string_view kName = "FloatMode";
  static constexpr std::string_view kMeaning = "The objective of motion.float.";
  static constexpr std::string_view kWords[] = {"largest_minimum", "given_distance", "largest_total", "uniform",
                                                "two_step"};
};

template <>
struct Choices<StripEdge> {
  static constexpr std::string_view kName = "StripEdge";
  static constexpr std::string_view kMeaning = "An edge of the strip.";
  static constexpr std::string_view kWords[] = {"left", "right", "bottom", "top"};
};

template <>
struct Choices<motion::repair::TargetRule> {
  static constexpr std::string_view kName = "TargetRule";
  static constexpr std::string_view kMeaning =
      "How motion.separate chooses the target of an overlapping pair: the nearest point where the two are apart, or "
      "the point on the ray from the kernel of their Minkowski sum.";
  static constexpr std::string_view kWords[] = {"nearest", "kernel_ray"};
};

template <>
struct Choices<motion::tilting::TiltMethod> {
  static constexpr std::string_view kName = "TiltMethod";
  static constexpr std::string_view kMeaning = "Whether pieces tilt all at once or one after another.";
  static constexpr std::string_view kWords[] = {"linearisation", "relaxation"};
};

template <>
struct Choices<document::Format> {
  static constexpr std::string_view kName = "Format";
  static constexpr std::string_view kMeaning = "A document format.";
  static constexpr auto& kWords = document::kFormatNames;
};

}  // namespace selvage::protocol::schema
