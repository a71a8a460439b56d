#include "server/room/room.h"

#include <algorithm>
#include <vector>

#include "server/room/embedded.h"

namespace selvage::server::room {
namespace {

using transport::access::StaticFile;

// The page may load its own files and call this server, and nothing else; no other page may show it in a frame.
constexpr std::string_view kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob:; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

std::string_view type_of(std::string_view name) {
  if (name.ends_with(".html")) return "text/html; charset=utf-8";
  if (name.ends_with(".js")) return "text/javascript; charset=utf-8";
  if (name.ends_with(".css")) return "text/css; charset=utf-8";
  if (name.ends_with(".svg")) return "image/svg+xml";
  return "application/json";
}

struct Served {
  std::string_view name;
  StaticFile file;
};

std::vector<Served> serve_all() {
  std::vector<Served> all;
  for (const Embedded& embedded : embedded_files()) {
    const bool is_page = embedded.name == kPage;
    const std::string_view type = type_of(embedded.name);
    all.push_back({embedded.name, {type, kPolicy, embedded.gzip, !is_page}});
  }
  return all;
}

}  // namespace

const StaticFile* find_file(std::string_view path) {
  static const std::vector<Served> kAll = serve_all();
  if (!path.starts_with('/')) return nullptr;
  const std::string_view name = path == "/" ? kPage : path.substr(1);
  const auto found =
      std::find_if(kAll.begin(), kAll.end(), [name](const Served& served) { return served.name == name; });
  return found == kAll.end() ? nullptr : &found->file;
}

}  // namespace selvage::server::room
