// What the hand feels of the world at the scale it has: simplified, rounded and compiled anew in the background when
// scale, settings or world require it; and how its servo is tuned to it. App thread only.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/core/context/session_part.h"
#include "app/core/hand/felt_world.h"
#include "worlds/base/background_task.h"

namespace handrail {

// The openings of the rooms that have no door, as far as they are known.
struct KnownOpenings {
    OpenPortals portals;
    bool awaited = false;  // rooms are still looked for, so there may be more
};

class TouchView : SessionPart {
public:
    // It tunes `hands`, and makes what is walked of `world` anew along with what is felt.
    TouchView(const SessionContext& context, WorldState& world, BodyState& body, HandsState& hands)
        : SessionPart(context), world_(world), body_(body), hands_(hands) {}

    // Until what is made for a world or a scale is there, the hand feels what there was: at first the world without
    // simplifications or rounded edges.
    bool busy() const { return felt_.busy(); }

    // The scene is another world's. sharp: see EnteringWorld; null: it is made now.
    void enter_world(std::shared_ptr<const HapticScene> sharp, double now_s);
    // The scene is the same world's with something added or taken away.
    void change_world(double now_s);
    // The tuning by scale and settings; the scene that is felt stays.
    void retune();
    // After retune(): begins to make another scene if the scale and the settings require one; take_made() has it.
    void adapt();
    // Does the hand feel, or will it when what is made beside is there, something else than the scale and the settings
    // ask for?
    bool stale();
    // What was made in the background is there, and felt from now on.
    bool take_made(double now_s);
    // rooms_known: they have been found by now, so openings that were waited for are widened, too.
    void widen_openings(bool rooms_known);

    const std::shared_ptr<const HapticScene>& felt() const { return haptic_; }
    const Simplification& plan() const { return plan_; }     // of what is felt
    const OpenPortals& portals() const { return portals_; }  // that its openings are those of
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
    FeltOrder order();
    Vec3 out_of_solids_m(const Vec3& hand_m) const;

    WorldState& world_;
    BodyState& body_;
    HandsState& hands_;
    std::shared_ptr<const HapticScene> haptic_;
    double rounded_m_ = 0.0;            // edges in it
    Simplification plan_;               // by which it was made
    OpenPortals portals_;               // that the plan knew
    bool openings_awaited_ = false;     // the plan would know more if the rooms were found
    int edits_ = 0;                     // of any world
    std::optional<FeltOrder> ordered_;  // the last one of this world
    BackgroundTask<FeltWorld> felt_{context_.executor, "touch"};
    std::string told_;  // of what is simplified
};

}  // namespace handrail
