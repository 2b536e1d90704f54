// Entry point for libFuzzer: any bytes, read as a map and as a mesh, must give a Scene that holds together or an error.
#include <cstdlib>

#include "worlds/readers/reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(data, data + size);
    for (const auto read : {handrail::read_quake_map, handrail::read_obj}) {
        const handrail::Result<handrail::Scene> scene = read(bytes, "fuzz", {});
        if (scene && !handrail::validate(*scene)) std::abort();
    }
    return 0;
}
