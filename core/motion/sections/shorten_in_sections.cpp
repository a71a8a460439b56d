#include "core/motion/sections/shorten_in_sections.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/marker/clearance.h"
#include "core/motion/sections/section_scene.h"

namespace selvage::motion::sections {
namespace {

// The whole marker after its sections have moved, each with all that lies left of it.
std::vector<Vec> joined(const std::vector<Section>& sections, const std::vector<std::optional<MovedSection>>& moved,
                        const scene::Scene& whole) {
  std::vector<Vec> positions = whole.pieces.positions();
  Coord offset = 0;
  for (std::size_t s = 0; s < sections.size(); ++s) {
    const auto& own = moved[s];
    for (std::size_t k = 0; k < sections[s].free.size(); ++k) {
      Vec& at = positions[sections[s].free[k]];
      if (own) at = own->positions[k];
      at.x += offset;
    }
    if (own) offset += own->shift;
    for (const std::uint32_t i : sections[s].right) positions[i].x += offset;
  }
  return positions;
}

std::vector<Section> cut(const scene::Scene& scene, const SectionTuning& tuning, double offset) {
  const auto width = static_cast<double>(scene.marker.strip.width);
  return sections_of(scene.pieces, {tuning.pieces, offset, std::llround(tuning.layer * width)});
}

// Sections report their stages and programs only where they are shortened one after another.
scene::Run run_of_section(const scene::Run& run) {
  scene::Run own = run.quiet();
  if (run.executor->parallelism() > 1) own.observer = {};
  return own;
}

class SectionPasses {
 public:
  SectionPasses(scene::Scene& scene, const SectionTuning& tuning, const ShortenSection& shorten, const scene::Run& run)
      : scene_{scene}, tuning_{tuning}, shorten_{shorten}, run_{run}, settled_(scene.pieces.size()) {}

  // Shortens all sections that are not settled.  Returns by how much the marker became shorter.
  Coord pass(double offset);
  [[nodiscard]] int programs() const { return programs_; }

 private:
  [[nodiscard]] bool is_settled(const Section& section) const {
    return std::all_of(section.free.begin(), section.free.end(), [this](std::uint32_t i) { return settled_[i] != 0; });
  }

  scene::Scene& scene_;
  const SectionTuning& tuning_;
  const ShortenSection& shorten_;
  const scene::Run& run_;
  std::vector<char> settled_;  // by piece: it was free in a section that gained next to nothing
  int programs_{};
};

Coord SectionPasses::pass(double offset) {
  const std::vector<Section> sections = cut(scene_, tuning_, offset);
  std::vector<std::optional<MovedSection>> moved(sections.size());
  std::vector<SectionGain> gains(sections.size());
  std::vector<std::size_t> unsettled;
  for (std::size_t s = 0; s < sections.size(); ++s) {
    if (!is_settled(sections[s])) unsettled.push_back(s);
  }
  run_.executor->for_each(unsettled.size(), [&](std::size_t k) {
    if (run_.stopped()) return;
    const std::size_t s = unsettled[k];
    const scene::Run run = run_of_section(run_);
    SectionScene own = scene_of(sections[s], scene_, run);
    gains[s] = shorten_(own.scene, run);
    moved[s] = moved_section(sections[s], own, scene_);
  });
  const double settled_below = tuning_.settled * static_cast<double>(scene_.marker.strip.width);
  for (std::size_t s = 0; s < sections.size(); ++s) {
    const char settled = gains[s].gain < settled_below ? 1 : 0;
    for (const std::uint32_t i : sections[s].free) settled_[i] = settled;
    programs_ += gains[s].programs;
  }
  const std::vector<Vec> before = scene_.pieces.positions();
  const Coord length = scene_.pieces.length();
  scene_.pieces.place(joined(sections, moved, scene_));
  const Coord gain = length - scene_.pieces.length();
  // Pieces of two sections may have met in a hollow of the layer between them.
  if (gain >= 0 && marker::all_clear(scene_.pieces, scene_.marker.strip)) return gain;
  scene_.pieces.place(before);
  return 0;
}

}  // namespace

SectionGain shorten_copy(const scene::Scene& scene, const SectionTuning& tuning, double at,
                         const ShortenSection& shorten, const scene::Run& run) {
  const std::vector<Section> sections = cut(scene, tuning, 0);
  const auto number = static_cast<std::size_t>(at * static_cast<double>(sections.size()));
  SectionScene copy = scene_of(sections[number], scene, run);
  return shorten(copy.scene, run.quiet());
}

Passes shorten_in_sections(scene::Scene& scene, const SectionTuning& tuning, int most, const ShortenSection& shorten,
                           const scene::Run& run) {
  Passes passes;
  SectionPasses work{scene, tuning, shorten, run};
  bool worth_another = true;
  while (worth_another && passes.passes < std::min(most, tuning.passes) && !run.stopped()) {
    // Multiples of the golden ratio, without their whole parts, lie far from each other.
    const double offset = passes.passes / std::numbers::phi;
    const auto length = static_cast<double>(scene.pieces.length());
    const Coord gain = work.pass(offset - std::floor(offset));
    worth_another = static_cast<double>(gain) > tuning.worth_a_pass * length;
    run.observer.on_round({++passes.passes, scene.pieces.length()});
  }
  passes.programs = work.programs();
  return passes;
}

}  // namespace selvage::motion::sections
