// The marker room, clients/room: the page that the daemon serves at "/".  The build bundles it and embeds it in the
// program, compressed.  Every file but the page itself has the hash of its content in its name.
#pragma once

#include <string_view>

#include "server/transport/access/service.h"

namespace selvage::server::room {

// The file at this path, or null.
[[nodiscard]] const transport::access::StaticFile* find_file(std::string_view path);

}  // namespace selvage::server::room
