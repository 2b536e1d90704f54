// Builds the Scene of one building part by part: the implementation of scene_of_plan. Used on one thread.
#pragma once

#include <memory>

#include "worlds/floorplan/plan_scene.h"
#include "worlds/floorplan/plan_stairs.h"
#include "worlds/floorplan/plan_walls.h"
#include "worlds/scene/stated_building.h"

namespace handrail::floorplan {

class PlanBuilder {
public:
    PlanBuilder(FloorPlan plan, const PlanOptions& options);
    Result<Scene> build(const std::string& file_name);

private:
    static constexpr std::uint32_t kNoLift = 0xffffffffU;

    bool stopped() const { return options_.stop.stop_requested() || too_large(); }
    bool too_large() const;
    void state_rooms();
    std::string room_name(const PlanSpace& space, std::size_t level, bool with_level) const;
    double storey_of(std::size_t level) const;
    double floor_of(std::size_t space, std::size_t level) const;
    double highest_raise(const std::vector<std::size_t>& spaces, std::size_t level) const;
    std::vector<Ring> platforms_in(std::size_t space, std::size_t level, bool ceiling) const;
    void plan_vertical_spaces();
    void add_lifts();
    void add_platforms();
    FeatureId add_cabin(const Ring& floor, double low_m, double way_m, const std::string& name,
                        std::vector<double> halts);
    void add_floors(std::size_t space, std::size_t level);
    void add_facts(const std::vector<Ring>& parts, double floor_m, const std::vector<std::string>& facts);
    void add_walls(std::size_t level, const LevelWalls& walls);
    void add_doors(std::size_t level, const LevelWalls& walls);
    void add_leaf(const PlanDoor& door, const DoorGap& gap, double floor_m, double from, double to, bool hinge_at_from,
                  bool to_left, std::uint32_t lift, std::uint32_t group);
    void add_openings(std::size_t level, const LevelWalls& walls);
    void add_stairs(std::size_t space);
    void add_flights();
    void add_flight(const PlanFlight& flight);
    void fence_flight(const PlanFlight& flight, const StairWell& well, double top_m);
    std::vector<Ring> without_flights(std::vector<Ring> parts, std::size_t level, bool ceiling) const;
    std::vector<Ring> without_flight_gaps(const Ring& wall, std::size_t level) const;
    void add_things();
    void add_ways();
    void join_ways(const std::vector<FeatureId>& features, const std::vector<std::uint32_t>& rooms);
    void join_doors_with_ways(const std::vector<std::uint32_t>& rooms);
    void open_ways_to_the_ground(const std::vector<std::uint32_t>& rooms);
    std::vector<Ring> add_strips(const PlanWay& way, FeatureId feature);
    void state_way(const PlanWay& way, const std::vector<Ring>& parts);
    void add_blocks();
    void add_ground();
    void add_starts();
    void write_report();

    FeatureId add_feature(FeatureKind kind, std::string_view made_name, const std::string& name);
    void add_solid(std::optional<ConvexSolid> shape, SolidRole role, FeatureId feature,
                   MaterialId material = kDefaultMaterial);
    // Returns a material of the library, or the default wall if the library does not have it.
    MaterialId material_named(const std::string& name);
    double room_height(std::size_t space, std::size_t level) const;
    void warn(std::string message, std::string action);
    std::uint32_t room_at(std::size_t space, std::size_t level) const;
    // Returns the portal that connects two rooms on different storeys, as the file states it. Each room may be
    // kNotStated.
    static StatedPortal portal_between(StatedPortalKind kind, const std::string& name, int line, std::uint32_t low,
                                       std::uint32_t high);
    std::vector<std::uint32_t> rooms_at(const std::vector<std::size_t>& spaces, std::size_t level) const;

    FloorPlan plan_;
    const PlanOptions& options_;
    Scene scene_;
    std::shared_ptr<StatedBuilding> stated_;
    std::vector<std::vector<std::uint32_t>> looks_;
    std::vector<std::vector<std::uint32_t>> room_of_;  // for each space: its room on each of its levels
    // For each level: the height of its lowest floor relative to the level, negative or 0.
    std::vector<double> lowest_raise_;
    std::vector<std::optional<StairWell>> wells_;  // for each space: where its stairs are, if it has any
    std::vector<Ring> cabins_;  // for each space: the outline of the lift cabin; empty if the space is not a lift
    std::vector<std::uint32_t> lifts_;  // for each space: its lift, as an index into Scene::movers
    std::vector<FeatureId> vertical_;   // for each space: the feature of its stairs or lift
    struct OuterDoor {
        PlanEntrance entrance = PlanEntrance::Plain;
        Vec3 at_m{0.0};
        Vec2 out{0.0};
        std::string name;
    };
    std::vector<OuterDoor> outer_;
    double ground_m_ = 0.0;
    std::size_t ground_level_ = 0;
    int to_nowhere_ = 0, narrow_ = 0, widened_ = 0, off_walls_ = 0, moved_ = 0, guessed_widths_ = 0, revolving_ = 0,
        no_stairs_ = 0;
};

}  // namespace handrail::floorplan
