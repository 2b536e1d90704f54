// What was simplified for the hand at a scale, in words for a session and for reports. Pure functions; app thread.
#pragma once

#include <string>
#include <vector>

#include "haptic/compile/compile_haptic.h"
#include "haptic/compile/simplify_scene.h"
#include "worlds/navigation/rooms.h"

namespace handrail::core {

// The openings between rooms that have no door: their numbers in RoomGraph::portals, and their places.
struct OpenPortals {
    std::vector<std::uint32_t> portals;
    std::vector<Vec3> places_m;
};
OpenPortals open_portals(const navigation::RoomGraph& graph);
// True if the scale needs these openings. A walker fits through every opening that the rooms know, so at a scale where
// its own width can be felt they are not needed.
bool asks_for_openings(double world_m_per_hand_m, double body_radius_m);

// "Simplified: 3 doorways widened, 12 small things left out."; empty if nothing is. coarser: things whose meshes are
// coarser than in truth.
std::string simplified_sentence(const compile::Simplification& plan, std::size_t coarser);
// "felt with 2,300 of 80,000 triangles, at most 0.1 millimetres off in the hand".
std::string coarser_words(const compile::CoarserMesh& mesh, double world_m_per_hand_m);
// "Front door", "Opening between Hall and Kitchen"; graph: null where the rooms are not known.
std::string opening_name(const Scene& scene, const compile::NarrowOpening& opening, const navigation::RoomGraph* graph,
                         const OpenPortals& portals);
// "felt 1.6 metres wide, truly 1 metre".
std::string opening_words(const compile::NarrowOpening& opening);

}  // namespace handrail::core
