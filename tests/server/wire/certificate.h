// A self-signed certificate for TLS in tests.
#pragma once

#include <filesystem>

#include "server/transport/access/listener.h"

namespace selvage::test {

// Writes certificate.pem and key.pem into the folder.
[[nodiscard]] server::transport::access::TlsFiles write_certificate(const std::filesystem::path& folder);

}  // namespace selvage::test
