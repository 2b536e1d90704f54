// Tessellated spheres and a hand that slides over them: where a renderer shows what the density of triangles costs it.
#pragma once

#include <vector>

#include "worlds/geometry/triangle_mesh.h"

namespace handrail::test {

// An icosahedron with each face cut into frequency^2 triangles and every point pushed out to the radius: 20 frequency^2
// triangles of nearly one size, 10 frequency^2 + 2 points. Centre at zero. 7, 22, 71, 224 give 980, 9,680, 100,820 and
// 1,003,520 triangles.
TriangleMesh sphere_mesh(int frequency, double radius_m);

// The cap round the upper pole of a sphere of meridians and parallels: `sectors` triangles meet in the pole, and
// between it and the last of `rings` parallels, each so far from the one before, lie two triangles for each sector.
// Centre of the sphere at zero.
TriangleMesh pole_mesh(int sectors, int rings, double ring_m, double sphere_radius_m);

// Goals at 1 kHz: down beside the pole, then to and fro over it, 3 mm deep, up to 20 mm to either side, missing it by
// up to 1 mm and turning round it, at this speed where it passes.
std::vector<Vec3> pole_slide(double sphere_radius_m, double ball_radius_m, double speed_m_per_s, int ticks);

// Goals at 1 kHz: once down on the sphere from 20 mm above, then along an oblique, slowly turning way at this speed,
// pressed 2 to 5 mm deep (one wave of depth per 0.7 s). Never repeats a triangle row by row.
std::vector<Vec3> sphere_slide(double sphere_radius_m, double ball_radius_m, double speed_m_per_s, int ticks);

}  // namespace handrail::test
