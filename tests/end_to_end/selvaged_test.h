// Tests that start the program on a free port.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tests/end_to_end/calls.h"
#include "tests/end_to_end/process.h"
#include "tests/server/store/temporary_folder.h"
#include "tests/support/repository.h"

namespace selvage::test {

class SelvagedTest : public ::testing::Test {
 protected:
  // The program, with these options.
  std::vector<std::string> arguments(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{SELVAGED, "--listen", "127.0.0.1:0", "--port-file", folder_.file("port")};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  // Waits until it listens.
  std::uint16_t port_of(Process& process) const {
    EXPECT_NE(process.output_until("listening on 127.0.0.1:").find("listening on 127.0.0.1:"), std::string::npos);
    return static_cast<std::uint16_t>(std::stoi(file_text(folder_.file("port"))));
  }

  const TemporaryFolder folder_;
};

}  // namespace selvage::test
