#include "clients/cli/commands/live_picture.h"

#include "clients/cli/terminal/files.h"
#include "protocol/drawing/svg.h"

namespace selvage::cli::commands {

void LivePicture::show(const Marker& marker) {
  constexpr std::chrono::seconds kInterval{1};
  const auto now = std::chrono::steady_clock::now();
  if (drawn_ && now < *drawn_ + kInterval) return;
  drawn_ = now;
  (void)terminal::write_text(path_, protocol::drawing::to_svg(marker));
}

}  // namespace selvage::cli::commands
