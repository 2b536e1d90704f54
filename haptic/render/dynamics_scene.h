// Contains the bodies that can be pushed, lifted and dropped, and the objects that they can hit: the building as convex
// parts, the driven things (doors, lifts), and the free bodies themselves. compile_dynamics() makes it from a Scene;
// other code uses DynamicsSceneBuilder. A DynamicsScene never changes after it was built. The engine (haptic/dynamics)
// and the servo (haptic/servo) read it. A world without free bodies has none. Coordinates are local to origin_m unless
// a comment says `world`.
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
    RoundShape round;  // if the piece has a round shape, that shape is its geometry, otherwise `solid`
    ConvexSolid solid;
    Aabb bounds_m;
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
};
DynamicsPiece make_piece(ConvexSolid solid, FeatureId feature = kNoFeature, MaterialId material = kDefaultMaterial);
DynamicsPiece make_piece(const RoundShape& round, FeatureId feature = kNoFeature,
                         MaterialId material = kDefaultMaterial);
DynamicsPiece make_box_piece(const Aabb& box_m, FeatureId feature = kNoFeature, MaterialId material = kDefaultMaterial);
// Returns the part in another frame, by applying the pose `at` to the part's coordinates.
DynamicsPiece placed_piece(const DynamicsPiece& piece, const Placement& at);
MassProperties mass_properties(const DynamicsPiece& piece) noexcept;
// Returns a lower bound for the distance between the point and the piece; negative or zero if the point is inside. The
// bound is exact in front of a flat face and for round parts.
double gap_m(const DynamicsPiece& piece, const Vec3& point_m) noexcept;

// The physical properties of a body, apart from its shape. DynamicsSceneBuilder::add_body states their ranges.
struct BodyNature {
    double mass_kg = 1.0;
    // Coefficient of friction while the body slides on the building. Between two bodies, the geometric mean of both
    // applies.
    double friction = 0.4;
    double friction_static = 0.5;  // coefficient of friction until the body begins to slide
    double elasticity = 0.2;
    // Rolling resistance: how far the floor's support force is ahead of a rolling body's centre, as a share of the
    // body's least half width.
    double rolling = 0.1;
    // A rubber string from the body's centre to a fixed point in the world.
    struct String {
        Vec3 at_m{0.0};
        double stiffness_n_per_m = 20.0;
    };
    std::optional<String> string;
};
// Returns the damping against the velocity of a body that hangs on a string, in Ns/m. It is a tenth of critical
// damping, as for rubber. 0 if the body has no string.
double string_damping_ns_per_m(const BodyNature& nature) noexcept;

// A free body. The origin of its frame is the centre of mass, and the axes are the principal axes.
struct DynamicsBody {
    FeatureId feature = kNoFeature;
    std::uint32_t haptic = kNoBody;  // index in HapticScene::bodies
    double scale = 1.0;              // scale of the haptic body, which never changes
    // Pose of this frame in the haptic body's own frame, in that frame's metres times `scale`.
    Placement middle_in_thing;
    Placement start;                    // pose of this frame at the start, local coordinates
    std::vector<DynamicsPiece> pieces;  // the parts of the body, in its own frame
    BodyNature nature;
    Vec3 inertia_kg_m2{1.0};
    double reach_m = 0.0;       // distance from the centre of mass to the farthest point of the body
    double half_width_m = 0.0;  // half the width of the thinnest piece
    bool ball = false;          // true if the body is a single sphere
};
// Convert between the pose of the body's frame and the pose of its haptic body.
Placement thing_of(const DynamicsBody& body, const Placement& middle) noexcept;
Placement middle_of(const DynamicsBody& body, const Placement& thing) noexcept;

// A thing that follows commands whatever obstructs it, such as a door leaf or a lift.
struct DrivenThing {
    FeatureId feature = kNoFeature;
    std::uint32_t haptic = kNoBody;
    Placement start;                    // pose at the start, local coordinates
    std::vector<DynamicsPiece> pieces;  // in the thing's own frame, with its scale applied
    double reach_m = 0.0;               // distance from the frame's origin to the thing's farthest point
};

struct DynamicsScene {
    static constexpr std::size_t kMostBodies = 2048;
    static constexpr double kLip_m = 1e-3;  // greatest step between two parts that are still treated as flush

    Vec3 origin_m{0.0};
    Vec3 gravity_m_per_s2{0.0, 0.0, -9.81};
    std::vector<DynamicsPiece> building;
    TriangleMesh sheets;                    // triangles of the building that do not enclose a volume
    std::vector<FeatureId> sheet_features;  // feature of each triangle
    std::vector<DrivenThing> driven;
    std::vector<DynamicsBody> bodies;
    Aabb bounds_m;  // bounds of all parts at the start, local coordinates

    // The pieces of the building that may cover face f of piece i. They begin at
    // neighbours[first_neighbour[first_face[i] + f]] and end before the first one of the next face.
    std::vector<std::uint32_t> first_face, first_neighbour, neighbours;

    std::span<const std::uint32_t> beside(std::uint32_t piece, std::uint32_t face) const noexcept {
        const std::size_t at = first_face[piece] + face;
        return {neighbours.data() + first_neighbour[at], neighbours.data() + first_neighbour[at + 1]};
    }
};

// Returns the index of the free body with that feature. Returns kNoBody if there is none, or if the feature is
// kNoFeature.
std::uint32_t body_of(const DynamicsScene& scene, FeatureId feature) noexcept;

// The reason why add_body() rejected a body.
enum class BodyFault : std::uint8_t { None, TooMany, NoVolume, BadMass, BadNature, BadPlace };

// Collects pieces and bodies in world metres, then builds the scene. Not for the servo thread; one thread.
class DynamicsSceneBuilder {
public:
    explicit DynamicsSceneBuilder(const Vec3& origin_m = Vec3(0.0)) { scene_.origin_m = origin_m; }

    void set_gravity(const Vec3& gravity_m_per_s2) { scene_.gravity_m_per_s2 = gravity_m_per_s2; }
    // Adds a fixed part of the building. A piece without volume is ignored.
    void add_fixed(const DynamicsPiece& piece);
    void add_fixed_box(const Aabb& box_m, FeatureId feature = kNoFeature) { add_fixed(make_box_piece(box_m, feature)); }
    void add_sheet(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m, FeatureId feature = kNoFeature);
    // Adds a driven thing, with pieces in the thing's own frame. Returns its index in DynamicsScene::driven, or kNoBody
    // if no piece has volume.
    std::uint32_t add_driven(std::span<const DynamicsPiece> pieces, FeatureId feature, std::uint32_t haptic,
                             const Placement& start);
    // Adds a free body, with pieces in the thing's own frame. Ranges: mass 0.01 to 10,000 kg, friction 0 to 10,
    // elasticity 0 to 0.95, rolling 0 to 1, stiffness of a string up to 10,000 N/m.
    BodyFault add_body(std::span<const DynamicsPiece> pieces, FeatureId feature, std::uint32_t haptic,
                       const Placement& start, const BodyNature& nature);

    std::shared_ptr<const DynamicsScene> build();

private:
    DynamicsScene scene_;
};

}  // namespace handrail::render
