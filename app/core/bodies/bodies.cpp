#include "app/core/bodies/bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/core/bodies/body_words.h"
#include "app/core/world/body_heights.h"
#include "app/core/world/mover_meeting.h"
#include "app/core/world/questions.h"
#include "worlds/base/contract.h"
#include "worlds/base/human_measures.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kMoved_m = 1e-4;       // movements smaller than this are the jitter of a resting body
constexpr double kTurned = 1e-4;        // radians; turns smaller than this are the jitter of a resting body
constexpr double kRestsAfter_s = 0.2;   // a body is at rest once it has not moved for this long
constexpr double kBeforeFeet_m = 0.06;  // the walker pushes a body that is at most this far in front
// Duration of one push order; longer than a frame, so that each push lasts until the next.
constexpr double kPushFor_s = 0.05;
constexpr double kGivesWayWithin_s = 0.5;  // a pushed body that has not moved after this time blocks the walker
constexpr double kPushedOn_m = 0.01;
// A body whose top is lower than this above the feet is underfoot and does not block the walker.
constexpr double kUnderFeet_m = 0.01;
constexpr double kOff_m_per_s = 0.3;
// If a body slows the walker below this share of the intended speed, the block is announced.
constexpr double kHeldBack = 0.3;
// Cosine of the largest angle from straight ahead at which the walker can take hold of a thing.
constexpr double kAhead = 0.25;
// The walker starts a new attempt to push if the last push was longer ago than this.
constexpr double kStrained_s = 2.0;
// Cosine. A hit is underneath a body if its direction from the body's middle is within this angle of straight down.
constexpr double kUnder = 0.8;
// For this long after a hit, the announcement that a held or pushed thing stopped names the thing that was hit.
constexpr double kHeard_s = 3.0;

bool differs(const Placement& a, const Placement& b) {
    const double turned = 1.0 - std::abs(a.rotation.w * b.rotation.w + a.rotation.x * b.rotation.x +
                                         a.rotation.y * b.rotation.y + a.rotation.z * b.rotation.z);
    return glm::length(a.position_m - b.position_m) > kMoved_m || 8.0 * turned > kTurned * kTurned;
}

}  // namespace

void Bodies::enter_world(std::shared_ptr<const render::DynamicsScene> scene, double now_s) {
    engine_.reset();
    stepped_ = nullptr;
    read_ = {};
    hand_engines_ = {};
    grip_.enter_world();
    hand_grip_.enter_world();
    sounds_.enter_world(scene ? scene->bodies.size() : 0, now_s);
    scene_ = std::move(scene);
    driven_.clear();
    pushed_ = in_the_way_ = render::kNoBody;
    hit_ = kNoFeature;
    hit_s_ = moved_s_ = pushed_s_ = -1e9;
    moving_ = rested_ = false;
    if (!scene_) return;
    dynamics::DynamicsLoop* own = nullptr;
    if (how_.played) {
        engine_ = how_.played(scene_, now_s);
    } else {
        auto loop = std::make_unique<dynamics::DynamicsLoop>(scene_, now_s, how_.recording);
        own = loop.get();
        engine_ = std::move(loop);
    }
    read_.engine = engine_->hand(0)->engine;
    for (unsigned which = 0; which < hand_engines_.size(); ++which)
        hand_engines_[which] =
            std::make_shared<servo::HandBodyServo>(scene_, engine_->hand(which), which, world_.scene->placed.size());
    walker_m_ = Vec3(std::numeric_limits<double>::infinity());
    update_engine();
    if (own && how_.clock) own->start(*how_.clock);
    else stepped_ = own;
}

std::optional<double> Bodies::mass_kg(FeatureId feature) const {
    const std::uint32_t body = body_of(feature);
    return body == render::kNoBody ? std::nullopt : std::optional(scene_->bodies[body].nature.mass_kg);
}

Placement Bodies::middle(std::uint32_t body) const {
    const render::DynamicsBody& is = scene_->bodies[body];
    return render::middle_of(is, world_.things.at(is.haptic));
}

// Returns true if the line of sight is free from the eyes to the body's nearest point or to its middle. The body itself
// is not an obstacle.
bool Bodies::in_sight(std::uint32_t body, const Aabb& box_m) const {
    const Vec3 eye = context_.avatar.feet_m() + Vec3(0.0, 0.0, kLookHeight_m);
    const auto seen = [&](const Vec3& at_m) {
        const TraceHit hit = world_.solids->trace(eye, at_m, {}, true);
        return !hit.hit || hit.feature == scene_->bodies[body].feature;
    };
    return seen(glm::clamp(eye, box_m.min_m, box_m.max_m)) || seen(box_m.centre_m());
}

// Returns the body that the hand touches. Otherwise returns the body straight ahead of the walker, or else the nearest
// body in front.
std::uint32_t Bodies::in_reach() const {
    if (context_.hands.tool.touches())
        if (const std::uint32_t touched = body_of(context_.hands.tool.touched()); touched != render::kNoBody)
            return touched;
    const Vec3 feet = context_.avatar.feet_m();
    const double top_m = context_.avatar.walker->size().height_m;
    if (const auto seen = look(*world_.solids, feet, kLookHeight_m, context_.avatar.heading_rad, kArmsReach_m))
        if (const std::uint32_t ahead = body_of(seen->feature);
            ahead != render::kNoBody || mover_of(world_, seen->feature) >= 0)
            return ahead;
    const Vec3 forward = forward_of_heading(context_.avatar.heading_rad);
    std::uint32_t nearest = render::kNoBody;
    double nearest_m = kArmsReach_m;
    for (std::uint32_t i = 0; i < scene_->bodies.size(); ++i) {
        const Aabb& box = world_.solids->box_of_placed(scene_->bodies[i].haptic);
        if (box.empty() || box.max_m.z < feet.z - 0.3 || box.min_m.z > feet.z + top_m) continue;
        Vec3 way = glm::clamp(feet, box.min_m, box.max_m) - feet;
        way.z = 0.0;
        const double far_m = glm::length(way);
        if (far_m >= nearest_m || (far_m > 0.0 && glm::dot(way, forward) < kAhead * far_m) || !in_sight(i, box))
            continue;
        nearest = i;
        nearest_m = far_m;
    }
    return nearest;
}

bool Bodies::act(Command command, double now_s, int times) {
    if (command == Command::PutBack) {
        put_back(now_s);
        return true;
    }
    if (!engine_) return false;
    if (!grip_.holds() && hand_grip_.act(command, *scene_, now_s)) return true;
    if (grip_.holds()) return grip_.act(command, *engine_, *scene_, middle(grip_.held()), now_s, times);
    if (command != Command::Use) return false;
    const std::uint32_t body = in_reach();
    if (body == render::kNoBody) return false;
    grip_.take(*engine_, *scene_, body, middle(body), now_s);
    return true;
}

void Bodies::put_back(double now_s) {
    if (!engine_) return context_.answer(phrase("bodies.none_here"), now_s);
    restart();
    context_.answer(phrase("bodies.put_back"), now_s);
}

void Bodies::restart() {
    if (!engine_) return;
    grip_.let_go();
    engine_->order({.kind = dynamics::BodyEngine::Order::Kind::LetGo});
    engine_->order({.kind = dynamics::BodyEngine::Order::Kind::Restart});
    // The restarted engine does not know where the walker is, so the walker's position must be sent again.
    walker_m_ = Vec3(std::numeric_limits<double>::infinity());
    driven_.clear();
}

// Sends the positions of doors and of the walker to the engine.
void Bodies::update_engine() {
    std::vector<Placement> now;
    for (const render::DrivenThing& thing : scene_->driven) now.push_back(world_.things.at(thing.haptic));
    if (now != driven_) {
        auto poses = std::make_shared<std::vector<render::BodyPose>>();
        for (const Placement& at : now) poses->push_back({at, true});
        engine_->drive(poses);
        driven_ = std::move(now);
    }
    if (!context_.avatar.walker) return;
    // A small ball could roll under the round end of the walker's capsule, below the soles. To prevent this, the
    // capsule reaches into the floor. While the walker is in the air or stands on a body, the capsule ends at the
    // soles.
    const bool lifted =
        !context_.avatar.walker->state().on_ground || body_of(context_.avatar.ground) != render::kNoBody;
    const Vec3 feet = context_.avatar.feet_m();
    if (feet == walker_m_ && lifted == walker_lifted_) return;
    const WalkerSize& size = context_.avatar.walker->size();
    const double into_m = lifted ? 0.0 : size.radius_m;
    dynamics::BodyEngine::Order order;
    order.kind = dynamics::BodyEngine::Order::Kind::Walker;
    order.at_m = feet - Vec3(0.0, 0.0, into_m);
    order.radius_m = size.radius_m;
    order.height_m = size.height_m + into_m;
    if (!engine_->order(order)) return;
    walker_m_ = feet;
    walker_lifted_ = lifted;
}

void Bodies::step_engine(double now_s) {
    contract_pre(std::isfinite(now_s));
    if (stepped_) stepped_->step_until(now_s);
}

void Bodies::tick(double now_s) {
    contract_pre(std::isfinite(now_s));
    if (!engine_) return;
    update_engine();
    step_engine(now_s);
    hand_grip_.tick(*scene_, now_s);
    hear(now_s);
    if (engine_->newer_frame_for_app()) {
        read_.frame = engine_->frame_for_app().number;
        take_places(now_s);
    }
    if (moving_ && now_s - moved_s_ > kRestsAfter_s) {
        moving_ = false;
        rested_ = true;
    }
    sounds_.tick(now_s);
    if (grip_.holds())
        grip_.tick(*engine_, *scene_, middle(grip_.held()), now_s - hit_s_ < kHeard_s ? hit_ : kNoFeature, now_s);
}

std::vector<MovedThing> Bodies::moved() const {
    std::vector<MovedThing> moved;
    if (!moving_) return moved;
    for (const render::DynamicsBody& body : scene_->bodies)
        moved.push_back({body.haptic, world_.things.at(body.haptic)});
    return moved;
}

void Bodies::take_places(double now_s) {
    const render::DynamicsFrame& frame = engine_->frame_for_app();
    for (std::size_t i = 0; i < scene_->bodies.size(); ++i) {
        const std::uint32_t thing = scene_->bodies[i].haptic;
        if (!differs(frame.things[i], world_.things.at(thing))) continue;
        Placement at = frame.things[i];
        at.scale = world_.things.at(thing).scale;
        world_.things.put(thing, at);
        moved_s_ = now_s;
        moving_ = true;
    }
}

void Bodies::hear(double now_s) {
    render::BodyEvent event;
    while (engine_->take_event(event)) {
        ++read_.events;
        sounds_.hear(event, *scene_, now_s);
        const bool mine = event.body == grip_.held() || (event.body == pushed_ && now_s - pushed_s_ < kHeard_s);
        if (event.kind == render::BodyEvent::Kind::PutBack)
            context_.say(phrase("bodies.fell_out", {{"name", body_name(context_, scene_->bodies[event.body].feature)}}),
                         cues::SpeechClass::Answer, now_s);
        if (event.kind != render::BodyEvent::Kind::Hit) continue;
        const FeatureId met =
            event.other_body != render::kNoBody ? scene_->bodies[event.other_body].feature : event.other;
        if (on_hit) on_hit(scene_->bodies[event.body].feature, met, now_s);
        if (!mine) continue;
        // A hit underneath the body does not stop the body, so it explains nothing.
        const Vec3 off = event.at_m - middle(event.body).position_m;
        if (off.z < -kUnder * glm::length(off)) continue;
        hit_ = met;
        hit_s_ = now_s;
    }
}

void Bodies::shove(std::uint32_t body, const Vec3& speed_m_per_s) {
    dynamics::BodyEngine::Order order;
    order.kind = dynamics::BodyEngine::Order::Kind::Shove;
    order.body = body;
    order.speed_m_per_s = speed_m_per_s;
    order.most_n = FreeBody::kWalkersPush_n;
    order.for_s = kPushFor_s;
    engine_->order(order);
}

// Removes the part of `intended_m_per_s` that leads into a body, and pushes that body away. The engine lets bodies
// overlap a little. The walker can pass through such an overlap, so nobody stays trapped. Returns the body that the
// walker meets, or kNoBody.
std::uint32_t Bodies::keep_apart(Vec3& intended_m_per_s) {
    std::uint32_t met = render::kNoBody;
    const Vec3 feet = context_.avatar.feet_m();
    const WalkerShape shape = context_.avatar.walker->shape();
    for (std::uint32_t i = 0; i < scene_->bodies.size(); ++i) {
        const Aabb& box = world_.solids->box_of_placed(scene_->bodies[i].haptic);
        const Vec3 nearest = glm::clamp(feet, box.min_m, box.max_m);
        if (box.empty() || std::hypot(feet.x - nearest.x, feet.y - nearest.y) > shape.radius_m ||
            box.max_m.z < feet.z + kUnderFeet_m || box.min_m.z > feet.z + shape.height_m)
            continue;
        const std::size_t thing = scene_->bodies[i].haptic;
        if (!meets_walker(world_.scene->placed[thing].model, world_.things.at(thing), feet, shape)) continue;
        Vec3 out = feet - nearest;
        if (std::hypot(out.x, out.y) < 1e-3) out = feet - box.centre_m();
        out.z = 0.0;
        if (glm::length(out) < 1e-6) continue;
        out = glm::normalize(out);
        if (const double into = -glm::dot(intended_m_per_s, out); into > 0.0) {
            intended_m_per_s += out * into;
            met = i;
        }
        shove(i, out * -kOff_m_per_s);
    }
    return met;
}

void Bodies::announce_in_the_way(std::uint32_t body, double now_s) {
    const bool announced = body == in_the_way_ && now_s - in_the_way_s_ < kStrained_s;
    in_the_way_ = body;
    in_the_way_s_ = now_s;
    if (announced) return;
    cues::CueRequest bump;
    bump.kind = cues::CueRequestKind::Bump;
    bump.time_s = now_s;
    bump.feature = scene_->bodies[body].feature;
    bump.position_m = middle(body).position_m;
    bump.text = phrase("bodies.stuck", {{"name", body_name(context_, bump.feature)}});
    context_.cues.cue(std::move(bump));
}

bool Bodies::push_ahead(Vec3& intended_m_per_s, double now_s) {
    if (!engine_) return false;
    const double intended = std::hypot(intended_m_per_s.x, intended_m_per_s.y);
    const std::uint32_t met = keep_apart(intended_m_per_s);
    const double speed = std::hypot(intended_m_per_s.x, intended_m_per_s.y);
    if (met != render::kNoBody && speed < kHeldBack * intended) announce_in_the_way(met, now_s);
    if (!(speed > 0.0)) return false;
    const Vec3 along = Vec3(intended_m_per_s.x, intended_m_per_s.y, 0.0) / speed;
    const Vec3 feet = context_.avatar.feet_m();
    const TraceHit hit = world_.solids->trace(feet, feet + along * kBeforeFeet_m, context_.avatar.walker->shape());
    const std::uint32_t body = hit.hit ? body_of(hit.feature) : render::kNoBody;
    if (body == render::kNoBody || body == grip_.held()) return false;
    const render::DynamicsBody& is = scene_->bodies[body];
    const FreeBody* free = nullptr;
    for (const FreeBody& known : context_.world.scene->bodies)
        if (known.feature == is.feature) free = &known;
    const bool begins = body != pushed_ || now_s - pushed_s_ > kStrained_s;
    const Vec3 at = middle(body).position_m;
    if (begins || glm::length(at - pushed_from_m_) > kPushedOn_m) {
        pushed_since_s_ = now_s;
        pushed_from_m_ = at;
    }
    pushed_ = body;
    pushed_s_ = now_s;
    if (!free || !free->gives_way_to_walkers()) {
        if (begins)
            context_.say(heavy_words(context_, is.feature, is.nature.mass_kg), cues::SpeechClass::Contact, now_s);
        return false;
    }
    const double against = -glm::dot(hit.normal, along);
    const Vec3 level(hit.normal.x, hit.normal.y, 0.0);
    const double across = glm::length(level);
    // If the walker meets a side of the body at a slant, the body is pushed along the horizontal normal of that side.
    const Vec3 way = across > 0.1 ? -level / across : along;
    shove(body, way * (speed * std::max(0.3, against)));
    if (begins)
        context_.say(phrase("bodies.pushed", {{"name", body_name(context_, is.feature)}}), cues::SpeechClass::Contact,
                     now_s);
    return now_s - pushed_since_s_ < kGivesWayWithin_s;
}

}  // namespace handrail::core
