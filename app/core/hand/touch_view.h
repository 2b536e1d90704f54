// What the hand feels of the world at its present scale, and how the servo is tuned for it. The scene is simplified,
// rounded and compiled again as a background task if scale, settings or world require it. App thread only.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/hand/felt_world.h"
#include "worlds/base/background_task.h"

namespace handrail::core {

// The openings between rooms that have no door, as far as they are known.
struct KnownOpenings {
    OpenPortals portals;
    bool awaited = false;  // rooms are still being searched for, so there may be more
};

class TouchView : SessionPart {
public:
    // Tunes `hands`. Rebuilds the solids for walking in `world` together with the rendered surfaces.
    TouchView(const SessionContext& context, WorldState& world, WalkerState& body, HandsState& hands)
        : SessionPart(context), world_(world), body_(body), hands_(hands) {}

    // True while a scene is being made in the background. Until it is done the hand feels the previous one, at first
    // the world without simplifications or rounded edges.
    bool busy() const { return felt_.busy(); }

    // Another world was entered. sharp: see EnteringWorld; null: it is made now.
    void enter_world(std::shared_ptr<const render::HapticScene> sharp, double now_s);
    // Something was added to the present world or removed from it.
    void change_world(double now_s);
    // Tunes the servo by scale and settings; the rendered scene stays.
    void retune();
    // Call it after retune(). Begins to make another scene if scale and settings require one; take_made() fetches it.
    void adapt();
    // True if what the hand feels, or will feel after the background task, does not match scale and settings.
    bool stale();
    // Returns true if the background task is done; its scene is rendered from now on.
    bool take_made(double now_s);
    // rooms_known: the rooms have been found, so openings that depended on them are widened now.
    void widen_openings(bool rooms_known);

    const std::shared_ptr<const render::HapticScene>& felt() const { return haptic_; }
    const compile::Simplification& plan() const { return plan_; }  // of what is felt
    const OpenPortals& portals() const { return portals_; }        // that its openings are those of
    // The things of what is felt whose meshes are coarser than in truth.
    const std::vector<compile::CoarserMesh>& coarser() const { return coarser_; }
    servo::ServoTuning left_tuning() const;
    // The sentence on simplifications if it differs from the last one announced; otherwise empty.
    std::string news();
    // How far the hands must move so that the proxy fits at its place. It may have grown with the scale, or walls may
    // have returned. left_m counts only if there is a left hand.
    Vec3 out_of_solids_m(const Vec3& right_m, const Vec3& left_m) const;
    // An upper bound for the distance of anything from a hand in this world.
    double farthest_m() const;

    // Set by the session; called only if the scale needs openings.
    std::function<KnownOpenings()> openings;

private:
    struct Wish {
        std::optional<compile::SimplifyOptions> simplify;
        OpenPortals portals;
    };
    Wish wish();
    FeltOrder order();
    Vec3 out_of_solids_m(const Vec3& hand_m) const;

    WorldState& world_;
    WalkerState& body_;
    HandsState& hands_;
    std::shared_ptr<const render::HapticScene> haptic_;
    double rounded_m_ = 0.0;                     // edges in it
    double mesh_tolerance_m_ = 0.0;              // of its dense meshes
    std::vector<compile::CoarserMesh> coarser_;  // in it
    compile::Simplification plan_;               // by which it was made
    OpenPortals portals_;                        // that the plan knew
    bool openings_awaited_ = false;              // the plan would know more if the rooms were found
    int edits_ = 0;                              // of any world
    std::optional<FeltOrder> ordered_;           // the last one of this world
    BackgroundTask<FeltWorld> felt_{context_.executor, "touch", context_.arrivals};
    std::string told_;  // of what is simplified
};

}  // namespace handrail::core
