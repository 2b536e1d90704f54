// Writes an office building as a .map to standard output, for exploring, for measurements and for fuzzing:
//   build/release/bin/office_map [brushes] [seed] > office.map
// 50,000 brushes are 50,000 square metres on five storeys.
#include <cstdio>
#include <cstdlib>

#include "tests/support/office_world.h"

int main(int argc, char** argv) {
    const int brushes = argc > 1 ? std::atoi(argv[1]) : 50'000;
    const unsigned long seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
    if (brushes < 1 || brushes > 1'000'000) {
        std::fputs("office_map: between 1 and 1000000 brushes\n", stderr);
        return 2;
    }
    const handrail::test::OfficeWorld office =
        handrail::test::office_world(handrail::test::office_size(brushes, static_cast<std::uint32_t>(seed)));
    if (std::fwrite(office.map.data(), 1, office.map.size(), stdout) != office.map.size() || std::fflush(stdout) != 0)
        return 1;
    std::fprintf(stderr, "%d brushes, %d rooms, %d doors, %d things, %d flights of stairs, %.0f square metres\n",
                 office.brushes, office.rooms, office.doors, office.things, office.stairs, office.floor_m2);
    return 0;
}
