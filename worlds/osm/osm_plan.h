// Turns OpenStreetMap tags into a plan: which outlines are rooms, which nodes are doors, and which levels exist. Used
// on the reading thread only.
#pragma once

#include <map>
#include <optional>

#include "worlds/floorplan/local_plane.h"
#include "worlds/osm/read_osm.h"

namespace handrail::osm {

class OsmPlan {
public:
    OsmPlan(const OsmData& data, const OsmOptions& options);
    // Builds the plan. Fails with one sentence if there is nothing to walk on, or if the requested building does not
    // exist.
    Result<floorplan::FloorPlan> build(const std::string& file_name);

private:
    struct Outline {
        std::string id;
        const OsmTags* tags = nullptr;
        std::vector<std::vector<std::int64_t>> rings;  // each ring as node ids; the first id is not repeated at the end
        std::vector<double> levels;
        std::size_t building = kNone;
    };
    // A way or an area that people walk on outside rooms.
    struct Walked {
        std::string id;
        const OsmTags* tags = nullptr;
        // For a line: the ids of its nodes. For an area: the ids of the nodes of its outlines, without repetition of
        // the first node.
        std::vector<std::vector<std::int64_t>> lines;
        bool area = false;
        std::string_view level;  // the level as the file states it

        bool steps() const { return tags->is("highway", "steps"); }
        std::vector<double> levels() const;  // returns at least one level
    };
    struct Building {
        std::string id, name, ref;
        const OsmTags* tags = nullptr;
        std::vector<Ring> rings;  // outlines in degrees
        Vec2 least{1e300}, most{-1e300};
        int spaces = 0;
    };
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    void find_outlines();
    void take_outline(std::string id, const OsmTags& tags, std::string_view level,
                      std::vector<std::vector<std::int64_t>> rings);
    std::vector<std::vector<std::int64_t>> rings_of(const OsmArea& area, bool& broken) const;
    bool all_known(const std::vector<std::int64_t>& nodes) const;
    std::vector<Ring> in_degrees(const std::vector<std::vector<std::int64_t>>& rings) const;
    Result<void> choose_building(const std::string& file_name);
    void stack_outlines();
    void set_origin();
    Vec2 place_of(std::int64_t node) const;
    std::vector<Ring> placed(const std::vector<std::vector<std::int64_t>>& rings) const;
    void lay_levels();
    void find_level_names();
    floorplan::PlanLevel level_made(double number) const;
    std::size_t level_at(double number) const;  // returns kNone if there is no such level
    void add_spaces();
    void add_doors();
    void add_walls_and_things();
    std::vector<std::size_t> levels_here(std::string_view level_text, const OsmTags& tags) const;
    void add_drawn(const OsmWay& way);
    void name_thing(floorplan::PlanThing& thing, const OsmTags& tags, std::string_view what) const;
    void add_thing_at(std::int64_t node);
    void add_lift_nodes();
    bool add_lift_at(std::int64_t node, std::size_t rooms);
    void add_ways(bool rooms_are_joined);
    bool is_within_rooms(const Walked& walked) const;
    std::vector<Walked> find_walked();
    void add_landings(const std::vector<Walked>& walked, std::unordered_map<std::int64_t, double>& height_m) const;
    floorplan::PlanWay way_of(const Walked& walked, const std::unordered_map<std::int64_t, double>& height_m) const;
    void name_ways(const std::vector<Walked>& walked);
    void distinguish_ways(const std::vector<Walked>& walked);
    void add_levels(const std::vector<Walked>& walked, const std::unordered_map<std::int64_t, double>& height_m);
    bool is_lift_node(std::int64_t node) const;
    void add_blocks();
    bool rooms_are_joined() const;
    void report(std::string_view key, int count, const std::string& ids = {});

    const OsmData& data_;
    const OsmOptions& options_;
    floorplan::FloorPlan plan_;
    std::vector<Outline> outlines_;
    std::vector<Building> buildings_;
    std::size_t chosen_ = kNone;
    // Ways far from all of these outlines are left out; if this is empty, all ways are read.
    std::vector<Ring> surroundings_of_;
    floorplan::LocalPlane plane_;
    std::map<double, std::string> level_names_;  // the names of levels that the file states
    // Spaces of each node; never iterated, because the order is arbitrary.
    std::unordered_map<std::int64_t, std::vector<std::size_t>> spaces_of_;
    int open_ = 0, incomplete_ = 0, without_level_ = 0, odd_levels_ = 0, doors_alone_ = 0;
    std::string open_ids_, incomplete_ids_;
};

}  // namespace handrail::osm
