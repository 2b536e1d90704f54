// What the hand feels of the world at the scale it has: simplified, rounded and compiled anew where scale, settings or
// world ask for it, at once or on a thread beside; and how its servo is tuned to it. App thread only.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/core/context/session_part.h"
#include "app/core/hand/felt_world.h"
#include "app/core/world/beside.h"

namespace handrail {

// The openings of the rooms that have no door, as far as they are known.
struct KnownOpenings {
    OpenPortals portals;
    bool awaited = false;  // rooms are looked for beside, so there may be more
};

class TouchView : SessionPart {
public:
    // It tunes `hands`, and makes what is walked of `world` anew along with what is felt.
    TouchView(const SessionContext& context, WorldState& world, BodyState& body, HandsState& hands)
        : SessionPart(context), world_(world), body_(body), hands_(hands) {}

    // Of worlds entered from now on, and of every later scale, it is made on a thread beside everything else: until it
    // is there the hand feels what there was, at first the world as sharp as it is.
    void make_beside() { beside_ = true; }
    bool beside() const { return beside_; }
    bool busy() const { return felt_.busy(); }

    // The scene is another world's. sharp: see EnteringWorld; null: it is made now.
    void enter_world(std::shared_ptr<const HapticScene> sharp, double now_s);
    // The scene is the same world's with something added or taken away.
    void change_world(double now_s);
    // The tuning by scale and settings; the scene that is felt stays.
    void retune();
    // After retune(). True where the hand feels another scene from now on; what is made beside comes later.
    bool adapt(double now_s);
    // Does the hand feel, or will it when what is made beside is there, something else than the scale and the settings
    // ask for?
    bool stale();
    // What was made beside is there, and felt from now on.
    bool take_made(double now_s);
    // rooms_known: they have been found by now, so openings that were waited for are widened too. True where the hand
    // feels that from now on.
    bool widen_openings(bool rooms_known, double now_s);

    const std::shared_ptr<const HapticScene>& felt() const { return haptic_; }
    const Simplification& plan() const { return compiled_; }  // of what is felt
    const OpenPortals& portals() const { return portals_; }   // that its openings are those of
    ServoTuning left_tuning() const;
    // The sentence on what is simplified, where it is not the one that was said last; empty else.
    std::string news();
    // How far each hand has to go so that the ball fits where it is: it may have grown with the scale, and walls may be
    // back. left_m counts only where there is a left hand.
    Vec3 out_of_solids_m(const Vec3& right_m, const Vec3& left_m) const;
    // As far as anything can be from a hand in this world.
    double farthest_m() const;

    // Set by the session; asked only where the scale cares.
    std::function<KnownOpenings()> openings;

private:
    struct Wish {
        std::optional<SimplifyOptions> simplify;
        OpenPortals portals;
    };
    Wish wish();
    Simplification plan_for_scale();
    FeltOrder order();
    double rounding_m() const;
    void compile(std::uint32_t world);
    void feel_scene(double now_s);
    Vec3 out_of_solids_m(const Vec3& hand_m) const;

    WorldState& world_;
    BodyState& body_;
    HandsState& hands_;
    std::shared_ptr<const HapticScene> haptic_;
    double rounded_m_ = 0.0;             // edges in it
    Simplification planned_, compiled_;  // of the scale, and of what is felt; they differ while the hand is at the desk
    OpenPortals portals_;                // that planned_ was told of
    bool openings_awaited_ = false;      // the plan would know more if the rooms were found
    bool beside_ = false;
    int edits_ = 0;                     // of any world
    std::optional<FeltOrder> ordered_;  // beside: the last one of this world
    Beside<FeltWorld> felt_;
    std::string told_;  // of what is simplified
};

}  // namespace handrail
