// The bodies that can be pushed, lifted and dropped, and what they meet: the building as convex parts, the driven
// things (doors, lifts), and the free bodies. compile_dynamics makes it from a Scene, or code does with
// DynamicsSceneBuilder. It never changes afterwards. The engine (haptic/dynamics) and the hand's side (haptic/servo)
// read it. A world without free bodies has none. Coordinates are local to origin_m except where `world` is said.
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

namespace handrail::render {

inline constexpr std::uint32_t kNoBody = 0xffffffffU;

// One convex part of the building, of a driven thing or of a body.
struct DynamicsPiece {
    RoundShape round;  // the round shape; if it has none, `solid` counts:
    ConvexSolid solid;
    Aabb bounds_m;
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
};
DynamicsPiece make_piece(ConvexSolid solid, FeatureId feature = kNoFeature, MaterialId material = kDefaultMaterial);
DynamicsPiece make_piece(const RoundShape& round, FeatureId feature = kNoFeature,
                         MaterialId material = kDefaultMaterial);
DynamicsPiece make_box_piece(const Aabb& box_m, FeatureId feature = kNoFeature, MaterialId material = kDefaultMaterial);
// Returns the same part in another frame: `at` is applied to the part's own coordinates.
DynamicsPiece placed_piece(const DynamicsPiece& piece, const Placement& at);
MassProperties mass_properties(const DynamicsPiece& piece) noexcept;
// A lower bound for how far a point is outside; negative or zero inside. Exact for one flat face and for round parts.
double gap_m(const DynamicsPiece& piece, const Vec3& point_m) noexcept;

// The physical properties of a body, apart from its shape. Ranges: DynamicsSceneBuilder::add_body.
struct BodyNature {
    double mass_kg = 1.0;
    // Friction against the building while sliding. Between two bodies it is the geometric mean of both.
    double friction = 0.4;
    double friction_static = 0.5;  // until sliding begins
    double elasticity = 0.2;
    // Share of the body's least half width; how far the support force of the floor runs ahead of a rolling body.
    double rolling = 0.1;
    // A rubber string from the body's centre to a place in the world.
    struct String {
        Vec3 at_m{0.0};
        double stiffness_n_per_m = 20.0;
    };
    std::optional<String> string;
};
// Damping of a string with a body at its end, against the body's speed, in Ns/m. It is a tenth of critical damping, as
// for rubber. 0 without a string.
double string_damping_ns_per_m(const BodyNature& nature) noexcept;

// A free body. Its frame is that of its mass: zero at the centre of mass, axes principal.
struct DynamicsBody {
    FeatureId feature = kNoFeature;
    std::uint32_t haptic = kNoBody;  // index in HapticScene::bodies
    double scale = 1.0;              // scale of the haptic body, which it keeps
    Placement middle_in_thing;       // pose of this frame in the haptic body's own frame, in its own metres times scale
    Placement start;                 // pose of this frame at the start, local
    std::vector<DynamicsPiece> pieces;  // in this frame
    BodyNature nature;
    Vec3 inertia_kg_m2{1.0};
    double reach_m = 0.0;       // no point of the body is farther from its centre of mass
    double half_width_m = 0.0;  // of the thinnest piece
    bool ball = false;          // the body is a single sphere
};
// Convert between the pose of the body's frame and the pose of its haptic thing.
Placement thing_of(const DynamicsBody& body, const Placement& middle) noexcept;
Placement middle_of(const DynamicsBody& body, const Placement& thing) noexcept;

// A thing that follows commands, whatever is in its way: a door leaf, a lift.
struct DrivenThing {
    FeatureId feature = kNoFeature;
    std::uint32_t haptic = kNoBody;
    Placement start;                    // local
    std::vector<DynamicsPiece> pieces;  // in its own frame, with its scale applied
    double reach_m = 0.0;               // no point is farther from the frame's zero
};

struct DynamicsScene {
    static constexpr std::size_t kMostBodies = 2048;
    static constexpr double kLip_m = 1e-3;  // lower steps between neighbours count as flat

    Vec3 origin_m{0.0};
    Vec3 gravity_m_per_s2{0.0, 0.0, -9.81};
    std::vector<DynamicsPiece> building;
    TriangleMesh sheets;                    // the parts of the building that have no inside
    std::vector<FeatureId> sheet_features;  // one for each triangle
    std::vector<DrivenThing> driven;
    std::vector<DynamicsBody> bodies;
    Aabb bounds_m;  // bounds of everything at the start

    // The pieces of the building that may cover face f of piece i: from neighbours[first_neighbour[first_face[i] + f]]
    // up to the first of the next face.
    std::vector<std::uint32_t> first_face, first_neighbour, neighbours;

    std::span<const std::uint32_t> beside(std::uint32_t piece, std::uint32_t face) const noexcept {
        const std::size_t at = first_face[piece] + face;
        return {neighbours.data() + first_neighbour[at], neighbours.data() + first_neighbour[at + 1]};
    }
};

// Returns the free body with that feature; kNoBody if there is none, or if the feature is kNoFeature.
std::uint32_t body_of(const DynamicsScene& scene, FeatureId feature) noexcept;

// The reason why a body was refused.
enum class BodyFault : std::uint8_t { None, TooMany, NoVolume, BadMass, BadNature, BadPlace };

// Collects pieces and bodies, then builds the scene. World metres. Off the real-time path; one thread.
class DynamicsSceneBuilder {
public:
    explicit DynamicsSceneBuilder(const Vec3& origin_m = Vec3(0.0)) { scene_.origin_m = origin_m; }

    void set_gravity(const Vec3& gravity_m_per_s2) { scene_.gravity_m_per_s2 = gravity_m_per_s2; }
    // Pieces without volume are ignored.
    void add_fixed(const DynamicsPiece& piece);
    void add_fixed_box(const Aabb& box_m, FeatureId feature = kNoFeature) { add_fixed(make_box_piece(box_m, feature)); }
    void add_sheet(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m, FeatureId feature = kNoFeature);
    // Pieces in the thing's own frame. Returns its index in DynamicsScene::driven; kNoBody if no piece has volume.
    std::uint32_t add_driven(std::span<const DynamicsPiece> pieces, FeatureId feature, std::uint32_t haptic,
                             const Placement& start);
    // Pieces in the thing's own frame. Ranges: mass 0.01 to 10,000 kg, friction 0 to 10, elasticity 0 to 0.95, rolling
    // 0 to 1, stiffness of a string up to 10,000 N/m.
    BodyFault add_body(std::span<const DynamicsPiece> pieces, FeatureId feature, std::uint32_t haptic,
                       const Placement& start, const BodyNature& nature);

    std::shared_ptr<const DynamicsScene> build();

private:
    DynamicsScene scene_;
};

}  // namespace handrail::render
