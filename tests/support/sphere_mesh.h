// Makes tessellated spheres, and hands that slide over them. They show how the density of triangles affects a
// renderer's cost.
#pragma once

#include <vector>

#include "tests/support/names.h"
#include "worlds/geometry/triangle_mesh.h"

namespace handrail::test {

// Returns an icosahedron with each face cut into frequency^2 triangles and every point moved out to the radius. It has
// 20 frequency^2 triangles of nearly equal size and 10 frequency^2 + 2 points; its centre is the origin. The
// frequencies 7, 22, 71 and 224 give 980, 9,680, 100,820 and 1,003,520 triangles.
TriangleMesh sphere_mesh(int frequency, double radius_m);

// Returns the cap around the upper pole of a sphere of meridians and parallels, whose centre is the origin. `sectors`
// triangles meet in the pole. There are `rings` parallels, `ring_m` apart, with two triangles per sector between
// neighbouring parallels.
TriangleMesh pole_mesh(int sectors, int rings, double ring_m, double sphere_radius_m);

// Returns goals at 1 kHz. The hand goes down near the pole and then slides to and fro over it at the given speed, 3 mm
// deep and up to 20 mm to either side. It passes the pole at distances of up to 1 mm, and its direction turns around
// the pole.
std::vector<Vec3> pole_slide(double sphere_radius_m, double proxy_radius_m, double speed_m_per_s, int ticks);

// Returns goals at 1 kHz. The hand goes down to the sphere once, from 20 mm above it. Then it follows an oblique,
// slowly turning path at the given speed, pressed 2 to 5 mm deep (one wave of depth per 0.7 s). It never repeats a row
// of triangles.
std::vector<Vec3> sphere_slide(double sphere_radius_m, double proxy_radius_m, double speed_m_per_s, int ticks);

}  // namespace handrail::test
