#include "tests/support/map_text.h"

#include <fmt/format.h>

namespace handrail::test {

std::string box_brush(double x0, double y0, double z0, double x1, double y1, double z1, const std::string& texture) {
    std::string text = "{\n";
    const auto face = [&](double ax, double ay, double az, double bx, double by, double bz, double cx, double cy,
                          double cz) {
        text += fmt::format("( {} {} {} ) ( {} {} {} ) ( {} {} {} ) {} 0 0 0 1 1\n", ax, ay, az, bx, by, bz, cx, cy, cz,
                            texture);
    };
    // the west side; each face is given by three points, clockwise as seen from outside
    face(x0, y0, z0, x0, y1, z0, x0, y0, z1);
    face(x1, y0, z0, x1, y0, z1, x1, y1, z0);  // east
    face(x0, y0, z0, x0, y0, z1, x1, y0, z0);  // south
    face(x0, y1, z0, x1, y1, z0, x0, y1, z1);  // north
    face(x0, y0, z0, x1, y0, z0, x0, y1, z0);  // below
    face(x0, y0, z1, x0, y1, z1, x1, y0, z1);  // above
    return text + "}\n";
}

std::string entity(const std::string& class_name, const std::string& keys, const std::string& brushes) {
    return fmt::format("{{\n\"classname\" \"{}\"\n{}{}}}\n", class_name, keys, brushes);
}

std::string key(const std::string& name, const std::string& value) {
    return fmt::format("\"{}\" \"{}\"\n", name, value);
}

std::string room_brushes(double x0, double y0, double z0, double x1, double y1, double z1, double thick,
                         const std::string& texture) {
    const double t = thick;
    return box_brush(x0 - t, y0 - t, z0, x0, y1 + t, z1, texture) +
           box_brush(x1, y0 - t, z0, x1 + t, y1 + t, z1, texture) + box_brush(x0, y0 - t, z0, x1, y0, z1, texture) +
           box_brush(x0, y1, z0, x1, y1 + t, z1, texture) +
           box_brush(x0 - t, y0 - t, z0 - t, x1 + t, y1 + t, z0, texture) +
           box_brush(x0 - t, y0 - t, z1, x1 + t, y1 + t, z1 + t, texture);
}

}  // namespace handrail::test
