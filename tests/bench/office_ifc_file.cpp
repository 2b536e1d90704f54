// Writes an office building as an IFC file to standard output. The file is input for the reader, for measurements and
// for fuzzing:
//   build/release/bin/office_ifc_file [storeys] [corridors] [rooms along each side] [facets in each room] > office.ifc
#include <cstdio>
#include <cstdlib>

#include "tests/support/office_ifc.h"

int main(int argc, char** argv) {
    const auto number = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
    const handrail::test::OfficeIfcSize size{number(1, 5), number(2, 8), number(3, 20), number(4, 0)};
    if (size.storeys < 1 || size.corridors < 1 || size.rooms_along < 1 || size.facets_of_furniture < 0 ||
        1.0 * size.storeys * size.corridors * size.rooms_along > 1e6) {
        std::fputs("office_ifc_file: from 1 to a million rooms\n", stderr);
        return 2;
    }
    const handrail::test::OfficeIfc office = handrail::test::office_ifc(size);
    if (std::fwrite(office.text.data(), 1, office.text.size(), stdout) != office.text.size() ||
        std::fflush(stdout) != 0)
        return 1;
    std::fprintf(stderr, "%d rooms, %d doors, %d windows, %d flights of stairs, %.0f square metres\n", office.rooms,
                 office.doors, office.windows, office.flights, office.floor_m2);
    return 0;
}
