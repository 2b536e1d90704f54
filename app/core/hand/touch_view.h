// The part of a session that determines what the hand feels of the world at the present scale, and how the servo is
// tuned for it. If scale, settings or world require it, a background task simplifies, rounds and compiles the scene
// again. App thread only.
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
    // Writes the tuning to `hands`. Whenever the rendered surfaces are rebuilt, also rebuilds the solids for walking in
    // `world`.
    TouchView(const SessionContext& context, WorldState& world, WalkerState& body, HandsState& hands)
        : SessionPart(context), world_(world), body_(body), hands_(hands) {}

    // True while a background task makes a scene. Until it is done, the hand feels the previous scene. After a world is
    // entered, that is the world without simplifications and rounded edges.
    bool busy() const { return felt_.busy(); }

    // Call it when another world was entered. `sharp` is the scene without simplifications, as in EnteringWorld; if it
    // is null, this function makes it.
    void enter_world(std::shared_ptr<const render::HapticScene> sharp, double now_s);
    // Call it when something was added to or removed from the present world.
    void change_world(double now_s);
    // Tunes the servo to scale and settings; the rendered scene stays the same.
    void retune();
    // Begins to make another scene if scale and settings require one; take_made() then fetches it. Call it after
    // retune().
    void adapt();
    // True if scale and settings require another scene than the one that is rendered or being made.
    bool stale();
    // Returns true once the background task is done. Its scene is then rendered.
    bool take_made(double now_s);
    // Orders a scene with widened openings if the rooms are known by now. Openings without a door depend on the rooms.
    void widen_openings(bool rooms_known);

    const std::shared_ptr<const render::HapticScene>& felt() const { return haptic_; }
    const compile::Simplification& plan() const { return plan_; }  // the simplifications of the rendered scene
    const OpenPortals& portals() const { return portals_; }        // the portals whose openings plan() has widened
    // The things in the rendered scene whose meshes are coarser than the original.
    const std::vector<compile::CoarserMesh>& coarser() const { return coarser_; }
    servo::ServoTuning left_tuning() const;
    // Returns the sentence on simplifications if it differs from the one announced last; otherwise an empty text.
    std::string news();
    // Returns how far the hands must move so that the proxies fit at their places. The proxy may have grown with the
    // scale, or walls may have returned. `left_m` counts only if there is a left hand.
    Vec3 out_of_solids_m(const Vec3& right_m, const Vec3& left_m) const;
    // Returns an upper bound for the distance of any part of this world from a hand.
    double farthest_m() const;

    // Set by the session. It is called only if the scale needs openings.
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
    double rounded_m_ = 0.0;                     // how far edges in `haptic_` are rounded
    double mesh_tolerance_m_ = 0.0;              // tolerance of the dense meshes in `haptic_`
    std::vector<compile::CoarserMesh> coarser_;  // coarser meshes in `haptic_`
    compile::Simplification plan_;               // simplifications in `haptic_`
    OpenPortals portals_;                        // the openings that the plan considered
    bool openings_awaited_ = false;              // the plan would contain more openings if the rooms were known
    int edits_ = 0;                              // number of changes to any world
    std::optional<FeltOrder> ordered_;           // the last order for this world
    BackgroundTask<FeltWorld> felt_{context_.executor, "touch", context_.arrivals};
    std::string told_;  // the last announced sentence on simplifications
};

}  // namespace handrail::core
