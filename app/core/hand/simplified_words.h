// Puts into words what was simplified for the hand at a scale, for a session and for reports. Pure functions for the
// app thread.
#pragma once

#include <string>
#include <vector>

#include "haptic/compile/compile_haptic.h"
#include "haptic/compile/simplify_scene.h"
#include "worlds/navigation/rooms.h"

namespace handrail::core {

// The openings between rooms that have no door: their numbers in RoomGraph::portals, and their positions.
struct OpenPortals {
    std::vector<std::uint32_t> portals;
    std::vector<Vec3> places_m;
};
OpenPortals open_portals(const navigation::RoomGraph& graph);
// Returns true if simplification needs the open portals at this scale. A walker fits through every portal of the room
// graph. If the hand can feel an opening of the walker's own width at this scale, it also feels every portal. Then the
// portals are not needed.
bool needs_openings(double world_m_per_hand_m, double body_radius_m);

// Returns "Simplified: 3 doorways widened, 12 small things left out.", or an empty text if nothing was simplified.
// `coarser` is the number of things whose meshes were made coarser.
std::string simplified_sentence(const compile::Simplification& plan, std::size_t coarser);
// Returns "felt with 2,300 of 80,000 triangles, at most 0.1 millimetres off in the hand".
std::string coarser_words(const compile::CoarserMesh& mesh, double world_m_per_hand_m);
// Returns "Front door" or "Opening between Hall and Kitchen". `graph` is null if the rooms are not known.
std::string opening_name(const Scene& scene, const compile::NarrowOpening& opening, const navigation::RoomGraph* graph,
                         const OpenPortals& portals);
// Returns the felt and the true width: "felt 1.6 metres wide, truly 1 metre".
std::string opening_words(const compile::NarrowOpening& opening);

}  // namespace handrail::core
