// Chooses the haptic scene that the hand feels at the present scale, and tunes the servo for that scale. The
// session owns this class. If scale, settings or world require it, a background task simplifies, rounds and compiles
// the scene again. Use the class on the app thread only.
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

// The known openings between rooms that have no door.
struct KnownOpenings {
    OpenPortals portals;
    bool awaited = false;  // true: the search for rooms is still under way, so there may be more openings
};

class TouchView : SessionPart {
public:
    // Writes the tuning to `hands`. Whenever it rebuilds the rendered surfaces, it also rebuilds the solids for walking
    // in `world`.
    TouchView(const SessionContext& context, WorldState& world, WalkerState& avatar, HandsState& hands)
        : SessionPart(context), world_(world), avatar_(avatar), hands_(hands) {}

    // Returns true while a background task makes a scene. Until the task is done, the hand feels the previous scene.
    // After a world is entered, that is the world without simplifications and rounded edges.
    bool busy() const { return felt_.busy(); }

    // Call this function when another world was entered. `sharp` is the scene without simplifications, as in
    // EnteringWorld. If `sharp` is null, this function makes it.
    void enter_world(std::shared_ptr<const render::HapticScene> sharp, double now_s);
    // Call it when something was added to or removed from the present world.
    void change_world(double now_s);
    // Tunes the servo to scale and settings. The rendered scene stays the same.
    void retune();
    // Begins to make another scene if scale and settings require one; take_made() then fetches it. Call it after
    // retune().
    void adapt();
    // Returns true if scale and settings require another scene than the one that is rendered or being made.
    bool stale();
    // Returns true once after the background task is done. The scene from that task is then rendered.
    bool take_made(double now_s);
    // Orders a scene with widened openings if the rooms are known by now. The search for rooms finds the openings that
    // have no door.
    void widen_openings(bool rooms_known);

    const std::shared_ptr<const render::HapticScene>& felt() const { return haptic_; }
    const compile::Simplification& plan() const { return plan_; }  // returns the simplifications of the rendered scene
    const OpenPortals& portals() const { return portals_; }  // returns the portals whose openings plan() has widened
    // Returns the things in the rendered scene whose meshes are coarser than the original.
    const std::vector<compile::CoarserMesh>& coarser() const { return coarser_; }
    servo::ServoTuning left_tuning() const;
    // Returns the sentence on simplifications if it differs from the sentence announced last. Otherwise returns an
    // empty text.
    std::string news();
    // Returns how far the hands must move so that the proxies fit at their places. The proxy may have grown with the
    // scale, or walls may have returned. `left_m` is ignored if there is no left hand.
    Vec3 out_of_solids_m(const Vec3& right_m, const Vec3& left_m) const;
    // Returns an upper bound for the distance of any part of this world from a hand.
    double farthest_m() const;

    // The session sets this function. It is called only if the simplification needs the openings at the present scale.
    std::function<KnownOpenings()> openings;

private:
    struct FeltRequest {
        std::optional<compile::SimplifyOptions> simplify;
        OpenPortals portals;
    };
    FeltRequest felt_request();
    FeltOrder order();
    Vec3 out_of_solids_m(const Vec3& hand_m) const;

    WorldState& world_;
    WalkerState& avatar_;
    HandsState& hands_;
    std::shared_ptr<const render::HapticScene> haptic_;
    double rounded_m_ = 0.0;                     // how far edges in `haptic_` are rounded
    compile::OwnRounding own_rounding_;          // how solids with a radius of their own are rounded in `haptic_`
    double mesh_tolerance_m_ = 0.0;              // tolerance of the dense meshes in `haptic_`
    std::vector<compile::CoarserMesh> coarser_;  // coarser meshes in `haptic_`
    compile::Simplification plan_;               // simplifications in `haptic_`
    OpenPortals portals_;                        // the openings that `plan_` considers
    bool openings_awaited_ = false;              // true: the plan would contain more openings if the rooms were known
    int edits_ = 0;                              // number of changes to the worlds of this session
    std::optional<FeltOrder> ordered_;           // the last order for this world
    BackgroundTask<FeltWorld> felt_{context_.executor, "touch", context_.arrivals};
    std::string announced_;  // the last announced sentence on simplifications
};

}  // namespace handrail::core
