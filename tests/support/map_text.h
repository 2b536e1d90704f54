// Writes small .map files for tests: boxes and entities in map units.
#pragma once

#include <string>

namespace handrail::test {

// A brush in the shape of a box, six Standard faces, all with one texture.
std::string box_brush(double x0, double y0, double z0, double x1, double y1, double z1,
                      const std::string& texture = "plain");
// "{ "classname" "..." keys brushes }"; `keys` as "\"key\" \"value\"\n".
std::string entity(const std::string& class_name, const std::string& keys = {}, const std::string& brushes = {});
std::string key(const std::string& name, const std::string& value);
// A closed room of six slabs around the inner space from (x0, y0, z0) to (x1, y1, z1), walls `thick` units.
std::string room_brushes(double x0, double y0, double z0, double x1, double y1, double z1, double thick = 16.0,
                         const std::string& texture = "plain");

}  // namespace handrail::test
