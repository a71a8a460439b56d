#include "tests/trials/malformed/malformed_http.h"

#include <array>
#include <string_view>

#include "tests/server/wire/websocket_wire.h"
#include "tests/server/wire/wire.h"

namespace selvage::trials {
namespace {

using test::Random;

std::string some(Random& random, const char* byte, std::size_t most) {
  return std::string(random.below(most), *byte);
}

std::string bytes(Random& random, std::size_t most) {
  std::string text(1 + random.below(most), ' ');
  for (char& byte : text) byte = static_cast<char>(random.below(256));
  return text;
}

}  // namespace

std::string malformed_http(Random& random) {
  const std::string post = "POST /rpc HTTP/1.1\r\nHost: localhost\r\n";
  const std::string sound = test::post_request("{}");
  switch (random.below(16)) {
    case 0: return post + "Transfer-Encoding: chunked\r\n\r\n2\r\n{}\r\n0\r\n\r\n";
    case 1: return post + "Transfer-Encoding: chunked\r\n\r\n0\r\nX: " + some(random, "x", 1 << 20) + "\r\n\r\n";
    case 2: return post + "Transfer-Encoding: chunked\r\n\r\n2;" + some(random, "x", 1 << 20) + "\r\n{}\r\n0\r\n\r\n";
    case 3: return post + "Transfer-Encoding: gzip\r\n\r\n" + sound;
    case 4: return post + "Content-Length: 2\r\nContent-Length: 3\r\n\r\n{} ";
    case 5: return post + "Content-Length: 2\r\nTransfer-Encoding: chunked\r\n\r\n{}";
    case 6: return post + "Content-Length: 99999999999999999999999\r\n\r\n{}";
    case 7: return post + "Content-Length: 1000\r\n\r\n{";  // the rest is never sent
    case 8: return test::post_request("{}", "X: " + some(random, "x", 100'000) + "\r\n");
    case 9: return "POST /" + some(random, "x", 100'000) + " HTTP/1.1\r\n\r\n";
    case 10: return test::post_request("{}", "Host: example.com\r\nOrigin: http://example.com\r\n");
    case 11: return test::upgrade_request("Origin: http://example.com\r\n");
    case 12: return "\x16\x03\x01" + bytes(random, 500);
    case 13: return bytes(random, 20'000);
    case 14: return sound.substr(0, random.below(sound.size()));
    default: {
      std::string damaged = sound;
      damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
      return damaged;
    }
  }
}

std::string malformed_frames(Random& random) {
  using test::Frame;
  using test::Opcode;
  switch (random.below(9)) {
    case 0: return test::frame_bytes({Opcode::kText, "{}"}, false);
    case 1: return test::frame_bytes({Opcode::kText, "\xff\xfe" + bytes(random, 100)});
    case 2: return test::frame_bytes({Opcode::kBinary, bytes(random, 100)});
    case 3: return test::frame_bytes({Opcode::kPing, std::string(126, 'x')});
    case 4: return test::frame_bytes({Opcode::kPing, "x", false});
    case 5: return test::frame_bytes({Opcode::kContinuation, "x"});
    case 6: return test::frame_bytes({static_cast<Opcode>(3 + random.below(13)), bytes(random, 50)});
    case 7: return "\x81\xff\x7f\xff\xff\xff\xff\xff\xff\xff" + bytes(random, 100);  // the greatest possible length
    default: return bytes(random, 2000);
  }
}

}  // namespace selvage::trials
