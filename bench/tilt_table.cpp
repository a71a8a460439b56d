#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include "core/motion/tilt.h"
#include "core/marker/validity.h"
#include "protocol/formats/format.h"
using namespace selvage;
int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    std::ifstream in{argv[i]}; std::stringstream text; text << in.rdbuf();
    auto file = read_marker(text.str());
    if (!file) return 1;
    SumCache sums;
    auto env = [](const char* n, double d) { return getenv(n) ? atof(getenv(n)) : d; };
    TiltSettings s = tilt_settings(env("RELAX", 0) > 0 ? TiltMethod::kRelaxation : TiltMethod::kLinearisation, Accuracy::kStandard);
    s.shakes = (int) env("SHAKES", 0);
    s.rounds = (int) env("ROUNDS", 60);
    s.step = Angle{env("STEP", 0.5)};
    s.trust = env("TRUST", 0.05);
    s.tilts = (int) env("TILTS", 13);
    s.compaction.gravity = env("GRAV", 0.003);
    s.limit = Angle::of_degrees(3);
    auto t0 = std::chrono::steady_clock::now();
    auto r = tilt(file->marker, s, sums);
    std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - t0;
    if (!r) { printf("%s %s\n", argv[i], r.error().message.c_str()); continue; }
    double c = double(r->length_compacted)/double(r->length_before);
    printf("%-20s comp %.6f tilt/comp %.6f tilt/before %.6f valid %d rounds %d reason %d ms %.0f\n", std::string(argv[i]).substr(std::string(argv[i]).rfind('/')).c_str(), c, double(r->length_after)/double(r->length_compacted), double(r->length_after)/double(r->length_before), is_valid(r->marker), r->rounds, (int)r->reason, took.count());
    fflush(stdout);
  }
}
