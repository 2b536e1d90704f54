#include "haptic/dynamics/dynamics.h"

#include <BulletCollision/CollisionDispatch/btInternalEdgeUtility.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>

#include "haptic/dynamics/bullet_shapes.h"
#include "haptic/dynamics/seams.h"
#include "worlds/base/contract.h"
#include "worlds/geometry/clip.h"

namespace handrail::dynamics {
namespace {

constexpr double kH = Dynamics::kStep_s;
// Distance at which Bullet already reports contacts. The servo's model of a body relies on contacts that are reported
// this early.
constexpr double kMostReach_m = 0.1;
// Greatest speed of a body. It is 83 mm a step, which is less than kMostReach_m.
constexpr double kMostSpeed_m_per_s = 20.0;
constexpr double kMostTurn_rad_per_s = 60.0;
constexpr double kJammed_m = 3e-3;      // depth of a body in a driven thing from which on the body is jammed
constexpr double kMostDrive_n = 400.0;  // greatest force with which a door or train pushes a body
constexpr double kCatchUp_m = 2e-3;     // how far a driven thing moves in each step after it waited for a jammed body
constexpr int kJammedSteps = 60;        // number of steps that a driven thing waits before it tries to move again
constexpr double kOutside_m = 5.0;      // a body this far outside the scene's bounds is put back at its start
constexpr double kHit_m_per_s = 0.15;
constexpr double kHitAgain_s = 0.05;
constexpr double kPressed_m = 1e-3;  // overlap with the walker from which on the walker's motion carries a body along
constexpr double kWhole = 1e-6;
// Steps between two sound events of a rolling or sliding body; 12 steps give 20 events a second.
constexpr int kMovingSteps = 12;
constexpr int kFallingSteps = 24;  // number of steps without contact after which a body is falling

enum Kind : int { kBuilding, kSheets, kDriven, kBody, kWalker };
Kind kind_of(const btCollisionObject& object) { return static_cast<Kind>(object.getUserIndex2()); }

const btSphereShape* ball_of(const btCollisionShape& shape) {
    return shape.getShapeType() == SPHERE_SHAPE_PROXYTYPE ? static_cast<const btSphereShape*>(&shape) : nullptr;
}

// Returns the point of a rolling part (a ball or a cylinder) that is lowest along `normal`. A contact point ahead of
// the lowest one would move down while the part rolls, and throw the part up.
btVector3 lowest(const btCollisionObjectWrapper& part, const btVector3& on_body, const btVector3& normal) {
    const btTransform& at = part.getWorldTransform();
    if (const btSphereShape* ball = ball_of(*part.getCollisionShape()))
        return at.getOrigin() - normal * ball->getRadius();
    if (part.getCollisionShape()->getShapeType() != CYLINDER_SHAPE_PROXYTYPE) return on_body;
    const btVector3 axis = at.getBasis().getColumn(2), out = normal - axis * axis.dot(normal);
    if (out.length2() < 0.25) return on_body;  // the cylinder stands upright
    const double along = axis.dot(on_body - at.getOrigin());
    return at.getOrigin() + axis * along -
           out.normalized() * static_cast<const btCylinderShape*>(part.getCollisionShape())->getRadius();
}

// Moves a contact between a body and part `piece` of the building to a face that can be touched. Removes the contact if
// there is no such face.
void put_on_open_face(const render::DynamicsScene& scene, std::uint32_t piece, btManifoldPoint& contact,
                      const btCollisionObjectWrapper& body, const btCollisionObject& building, bool building_is_b) {
    const btVector3 on_building = building_is_b ? contact.m_positionWorldOnB : contact.m_positionWorldOnA;
    btVector3 on_body = building_is_b ? contact.m_positionWorldOnA : contact.m_positionWorldOnB;
    const btVector3 normal = contact.m_normalWorldOnB * (building_is_b ? 1.0 : -1.0);
    const SeamVerdict verdict = judge_seam(scene, piece, ours(on_building), ours(normal),
                                           ours(body.getCollisionObject()->getWorldTransform().getOrigin()));
    if (verdict.kind == SeamVerdict::Kind::True) return;
    btVector3 face_normal = normal,
              // The default verdict is a false contact. It is moved a metre away, so that Bullet drops it at its next
              // refresh.
        on_face = on_building - normal;
    if (verdict.kind == SeamVerdict::Kind::Face) {
        const Plane& face = scene.building[piece].solid.planes[verdict.face];
        face_normal = bullet(face.normal);
        on_body = lowest(body, on_body, face_normal);
        on_face = on_body - face_normal * (face_normal.dot(on_body) - face.offset_m);
    }
    contact.m_normalWorldOnB = face_normal * (building_is_b ? 1.0 : -1.0);
    (building_is_b ? contact.m_positionWorldOnB : contact.m_positionWorldOnA) = on_face;
    (building_is_b ? contact.m_localPointB : contact.m_localPointA) = building.getWorldTransform().invXform(on_face);
    (building_is_b ? contact.m_positionWorldOnA : contact.m_positionWorldOnB) = on_body;
    (building_is_b ? contact.m_localPointA : contact.m_localPointB) =
        body.getCollisionObject()->getWorldTransform().invXform(on_body);
    contact.m_distance1 = (on_body - on_face).dot(face_normal);
}

// Bullet calls this function for every contact that it finds or refreshes. There is only one callback for the whole
// process, so each object carries a pointer to its scene.
bool contact_added(btManifoldPoint& contact, const btCollisionObjectWrapper* a, int part_a, int index_a,
                   const btCollisionObjectWrapper* b, int part_b, int index_b) {
    const btCollisionObject &object_a = *a->getCollisionObject(), &object_b = *b->getCollisionObject();
    const Kind kind_a = kind_of(object_a), kind_b = kind_of(object_b);
    if (kind_a == kBody && kind_b == kBody) {
        contact.m_combinedFriction = std::sqrt(contact.m_combinedFriction);
        return true;
    }
    if (kind_a == kBuilding || kind_b == kBuilding) {
        const bool b_is = kind_b == kBuilding;
        const int child = b_is ? index_b : index_a;
        const auto& scene = *static_cast<const render::DynamicsScene*>((b_is ? object_b : object_a).getUserPointer());
        if (child >= 0 && static_cast<std::size_t>(child) < scene.building.size())
            put_on_open_face(scene, static_cast<std::uint32_t>(child), contact, b_is ? *a : *b,
                             b_is ? object_b : object_a, b_is);
        return true;
    }
    if (kind_b == kSheets) btAdjustInternalEdgeContacts(contact, b, a, part_b, index_b);
    else if (kind_a == kSheets) btAdjustInternalEdgeContacts(contact, a, b, part_a, index_a);
    return true;
}

void set_up_bullet() {
    static std::once_flag done;
    std::call_once(done, [] {
        gContactBreakingThreshold = kMostReach_m;
        gContactAddedCallback = &contact_added;
    });
}

// Chooses the contact threshold of each pair of objects. Bullet merges contacts that are nearer to each other than this
// threshold, so small bodies need a small one.
class Dispatcher final : public btCollisionDispatcher {
public:
    explicit Dispatcher(btCollisionConfiguration* configuration) : btCollisionDispatcher(configuration) {
        setDispatcherFlags(getDispatcherFlags() & ~CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD);
    }
    btPersistentManifold* getNewManifold(const btCollisionObject* a, const btCollisionObject* b) override {
        btPersistentManifold* manifold = btCollisionDispatcher::getNewManifold(a, b);
        manifold->setContactBreakingThreshold(std::min(reach_m(*a), reach_m(*b)));
        return manifold;
    }

private:
    static double reach_m(const btCollisionObject& object) {
        if (kind_of(object) != kBody) return kMostReach_m;
        const auto& scene = *static_cast<const render::DynamicsScene*>(object.getUserPointer());
        return std::min(kMostReach_m, 0.5 * scene.bodies[static_cast<std::size_t>(object.getUserIndex())].half_width_m);
    }
};

struct Body {
    std::unique_ptr<btRigidBody> rigid;
    render::Stick stick;
    // Present mass for the inertia. While both hands push the body, it may be greater than the body's mass.
    double inertial_kg = 0.0;
    bool waiting = false;   // the engine holds it still until fewer bodies move
    bool forced = false;    // at least one of the forces below acts in this step
    bool reported = false;  // the engine has reported its pose since it last moved
    Vec3 kept_m_per_s{0.0}, kept_rad_per_s{0.0};
    std::optional<btTransform> sleeps_at;  // pose at which it fell asleep; empty while it is awake
    // Forces and torques in this step, from each hand, from the keyboard's grip (lead) and from the walker (shove).
    std::array<Vec3, 2> hand_n{Vec3(0.0), Vec3(0.0)}, hand_nm{Vec3(0.0), Vec3(0.0)};
    std::array<double, 2> pushed_s{-1e9, -1e9};  // time at which each hand last pushed the body
    double near_s = -1e9;                        // time at which a hand was last near the body
    std::array<double, 2> least_kg{0.0, 0.0};
    Vec3 lead_n{0.0}, lead_nm{0.0}, shove_n{0.0};
    // State from which the sound events of the body are detected.
    Vec3 speed_before{0.0};
    double hit_s = -1e9;
    int moving = 0, airborne = 0;
    bool falling = false, rested = true;
};

struct Driven {
    std::unique_ptr<btRigidBody> rigid;
    Placement to;  // commanded pose, scene's local coordinates
    bool present = true, blocked = false;
    int jammed = 0;  // number of steps for which the driven thing still waits for a jammed body
    // True after the driven thing had to wait for a jammed body. It then approaches its commanded pose gradually.
    bool catches_up = false;
    double way_m = 0.0;  // distance that the driven thing moved in the last step
    // Direction in which the driven thing pressed the jammed body. The driven thing may move away from that body.
    Vec3 pushed{0.0};
};

struct Lead {
    std::uint32_t body = render::kNoBody;
    Vec3 to_m{0.0};  // target in the scene's local coordinates
    double most_n = 0.0;
    Rotation turn;
};

// A push with which the walker moves a body.
struct Shove {
    std::uint32_t body = render::kNoBody;
    Vec3 speed_m_per_s{0.0};  // horizontal, never zero
    double most_n = 0.0, left_s = 0.0;
};

// The strongest contact of a body in one step.
struct Touched {
    double impulse = 0.0;
    FeatureId feature = kNoFeature;
    std::uint32_t body = render::kNoBody;
    btVector3 at{0, 0, 0}, own{0, 0, 0};
    bool any = false;
};

// Returns the small rotation from one orientation to the other as a vector along its axis.
Vec3 turn_between(const Rotation& from, const Rotation& to) {
    const Rotation d = to * Rotation{from.w, -from.x, -from.y, -from.z};
    const double two = d.w < 0.0 ? -2.0 : 2.0;
    return {two * d.x, two * d.y, two * d.z};
}

Vec3 at_most(const Vec3& v, double most) {
    const double length = glm::length(v);
    return length > most ? v * (most / length) : v;
}

// Bullet's world and all objects in it. Declared in this order because C++ destroys members in reverse.
struct World {
    BulletShapes shapes;
    btDefaultCollisionConfiguration configuration;
    Dispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
    std::vector<std::unique_ptr<btCollisionObject>> still;
    std::vector<Driven> driven;
    std::vector<Body> bodies;
    std::unique_ptr<btCapsuleShapeZ> walker_shape;
    std::unique_ptr<btRigidBody> walker;
    std::array<std::vector<render::HandPush>, 2> pushes;
    std::vector<Lead> leads;
    std::vector<Shove> shoves;
    // Scratch buffers, kept to avoid allocations.
    std::vector<Touched> touched;
    std::vector<std::pair<double, std::uint32_t>> order;

    explicit World(const render::DynamicsScene& scene);
    ~World();

    // Returns true if a body overlapped the walker in the last step.
    bool walker_pressed();
    btRigidBody* kinematic(std::unique_ptr<btRigidBody>& owner, btCollisionShape* shape,
                           const render::DynamicsScene& scene, Kind kind, int index, const Placement& at);
};

// Collision groups; still and driven objects do not collide with each other.
constexpr int kStillGroup = 2, kFreeGroup = 1;

void mark(btCollisionObject& object, const render::DynamicsScene& scene, Kind kind, int index) {
    object.setUserPointer(const_cast<render::DynamicsScene*>(&scene));
    object.setUserIndex(index);
    object.setUserIndex2(kind);
    object.setCollisionFlags(object.getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
}

btRigidBody* World::kinematic(std::unique_ptr<btRigidBody>& owner, btCollisionShape* shape,
                              const render::DynamicsScene& scene, Kind kind, int index, const Placement& at) {
    owner = std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(0.0, nullptr, shape));
    mark(*owner, scene, kind, index);
    owner->setCollisionFlags((owner->getCollisionFlags() & ~btCollisionObject::CF_STATIC_OBJECT) |
                             btCollisionObject::CF_KINEMATIC_OBJECT);
    owner->setWorldTransform(bullet(at));
    owner->setInterpolationWorldTransform(bullet(at));
    owner->setFriction(1.0);
    owner->setRestitution(1.0);
    owner->forceActivationState(ISLAND_SLEEPING);
    world.addRigidBody(owner.get(), kStillGroup, kFreeGroup);
    return owner.get();
}

World::World(const render::DynamicsScene& scene) {
    world.setGravity(bullet(scene.gravity_m_per_s2));
    world.setLatencyMotionStateInterpolation(false);
    world.setForceUpdateAllAabbs(false);
    // Bullet pushes a body out of an object that it overlaps, without giving it speed.
    world.getSolverInfo().m_splitImpulsePenetrationThreshold = -1e-4;
    const auto add_still = [&](btCollisionShape* shape, Kind kind) {
        auto object = std::make_unique<btCollisionObject>();
        object->setCollisionShape(shape);
        mark(*object, scene, kind, 0);
        object->setFriction(1.0);
        object->setRestitution(1.0);
        // If the object were active, Bullet would test resting bodies against it for ever.
        object->setActivationState(ISLAND_SLEEPING);
        world.addCollisionObject(object.get(), kStillGroup, kFreeGroup);
        still.push_back(std::move(object));
    };
    if (!scene.building.empty()) add_still(shapes.together(scene.building, true), kBuilding);
    if (btCollisionShape* sheets = shapes.sheets(scene.sheets)) add_still(sheets, kSheets);
    driven.resize(scene.driven.size());
    for (std::size_t i = 0; i < driven.size(); ++i) {
        driven[i].to = scene.driven[i].start;
        kinematic(driven[i].rigid, shapes.together(scene.driven[i].pieces, false), scene, kDriven, static_cast<int>(i),
                  scene.driven[i].start);
    }
    bodies.resize(scene.bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const render::DynamicsBody& body = scene.bodies[i];
        Body& made = bodies[i];
        made.inertial_kg = body.nature.mass_kg;
        btRigidBody::btRigidBodyConstructionInfo info(body.nature.mass_kg, nullptr, shapes.together(body.pieces, false),
                                                      bullet(body.inertia_kg_m2));
        made.rigid = std::make_unique<btRigidBody>(info);
        btRigidBody& rigid = *made.rigid;
        mark(rigid, scene, kBody, static_cast<int>(i));
        rigid.setWorldTransform(bullet(body.start));
        rigid.setInterpolationWorldTransform(bullet(body.start));
        rigid.setFriction(body.nature.friction);
        rigid.setRollingFriction(body.nature.rolling * body.half_width_m);
        rigid.setSpinningFriction(body.nature.rolling * body.half_width_m);
        rigid.setRestitution(body.nature.elasticity);
        // Lowers the thresholds for sleeping, because with Bullet's defaults a body that a hand pushes slowly would
        // fall asleep.
        rigid.setSleepingThresholds(0.01, 0.02);
        // Bullet sweeps a small sphere at the body's centre, so that a fast body cannot pass through an object that the
        // rest of the body already overlaps. The sphere is so small that it seldom overlaps the object, too: a sweep
        // that begins inside an object finds nothing.
        rigid.setCcdMotionThreshold(0.1 * body.half_width_m);
        rigid.setCcdSweptSphereRadius(0.1 * body.half_width_m);
        world.addRigidBody(&rigid, kFreeGroup, kStillGroup | kFreeGroup);
        if (i < Dynamics::kMostAwake) continue;
        made.waiting = true;
        rigid.forceActivationState(DISABLE_SIMULATION);
    }
    touched.resize(bodies.size());
    order.resize(bodies.size());
}

World::~World() {
    for (Body& body : bodies) world.removeRigidBody(body.rigid.get());
    if (walker) world.removeRigidBody(walker.get());
    for (Driven& thing : driven) world.removeRigidBody(thing.rigid.get());
    for (auto& object : still) world.removeCollisionObject(object.get());
}

}  // namespace

struct Dynamics::Impl {
    std::shared_ptr<const render::DynamicsScene> scene;
    std::unique_ptr<World> world;
    std::array<render::HandPlace, 2> hands{};
    double begin_s = 0.0;
    std::uint64_t steps = 0;
    std::uint32_t game = 1;
    std::vector<Placement> things;  // poses of the driven things that were last reported

    double now_s() const { return begin_s + static_cast<double>(steps) * kH; }
    Vec3 local(const Vec3& world_m) const { return world_m - scene->origin_m; }
    btRigidBody& rigid(std::size_t body) { return *world->bodies[body].rigid; }
    void wake(std::size_t body) {
        if (!world->bodies[body].waiting) rigid(body).activate(true);
    }

    void take_pushes(unsigned hand);
    void apply_forces();
    void apply_lead(const Lead& lead);
    void apply_shove(Shove& shove);
    void weigh(std::size_t body);
    void rub(std::size_t body);
    void wake_near_hands();
    void drive_things();
    void limit_awake(render::DynamicsFrame& out);
    void put_back(std::size_t body, std::vector<render::BodyEvent>& events);
    double gap_to_m(std::size_t body, const Vec3& local_m) const;
    // Returns true if the body rests or is held still, and its last sound event told this to the app.
    bool is_silent(std::size_t i) const {
        const Body& body = world->bodies[i];
        return !body.rigid->isActive() && (body.rested || body.waiting);
    }
    void hear(std::vector<render::BodyEvent>& events);
    void note_touched();
    FeatureId feature_of(const btCollisionObject& object, int child) const;
    void hear_body(std::size_t i, const Touched& t, std::vector<render::BodyEvent>& events);
    void report(render::DynamicsFrame& out);
    void report_near(render::DynamicsFrame& out, unsigned hand);
    void add_planes(render::DynamicsFrame& out);
    void jam(const btCollisionObject& thing, const btVector3& to_body, const btManifoldPoint& contact);
};

// Applies the pushes of hand `hand`. A push that continues after the end of this step is divided. The part until the
// end of the step acts now, and the rest stays in the list.
void Dynamics::Impl::take_pushes(unsigned hand) {
    const double end_s = now_s() + kH;
    std::vector<render::HandPush>& list = world->pushes[hand];
    std::size_t kept = 0;
    for (render::HandPush push : list) {
        Body& body = world->bodies[push.body];
        double part = (end_s - push.time_s) / push.dt_s;
        part = part < kWhole         ? 0.0
               : part > 1.0 - kWhole ? 1.0
                                     // If a push ends with the step, rounding may leave a tiny remainder for the next
                                     // step. The remainder is ignored.
                                     : part;
        if (part > 0.0) {
            body.forced = true;
            body.hand_n[hand] += push.force_n * (part * push.dt_s / kH);
            body.hand_nm[hand] += push.moment_nm * (part * push.dt_s / kH);
            body.pushed_s[hand] = end_s;
            body.least_kg[hand] = push.least_kg;
            wake(push.body);
            if (push.most_speed_m_per_s > 0.0)
                rigid(push.body).setLinearVelocity(
                    bullet(at_most(ours(rigid(push.body).getLinearVelocity()), push.most_speed_m_per_s)));
        }
        if (part < 1.0) {
            push.dt_s *= 1.0 - part;
            push.time_s = std::max(push.time_s, end_s);
            push.most_speed_m_per_s = part > 0.0 ? 0.0 : push.most_speed_m_per_s;
            list[kept++] = push;
        }
    }
    list.resize(kept);
}

// Pulls a body to its target like a critically damped spring. The force also carries the body's weight, unless it would
// exceed `most_n`.
void Dynamics::Impl::apply_lead(const Lead& lead) {
    constexpr double kRate = 12.0;  // rate of the spring, 1/s
    Body& body = world->bodies[lead.body];
    const render::DynamicsBody& is = scene->bodies[lead.body];
    const btRigidBody& r = *body.rigid;
    body.forced = true;
    const Vec3 away = at_most(lead.to_m - ours(r.getWorldTransform().getOrigin()), 0.5);
    const Vec3 wanted_n = (away * (kRate * kRate) - ours(r.getLinearVelocity()) * (2.0 * kRate)) * is.nature.mass_kg -
                          scene->gravity_m_per_s2 * is.nature.mass_kg;
    body.lead_n = at_most(is.ball ? Vec3(wanted_n.x, wanted_n.y, std::min(wanted_n.z, 0.0)) : wanted_n, lead.most_n);
    if (!is.ball) {
        const PlacedFrame frame(ours(r.getWorldTransform()));
        const Vec3 turn = turn_between(ours(r.getWorldTransform()).rotation, lead.turn) * (kRate * kRate) -
                          ours(r.getAngularVelocity()) * (2.0 * kRate);
        body.lead_nm = at_most(frame.turned(frame.turned_back(turn) * is.inertia_kg_m2), lead.most_n * is.reach_m);
    }
    wake(lead.body);
}

// Pushes a body so that it reaches the requested speed within a few steps. The force also overcomes friction.
void Dynamics::Impl::apply_shove(Shove& shove) {
    constexpr double kWithin_s = 4.0 * kH;
    Body& body = world->bodies[shove.body];
    const render::BodyNature& nature = scene->bodies[shove.body].nature;
    const double speed = glm::length(shove.speed_m_per_s);
    const Vec3 along = shove.speed_m_per_s / speed;
    const double missing = speed - glm::dot(ours(body.rigid->getLinearVelocity()), along);
    const double rub_n = nature.friction_static * nature.mass_kg * glm::length(scene->gravity_m_per_s2);
    body.forced = true;
    if (missing > 0.0) body.shove_n += along * std::min(shove.most_n, nature.mass_kg * missing / kWithin_s + rub_n);
    wake(shove.body);
    shove.left_s -= kH;
}

// Gives a light body between two hands more inertia, but leaves its weight unchanged. At this step rate, two hands
// could not move such a light body stably.
void Dynamics::Impl::weigh(std::size_t i) {
    Body& body = world->bodies[i];
    const render::DynamicsBody& is = scene->bodies[i];
    const bool both = now_s() - body.pushed_s[0] < 0.1 && now_s() - body.pushed_s[1] < 0.1;
    const double kg = both ? std::max({is.nature.mass_kg, body.least_kg[0], body.least_kg[1]}) : is.nature.mass_kg;
    if (kg == body.inertial_kg) return;
    body.inertial_kg = kg;
    body.rigid->setMassProps(kg, bullet(is.inertia_kg_m2 * (kg / is.nature.mass_kg)));
    body.rigid->setGravity(bullet(scene->gravity_m_per_s2 * (is.nature.mass_kg / kg)));
    body.rigid->updateInertiaTensor();
}

void Dynamics::Impl::rub(std::size_t i) {
    Body& body = world->bodies[i];
    const render::BodyNature& nature = scene->bodies[i].nature;
    if (!body.rigid->isActive()) return;
    body.stick.go(body.rigid->getLinearVelocity().length(), kH);
    body.rigid->setFriction(nature.friction *
                            body.stick.factor(nature.friction > 0.0 ? nature.friction_static / nature.friction : 1.0));
}

void Dynamics::Impl::apply_forces() {
    for (Body& body : world->bodies)
        if (std::exchange(body.forced, false))
            body.hand_n = body.hand_nm = {Vec3(0.0), Vec3(0.0)}, body.lead_n = body.lead_nm = body.shove_n = Vec3(0.0);
    take_pushes(0);
    take_pushes(1);
    for (const Lead& lead : world->leads) apply_lead(lead);
    for (Shove& shove : world->shoves) apply_shove(shove);
    std::erase_if(world->shoves, [](const Shove& shove) { return shove.left_s <= 0.5 * kH; });
    for (std::size_t i = 0; i < world->bodies.size(); ++i) {
        Body& body = world->bodies[i];
        weigh(i);
        rub(i);
        body.speed_before = ours(body.rigid->getLinearVelocity());
        if (!body.rigid->isActive()) continue;
        Vec3 force = body.hand_n[0] + body.hand_n[1] + body.lead_n + body.shove_n;
        if (const auto& string = scene->bodies[i].nature.string)
            force += (string->at_m - ours(body.rigid->getWorldTransform().getOrigin())) * string->stiffness_n_per_m -
                     ours(body.rigid->getLinearVelocity()) * render::string_damping_ns_per_m(scene->bodies[i].nature);
        body.rigid->applyCentralForce(bullet(force));
        body.rigid->applyTorque(bullet(body.hand_nm[0] + body.hand_nm[1] + body.lead_nm));
        body.speed_before += (force / body.inertial_kg + ours(body.rigid->getGravity())) * kH;
    }
}

double Dynamics::Impl::gap_to_m(std::size_t body, const Vec3& local_m) const {
    const render::DynamicsBody& is = scene->bodies[body];
    const btTransform& at = world->bodies[body].rigid->getWorldTransform();
    const double far = glm::length(local_m - ours(at.getOrigin())) - is.reach_m;
    if (far > 1.0) return far;
    const Vec3 own = PlacedFrame(ours(at)).to_own(local_m);
    double least = 1e9;
    for (const render::DynamicsPiece& piece : is.pieces) least = std::min(least, render::gap_m(piece, own));
    return std::max(least, far);
}

void Dynamics::Impl::wake_near_hands() {
    for (const render::HandPlace& hand : hands) {
        if (!hand.present()) continue;
        for (std::size_t i = 0; i < world->bodies.size(); ++i) {
            if (rigid(i).isActive() || !(gap_to_m(i, local(hand.at_m)) < 3.0 * hand.radius_m)) continue;
            world->bodies[i].near_s = now_s();
            wake(i);
        }
    }
}

void Dynamics::Impl::drive_things() {
    for (Driven& thing : world->driven) {
        btRigidBody& r = *thing.rigid;
        const int quiet = btCollisionObject::CF_NO_CONTACT_RESPONSE;
        r.setCollisionFlags(thing.present ? r.getCollisionFlags() & ~quiet : r.getCollisionFlags() | quiet);
        const Placement now = ours(r.getWorldTransform());
        const bool moves = glm::length(now.position_m - thing.to.position_m) > 1e-9 ||
                           glm::length(turn_between(now.rotation, thing.to.rotation)) > 1e-9;
        thing.blocked = moves && thing.jammed > 0;
        thing.jammed = std::max(0, thing.jammed - 1);
        if (glm::dot(thing.to.position_m - now.position_m, thing.pushed) < 0.0) thing.blocked = false;
        if (!moves || thing.blocked) {
            r.setInterpolationWorldTransform(r.getWorldTransform());
            r.setLinearVelocity({0, 0, 0});
            r.setAngularVelocity({0, 0, 0});
            if (!thing.blocked) r.forceActivationState(ISLAND_SLEEPING);
            thing.catches_up = thing.catches_up || thing.blocked;
            thing.way_m = 0.0;
            continue;
        }
        const double reach = scene->driven[static_cast<std::size_t>(r.getUserIndex())].reach_m;
        const double way = farthest_travel_m(now, thing.to, reach);
        Placement next = thing.to;
        if (thing.catches_up && way > kCatchUp_m) next = between(now, thing.to, kCatchUp_m / way);
        else thing.catches_up = false;
        thing.way_m = std::min(way, farthest_travel_m(now, next, reach));
        const bool jump = glm::length(now.position_m - next.position_m) > 0.5 ||
                          glm::length(turn_between(now.rotation, next.rotation)) > 1.0;
        r.setWorldTransform(bullet(next));
        if (jump) r.setInterpolationWorldTransform(bullet(next));
        r.forceActivationState(ACTIVE_TAG);
        world->world.updateSingleAabb(&r);
    }
}

// Limits the number of moving bodies to kMostAwake. If more move, it holds some of them still until there is room
// again. Bodies that a person moves or is about to touch continue first, the others in the order of the scene.
void Dynamics::Impl::limit_awake(render::DynamicsFrame& out) {
    std::size_t active = 0;
    for (const Body& body : world->bodies) active += body.rigid->isActive();
    const auto wanted = [this](std::size_t i) {
        const Body& body = world->bodies[i];
        return now_s() - std::max({body.pushed_s[0], body.pushed_s[1], body.near_s}) < 0.5 ||
               std::any_of(world->leads.begin(), world->leads.end(),
                           [&](const Lead& lead) { return lead.body == i; }) ||
               std::any_of(world->shoves.begin(), world->shoves.end(),
                           [&](const Shove& shove) { return shove.body == i; });
    };
    const auto go_on = [&](Body& body) {
        body.waiting = false;
        body.rigid->forceActivationState(ACTIVE_TAG);
        body.rigid->setDeactivationTime(0.0);
        body.rigid->setLinearVelocity(bullet(body.kept_m_per_s));
        body.rigid->setAngularVelocity(bullet(body.kept_rad_per_s));
        ++active;
    };
    for (std::size_t i = 0; i < world->bodies.size(); ++i)
        if (world->bodies[i].waiting && wanted(i)) go_on(world->bodies[i]);
    // Bullet wakes every body near a moving one. Of the bodies that it woke, those at rest are put to sleep again at
    // once. If they waited like moving bodies, they would wake each other whenever it was their turn, and none would
    // ever sleep.
    for (std::size_t i = world->bodies.size(); i-- > 0 && active > kMostAwake;) {
        btRigidBody& r = rigid(i);
        if (r.getActivationState() != WANTS_DEACTIVATION || wanted(i)) continue;
        // A resting body that is woken for single steps again and again would creep: contacts lift it by amounts that
        // gravity has no time to reverse. So it returns to the pose at which it fell asleep.
        constexpr double kCreep_m = 2e-4;
        if (const auto& slept_at = world->bodies[i].sleeps_at;
            slept_at && r.getWorldTransform().getOrigin().distance2(slept_at->getOrigin()) < kCreep_m * kCreep_m) {
            r.setWorldTransform(*slept_at);
            r.setInterpolationWorldTransform(*slept_at);
        }
        r.setLinearVelocity({0, 0, 0});
        r.setAngularVelocity({0, 0, 0});
        r.forceActivationState(ISLAND_SLEEPING);
        --active;
    }
    for (std::size_t i = world->bodies.size(); i-- > 0 && active > kMostAwake;) {
        Body& body = world->bodies[i];
        if (!body.rigid->isActive() || wanted(i)) continue;
        body.kept_m_per_s = ours(body.rigid->getLinearVelocity());
        body.kept_rad_per_s = ours(body.rigid->getAngularVelocity());
        body.rigid->setLinearVelocity({0, 0, 0});
        body.rigid->setAngularVelocity({0, 0, 0});
        body.rigid->forceActivationState(DISABLE_SIMULATION);
        body.waiting = true;
        --active;
    }
    for (std::size_t i = 0; i < world->bodies.size() && active < kMostAwake; ++i)
        if (world->bodies[i].waiting) go_on(world->bodies[i]);
    for (Body& body : world->bodies)
        if (body.rigid->getActivationState() != ISLAND_SLEEPING) body.sleeps_at.reset();
        else if (!body.sleeps_at) body.sleeps_at = body.rigid->getWorldTransform();
    out.awake = static_cast<std::uint32_t>(active);
    out.waiting = static_cast<std::uint32_t>(
        std::count_if(world->bodies.begin(), world->bodies.end(), [](const Body& body) { return body.waiting; }));
}

void Dynamics::Impl::put_back(std::size_t i, std::vector<render::BodyEvent>& events) {
    Body& body = world->bodies[i];
    btRigidBody& r = *body.rigid;
    if (!r.isActive()) return;  // the body did not move
    const Vec3 at = ours(r.getWorldTransform().getOrigin());
    const Vec3 v = ours(r.getLinearVelocity()), w = ours(r.getAngularVelocity());
    const bool finite = is_finite(at) && is_finite(v) && is_finite(w);
    if (finite && glm::length(v) > kMostSpeed_m_per_s) r.setLinearVelocity(bullet(at_most(v, kMostSpeed_m_per_s)));
    if (finite && glm::length(w) > kMostTurn_rad_per_s) r.setAngularVelocity(bullet(at_most(w, kMostTurn_rad_per_s)));
    const Aabb all = grown(scene->bounds_m, kOutside_m + scene->bodies[i].reach_m);
    if (finite && overlap(all, {at, at})) return;
    const btTransform start = bullet(scene->bodies[i].start);
    r.setWorldTransform(start);
    r.setInterpolationWorldTransform(start);
    r.setLinearVelocity({0, 0, 0});
    r.setAngularVelocity({0, 0, 0});
    r.setInterpolationLinearVelocity({0, 0, 0});
    r.setInterpolationAngularVelocity({0, 0, 0});
    r.clearForces();
    world->broadphase.getOverlappingPairCache()->cleanProxyFromPairs(r.getBroadphaseHandle(), &world->dispatcher);
    world->world.updateSingleAabb(&r);
    body.speed_before = Vec3(0.0);
    body.stick = {};
    events.push_back({render::BodyEvent::Kind::PutBack, static_cast<std::uint32_t>(i), now_s(),
                      scene->origin_m + scene->bodies[i].start.position_m});
}

// Jams a driven thing if a body overlaps it too deeply or resists it too hard. The force limit applies only to bodies
// at its side, for example in front of a door. A body that rests on a lift may have any weight.
void Dynamics::Impl::jam(const btCollisionObject& thing, const btVector3& to_body, const btManifoldPoint& contact) {
    Driven& driven = world->driven[static_cast<std::size_t>(thing.getUserIndex())];
    const bool deep = contact.getDistance() < -kJammed_m - driven.way_m,
               hard = std::abs(to_body.z()) < 0.7 && contact.getAppliedImpulse() > kMostDrive_n * kH;
    if (!deep && !hard) return;
    driven.jammed = kJammedSteps;
    driven.pushed = ours(to_body);
}

// Finds the strongest contact of each body in this step, and notices jammed bodies.
void Dynamics::Impl::note_touched() {
    const auto silent = [this](const btCollisionObject& object) {
        return kind_of(object) == kBody && is_silent(static_cast<std::size_t>(object.getUserIndex()));
    };
    const auto still = [&](const btCollisionObject& object) { return !object.isActive() && kind_of(object) != kBody; };
    for (int m = 0; m < world->dispatcher.getNumManifolds(); ++m) {
        const btPersistentManifold& manifold = *world->dispatcher.getManifoldByIndexInternal(m);
        const btCollisionObject &one = *manifold.getBody0(), &two = *manifold.getBody1();
        if ((silent(one) || still(one)) && (silent(two) || still(two))) continue;
        for (int k = 0; k < manifold.getNumContacts(); ++k) {
            const btManifoldPoint& p = manifold.getContactPoint(k);
            if (!(p.getDistance() < 1e-3) && !(p.getAppliedImpulse() > 0.0)) continue;
            for (int side = 0; side < 2; ++side) {
                const btCollisionObject &mine = side ? two : one, &other = side ? one : two;
                if (kind_of(other) == kDriven && kind_of(mine) == kBody)
                    jam(other, side ? -p.m_normalWorldOnB : p.m_normalWorldOnB, p);
                if (kind_of(mine) != kBody || silent(mine)) continue;
                Touched& t = world->touched[static_cast<std::size_t>(mine.getUserIndex())];
                t.any = true;
                if (p.getAppliedImpulse() < t.impulse) continue;
                t.impulse = p.getAppliedImpulse();
                t.at = side ? p.getPositionWorldOnB() : p.getPositionWorldOnA();
                t.own = t.at - mine.getWorldTransform().getOrigin();
                t.body = kind_of(other) == kBody ? static_cast<std::uint32_t>(other.getUserIndex()) : render::kNoBody;
                t.feature = feature_of(other, side ? p.m_index0 : p.m_index1);
            }
        }
    }
}

// Returns the feature of a contact. `child` is the index of the part of the building or of its sheets; negative: no
// part.
FeatureId Dynamics::Impl::feature_of(const btCollisionObject& object, int child) const {
    const auto part = static_cast<std::size_t>(child), which = static_cast<std::size_t>(object.getUserIndex());
    switch (kind_of(object)) {
        case kBuilding:
            return child >= 0 && part < scene->building.size() ? scene->building[part].feature : kNoFeature;
        case kSheets:
            return child >= 0 && part < scene->sheet_features.size() ? scene->sheet_features[part] : kNoFeature;
        case kDriven:
            return scene->driven[which].feature;
        case kBody:
            return scene->bodies[which].feature;
        default:
            return kNoFeature;
    }
}

void Dynamics::Impl::hear(std::vector<render::BodyEvent>& events) {
    note_touched();
    for (std::size_t i = 0; i < world->bodies.size(); ++i)
        if (!is_silent(i)) hear_body(i, std::exchange(world->touched[i], {}), events);
}

// Detects the sound events of one body. An impact is a change of speed that no force explains. Rolling, sliding,
// falling and resting follow from the contacts and the speed.
void Dynamics::Impl::hear_body(std::size_t i, const Touched& t, std::vector<render::BodyEvent>& events) {
    Body& body = world->bodies[i];
    const Vec3 v = ours(body.rigid->getLinearVelocity()), w = ours(body.rigid->getAngularVelocity());
    render::BodyEvent event;
    event.body = static_cast<std::uint32_t>(i);
    event.time_s = now_s();
    event.at_m = scene->origin_m + ours(t.any ? t.at : body.rigid->getWorldTransform().getOrigin());
    event.other = t.feature;
    event.other_body = t.body;
    const auto say = [&](render::BodyEvent::Kind kind, double speed) {
        event.kind = kind;
        event.speed_m_per_s = speed;
        events.push_back(event);
    };
    if (!body.rigid->isActive()) {
        if (!body.rested && !body.waiting) say(render::BodyEvent::Kind::Rests, 0.0);
        body.rested = body.rested || !body.waiting;
        return;
    }
    const double speed = glm::length(v), jolt = glm::length(v - body.speed_before);
    if (speed > 0.02) body.rested = false;
    if (jolt > kHit_m_per_s && t.any && event.time_s - body.hit_s > kHitAgain_s) {
        body.hit_s = event.time_s;
        event.impulse_ns = jolt * body.inertial_kg;
        say(render::BodyEvent::Kind::Hit, jolt);
        event.impulse_ns = 0.0;
    }
    body.airborne = t.any ? 0 : body.airborne + 1;
    if (t.any) body.falling = false;
    else if (body.airborne >= kFallingSteps && !body.falling && glm::dot(v, scene->gravity_m_per_s2) > 0.0) {
        body.falling = true;
        say(render::BodyEvent::Kind::Falls, speed);
    }
    if (!t.any || speed < 0.02) body.moving = 0;
    else if (++body.moving % kMovingSteps == 0) {
        const double slips = glm::length(v + glm::cross(w, ours(t.own)));
        say(slips < 0.5 * speed ? render::BodyEvent::Kind::Rolls : render::BodyEvent::Kind::Slides, speed);
    }
}

void Dynamics::Impl::report_near(render::DynamicsFrame& out, unsigned hand) {
    out.near_count[hand] = 0;
    if (!hands[hand].present()) return;
    auto& order = world->order;
    for (std::size_t i = 0; i < world->bodies.size(); ++i) {
        // Bodies that this hand has just pushed come first.
        const bool mine = now_s() - world->bodies[i].pushed_s[hand] < 0.5;
        order[i] = {gap_to_m(i, local(hands[hand].at_m)) - (mine ? 1e6 : 0.0), static_cast<std::uint32_t>(i)};
    }
    const std::size_t count = std::min(render::DynamicsFrame::kNear, world->bodies.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
                      order.begin() + static_cast<std::ptrdiff_t>(world->bodies.size()));
    for (std::size_t k = 0; k < count; ++k) {
        const std::uint32_t i = order[k].second;
        const Body& body = world->bodies[i];
        const render::DynamicsBody& is = scene->bodies[i];
        render::RigidBodyState& reported = out.near[hand][k];
        reported = {};
        reported.body = i;
        reported.time_s = out.time_s;
        reported.at = ours(body.rigid->getWorldTransform());
        reported.at.position_m += scene->origin_m;
        reported.speed_m_per_s = ours(body.rigid->getLinearVelocity());
        reported.turn_rad_per_s = ours(body.rigid->getAngularVelocity());
        reported.mass_kg = body.inertial_kg;
        reported.inertia_kg_m2 = is.inertia_kg_m2 * (body.inertial_kg / is.nature.mass_kg);
        reported.gravity_m_per_s2 = scene->gravity_m_per_s2 * (is.nature.mass_kg / body.inertial_kg);
        reported.others_n = body.hand_n[1 - hand] + body.lead_n + body.shove_n;
        reported.others_nm = body.hand_nm[1 - hand] + body.lead_nm;
        if (is.nature.string) {
            reported.string_at_m = is.nature.string->at_m + scene->origin_m;
            reported.string_n_per_m = is.nature.string->stiffness_n_per_m;
            reported.string_ns_per_m = render::string_damping_ns_per_m(is.nature);
        }
        reported.sticks = is.nature.friction > 0.0 ? is.nature.friction_static / is.nature.friction : 1.0;
        reported.rolling_m = is.nature.rolling * is.half_width_m;
        reported.gap_m = order[k].first < -1e5 ? order[k].first + 1e6 : order[k].first;
    }
    out.near_count[hand] = static_cast<std::uint8_t>(count);
}

// Adds the contacts of the reported bodies as planes. If there are too many, the deepest stay.
void Dynamics::Impl::add_planes(render::DynamicsFrame& out) {
    const auto gap = [](const render::RigidBodyState& reported, const render::ContactPlane& plane) {
        return glm::dot(plane.normal, PlacedFrame(reported.at).to_world(plane.own_m)) - plane.offset_m;
    };
    for (int m = 0; m < world->dispatcher.getNumManifolds(); ++m) {
        const btPersistentManifold& manifold = *world->dispatcher.getManifoldByIndexInternal(m);
        for (int side = 0; side < 2; ++side) {
            const btCollisionObject &mine = side ? *manifold.getBody1() : *manifold.getBody0(),
                                    &other = side ? *manifold.getBody0() : *manifold.getBody1();
            if (kind_of(mine) != kBody || !other.hasContactResponse()) continue;
            const auto index = static_cast<std::uint32_t>(mine.getUserIndex());
            const render::DynamicsBody& is = scene->bodies[index];
            for (unsigned hand = 0; hand < 2; ++hand)
                for (std::size_t w = 0; w < out.near_count[hand]; ++w) {
                    render::RigidBodyState& reported = out.near[hand][w];
                    if (reported.body != index) continue;
                    for (int k = 0; k < manifold.getNumContacts(); ++k) {
                        const btManifoldPoint& p = manifold.getContactPoint(k);
                        const btVector3 there = other.getWorldTransform() * (side ? p.m_localPointA : p.m_localPointB);
                        render::ContactPlane plane;
                        plane.normal = ours(p.m_normalWorldOnB) * (side ? -1.0 : 1.0);
                        plane.own_m = ours(side ? p.m_localPointB : p.m_localPointA);
                        plane.offset_m = glm::dot(plane.normal, ours(there) + scene->origin_m);
                        plane.friction = is.nature.friction;
                        if (kind_of(other) == kBody)
                            plane.friction = std::sqrt(
                                is.nature.friction *
                                scene->bodies[static_cast<std::size_t>(other.getUserIndex())].nature.friction);
                        if (const btRigidBody* moving = btRigidBody::upcast(&other))
                            plane.speed_m_per_s =
                                ours(moving->getVelocityInLocalPoint(there - moving->getWorldTransform().getOrigin()));
                        plane.round = is.ball;
                        plane.radius_m = is.ball ? is.half_width_m : 0.0;
                        if (reported.count < render::RigidBodyState::kMostPlanes) {
                            reported.planes[reported.count++] = plane;
                            continue;
                        }
                        auto shallow =
                            std::max_element(reported.planes.begin(), reported.planes.end(),
                                             [&](const render::ContactPlane& a, const render::ContactPlane& b) {
                                                 return gap(reported, a) < gap(reported, b);
                                             });
                        if (gap(reported, plane) < gap(reported, *shallow)) *shallow = plane;
                    }
                }
        }
    }
}

void Dynamics::Impl::report(render::DynamicsFrame& out) {
    out.number = steps;
    out.game = game;
    out.time_s = now_s();
    things.resize(world->bodies.size());
    out.moved.clear();
    for (std::size_t i = 0; i < world->bodies.size(); ++i) {
        Body& body = world->bodies[i];
        const bool active = body.rigid->isActive();
        if (body.reported && !active) continue;
        body.reported = !active;
        Placement thing = render::thing_of(scene->bodies[i], ours(body.rigid->getWorldTransform()));
        thing.position_m += scene->origin_m;
        if (std::exchange(things[i], thing) == thing) continue;
        out.moved.push_back(static_cast<std::uint32_t>(i));
    }
    out.things = things;
    report_near(out, 0);
    report_near(out, 1);
    add_planes(out);
    out.blocked = render::kNoBody;
    for (std::size_t i = world->driven.size(); i-- > 0;)
        if (world->driven[i].blocked) out.blocked = static_cast<std::uint32_t>(i);
}

Dynamics::Dynamics(std::shared_ptr<const render::DynamicsScene> scene) : impl_(std::make_unique<Impl>()) {
    contract_pre(scene != nullptr);
    set_up_bullet();
    impl_->scene = std::move(scene);
    impl_->world = std::make_unique<World>(*impl_->scene);
}

Dynamics::~Dynamics() = default;

void Dynamics::push(unsigned hand, const render::HandPush& push) {
    contract_pre(hand < 2);
    if (push.game != impl_->game || push.body >= impl_->scene->bodies.size()) return;
    if (!(push.dt_s > 0.0) || !std::isfinite(push.dt_s) || !std::isfinite(push.time_s) || !is_finite(push.force_n) ||
        !is_finite(push.moment_nm))
        return;
    impl_->world->pushes[hand].push_back(push);
}

void Dynamics::place_hand(unsigned hand, const render::HandPlace& place) {
    contract_pre(hand < 2);
    impl_->hands[hand] = place;
    if (!is_finite(place.at_m) || !std::isfinite(place.radius_m)) impl_->hands[hand] = {};
}

void Dynamics::drive(std::uint32_t thing, const Placement& at, bool present) {
    contract_pre(thing < impl_->scene->driven.size());
    if (!is_finite(at.position_m)) return;
    Driven& driven = impl_->world->driven[thing];
    driven.to = {impl_->local(at.position_m), normalized(at.rotation), 1.0};
    driven.present = present;
}

bool World::walker_pressed() {
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        if (manifold.getBody0() != walker.get() && manifold.getBody1() != walker.get()) continue;
        for (int k = 0; k < manifold.getNumContacts(); ++k)
            if (manifold.getContactPoint(k).getDistance() < -kPressed_m) return true;
    }
    return false;
}

void Dynamics::walker(const Vec3& feet_m, double radius_m, double height_m) {
    World& w = *impl_->world;
    const bool wanted = is_finite(feet_m) && height_m > 0.0 && radius_m > 0.0;
    const double length = std::max(0.0, height_m - 2.0 * radius_m);
    if (w.walker &&
        (!wanted || w.walker_shape->getRadius() != radius_m || 2.0 * w.walker_shape->getHalfHeight() != length)) {
        w.world.removeRigidBody(w.walker.get());
        w.walker.reset();
    }
    if (!wanted) return;
    const Placement at{impl_->local(feet_m) + Vec3(0, 0, radius_m + 0.5 * length), {}, 1.0};
    if (!w.walker) {
        w.walker_shape = std::make_unique<btCapsuleShapeZ>(radius_m, length);
        w.kinematic(w.walker, w.walker_shape.get(), *impl_->scene, kWalker, 0, at);
        w.walker->setFriction(0.5);
        w.walker->setRestitution(0.0);
        return;
    }
    const double way = glm::length(at.position_m - ours(w.walker->getWorldTransform().getOrigin()));
    w.walker->setWorldTransform(bullet(at));
    // The walker has a velocity only while a body overlaps it, so that it carries the body along. Without a velocity,
    // the walker's capsule stops just short of a body. With a velocity all the time, it would throw even the heaviest
    // body.
    if (way > 0.5 || !w.walker_pressed()) w.walker->setInterpolationWorldTransform(bullet(at));
    w.walker->forceActivationState(way > 1e-9 ? ACTIVE_TAG : ISLAND_SLEEPING);
    w.world.updateSingleAabb(w.walker.get());
}

void Dynamics::lead(std::uint32_t body, const Vec3& to_m, double most_n, const Rotation& turn) {
    std::vector<Lead>& leads = impl_->world->leads;
    if (body >= impl_->scene->bodies.size() || !(most_n > 0.0) || !is_finite(to_m)) {
        leads.clear();
        return;
    }
    leads.assign(1, {body, impl_->local(to_m), most_n, normalized(turn)});
}

void Dynamics::shove(std::uint32_t body, const Vec3& speed_m_per_s, double most_n, double for_s) {
    std::vector<Shove>& shoves = impl_->world->shoves;
    std::erase_if(shoves, [&](const Shove& shove) { return shove.body == body; });
    const Vec3 level(speed_m_per_s.x, speed_m_per_s.y, 0.0);
    if (body >= impl_->scene->bodies.size() || !is_finite(speed_m_per_s) || !(most_n > 0.0) || !(for_s > 0.0) ||
        !(glm::length(level) > 1e-6))
        return;
    shoves.push_back({body, level, most_n, for_s});
}

void Dynamics::step(render::DynamicsFrame& out, std::vector<render::BodyEvent>& events) {
    Impl& s = *impl_;
    s.wake_near_hands();
    s.drive_things();
    s.apply_forces();
    s.world->world.stepSimulation(kStep_s, 0, kStep_s);
    ++s.steps;
    s.hear(events);
    for (std::size_t i = 0; i < s.world->bodies.size(); ++i) s.put_back(i, events);
    s.limit_awake(out);
    s.report(out);
}

void Dynamics::restart() {
    impl_->world.reset();
    impl_->world = std::make_unique<World>(*impl_->scene);
    ++impl_->game;
}

double Dynamics::time_s() const { return impl_->now_s(); }
void Dynamics::skip(double seconds) {
    contract_pre(seconds >= 0.0 && std::isfinite(seconds));
    impl_->begin_s += seconds;
    for (std::vector<render::HandPush>& pushes : impl_->world->pushes)
        std::erase_if(pushes, [&](const render::HandPush& push) { return push.time_s < impl_->now_s(); });
}
const render::DynamicsScene& Dynamics::scene() const { return *impl_->scene; }
Placement Dynamics::middle(std::uint32_t body) const {
    contract_pre(body < impl_->scene->bodies.size());
    Placement at = ours(impl_->rigid(body).getWorldTransform());
    at.position_m += impl_->scene->origin_m;
    return at;
}
Vec3 Dynamics::speed_m_per_s(std::uint32_t body) const {
    contract_pre(body < impl_->scene->bodies.size());
    return ours(impl_->rigid(body).getLinearVelocity());
}
bool Dynamics::awake(std::uint32_t body) const {
    contract_pre(body < impl_->scene->bodies.size());
    return impl_->rigid(body).isActive();
}
bool Dynamics::blocked(std::uint32_t thing) const {
    contract_pre(thing < impl_->scene->driven.size());
    return impl_->world->driven[thing].blocked;
}

}  // namespace handrail::dynamics
