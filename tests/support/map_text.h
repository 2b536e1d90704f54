// Writes small .map files for tests: boxes and entities in map units.
#pragma once

#include <string>

#include "tests/support/names.h"

namespace handrail::test {

// Returns a box-shaped brush with six faces in the Standard format, all with one texture.
std::string box_brush(double x0, double y0, double z0, double x1, double y1, double z1,
                      const std::string& texture = "plain");
// Returns the text { "classname" "..." keys brushes } of an entity. Each of `keys` is a name and a value in quotes,
// followed by a line feed; see key().
std::string entity(const std::string& class_name, const std::string& keys = {}, const std::string& brushes = {});
std::string key(const std::string& name, const std::string& value);
// Returns a closed room of six slabs around the inner space from (x0, y0, z0) to (x1, y1, z1). Its walls are `thick`
// units thick.
std::string room_brushes(double x0, double y0, double z0, double x1, double y1, double z1, double thick = 16.0,
                         const std::string& texture = "plain");

}  // namespace handrail::test
