// What can be pushed, lifted and dropped, and what it meets: the building as convex parts, the things that are driven
// (doors, lifts), and the bodies that are free. Made by compile_dynamics from a Scene, or in code by
// DynamicsSceneBuilder; never changed afterwards; read by the engine (haptic/dynamics) and by the hand's side
// (haptic/servo). A world without free bodies has none of these. Coordinates are local to origin_m except where `world`
// is said.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/geometry/convex.h"
#include "worlds/geometry/mass_properties.h"
#include "worlds/geometry/placement.h"
#include "worlds/geometry/round_shapes.h"
#include "worlds/geometry/triangle_mesh.h"

namespace handrail {

inline constexpr std::uint32_t kNoBody = 0xffffffffU;

// One convex part of the building, of a driven thing or of a body.
struct DynamicsPiece {
    RoundShape round;  // what it is; else the flat solid:
    ConvexSolid solid;
    Aabb bounds_m;
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
};
DynamicsPiece make_piece(ConvexSolid solid, FeatureId feature = kNoFeature, MaterialId material = kDefaultMaterial);
DynamicsPiece make_piece(const RoundShape& round, FeatureId feature = kNoFeature,
                         MaterialId material = kDefaultMaterial);
DynamicsPiece make_box_piece(const Aabb& box_m, FeatureId feature = kNoFeature, MaterialId material = kDefaultMaterial);
// The same part seen from another frame: own becomes `at` applied to own.
DynamicsPiece placed_piece(const DynamicsPiece& piece, const Placement& at);
MassProperties mass_properties(const DynamicsPiece& piece) noexcept;
// How far a point lies outside, at least; negative or zero inside. Exact for one flat face and for round parts.
double gap_m(const DynamicsPiece& piece, const Vec3& point_m) noexcept;

// What a body is made of, apart from its shape. Ranges: DynamicsSceneBuilder::add_body.
struct BodyNature {
    double mass_kg = 1.0;
    // Against the building, while it slides; between two bodies the mean of both, by multiplication.
    double friction = 0.4;
    double friction_static = 0.5;  // until it slides
    double elasticity = 0.2;
    double rolling = 0.1;  // of its least half width: how far the push of the floor runs ahead of a rolling body
    // A rubber string from the body's middle to a world place.
    struct String {
        Vec3 at_m{0.0};
        double stiffness_n_per_m = 20.0;
    };
    std::optional<String> string;
};
// Of a string with a body at its end, against the body's speed: a tenth of what would keep it from swinging at all, as
// rubber has it. Ns/m; 0 without a string.
double string_damping_ns_per_m(const BodyNature& nature) noexcept;

// Free. Its frame is that of its mass: zero in the middle, axes principal.
struct DynamicsBody {
    FeatureId feature = kNoFeature;
    std::uint32_t haptic = kNoBody;     // place in HapticScene::bodies
    double scale = 1.0;                 // of the haptic body, which keeps it
    Placement middle_in_thing;          // this frame within the haptic body's own, in its own metres times scale
    Placement start;                    // of this frame, local
    std::vector<DynamicsPiece> pieces;  // in this frame
    BodyNature nature;
    Vec3 inertia_kg_m2{1.0};
    double reach_m = 0.0;       // no point is farther from the middle
    double half_width_m = 0.0;  // of the thinnest piece
    bool ball = false;          // one sphere
};
// Where the thing stands whose body's frame stands here, and the other way round.
Placement thing_of(const DynamicsBody& body, const Placement& middle) noexcept;
Placement middle_of(const DynamicsBody& body, const Placement& thing) noexcept;

// Goes where it is told, whatever stands in its way: a door leaf, a lift.
struct DrivenThing {
    FeatureId feature = kNoFeature;
    std::uint32_t haptic = kNoBody;
    Placement start;                    // local
    std::vector<DynamicsPiece> pieces;  // own frame, its scale applied
    double reach_m = 0.0;               // no point is farther from the frame's zero
};

struct DynamicsScene {
    static constexpr std::size_t kMostBodies = 2048;
    static constexpr double kLip_m = 1e-3;  // steps lower than this between neighbours are none

    Vec3 origin_m{0.0};
    Vec3 gravity_m_per_s2{0.0, 0.0, -9.81};
    std::vector<DynamicsPiece> building;
    TriangleMesh sheets;                    // of the building, what has no inside
    std::vector<FeatureId> sheet_features;  // per triangle
    std::vector<DrivenThing> driven;
    std::vector<DynamicsBody> bodies;
    Aabb bounds_m;  // around everything, as it stands at the start

    // Which pieces of the building may cover face f of piece i: neighbours[first_neighbour[first_face[i] + f]] up to
    // that of the next face.
    std::vector<std::uint32_t> first_face, first_neighbour, neighbours;

    std::span<const std::uint32_t> beside(std::uint32_t piece, std::uint32_t face) const noexcept {
        const std::size_t at = first_face[piece] + face;
        return {neighbours.data() + first_neighbour[at], neighbours.data() + first_neighbour[at + 1]};
    }
};

// The free body of that name among others; kNoBody: there is none, or it has no name.
std::uint32_t body_of(const DynamicsScene& scene, FeatureId feature) noexcept;

// Why a body could not be added.
enum class BodyFault : std::uint8_t { None, TooMany, NoVolume, BadMass, BadNature, BadPlace };

// World metres. Off the real-time path; one thread.
class DynamicsSceneBuilder {
public:
    explicit DynamicsSceneBuilder(const Vec3& origin_m = Vec3(0.0)) { scene_.origin_m = origin_m; }

    void set_gravity(const Vec3& gravity_m_per_s2) { scene_.gravity_m_per_s2 = gravity_m_per_s2; }
    // Pieces without volume are left out.
    void add_fixed(const DynamicsPiece& piece);
    void add_fixed_box(const Aabb& box_m, FeatureId feature = kNoFeature) { add_fixed(make_box_piece(box_m, feature)); }
    void add_sheet(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m, FeatureId feature = kNoFeature);
    // Pieces in the thing's own frame. Returns its place in DynamicsScene::driven; kNoBody when nothing of it has
    // volume.
    std::uint32_t add_driven(std::span<const DynamicsPiece> pieces, FeatureId feature, std::uint32_t haptic,
                             const Placement& start);
    // Pieces in the thing's own frame. mass 0.01 to 10,000 kg, friction 0 to 10, elasticity 0 to 0.95, rolling 0 to 1,
    // a string's stiffness up to 10,000 N/m.
    BodyFault add_body(std::span<const DynamicsPiece> pieces, FeatureId feature, std::uint32_t haptic,
                       const Placement& start, const BodyNature& nature);

    std::shared_ptr<const DynamicsScene> build();

private:
    DynamicsScene scene_;
};

}  // namespace handrail
