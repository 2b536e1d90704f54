// Turns a building from an IFC file into a Scene: solids, sheets, door leaves, panes, the ground outside, and starting
// points. Used on the reading thread only.
#pragma once

#include "worlds/ifc/door_trial.h"
#include "worlds/ifc/ifc_building.h"
#include "worlds/ifc/ifc_spaces.h"
#include "worlds/ifc/read_ifc.h"

namespace handrail::ifc {

class IfcScene {
public:
    IfcScene(IfcBuilding building, const IfcRelations& relations, const IfcModel& model, const IfcOptions& options);
    Result<Scene> build(const std::string& file_name);

private:
    void prove_doors();
    void add_parts();
    void add_part(std::size_t part);
    StatedThing stated_thing(std::size_t part, std::size_t solids, std::size_t triangles) const;
    void add_door(std::size_t part, const WallGap& gap);
    void add_window(std::size_t part, const WallGap& gap);
    void add_door_without_place(std::size_t part);
    void add_leaf(const WallGap& gap, double from, double to, bool hinge_at_least, std::size_t part,
                  std::uint32_t group);
    void add_solid(ConvexSolid shape, SolidRole role, FeatureId feature, const std::string& material, int line);
    FeatureId add_feature(FeatureKind kind, std::string_view made_name, const std::string& name, int line);
    FeatureId thing_of(std::size_t part);
    MaterialId material(const std::string& name, bool guessed);
    std::string touch_material(const IfcPart& part);
    StatedPortal portal_of(std::size_t part, const WallGap& gap);
    void join_flights();
    std::vector<StatedPortal> open_borders() const;
    void join_open_rooms(std::vector<StatedPortal> borders);
    void note_stairwell(const Aabb& stairs);
    void add_ground();
    void try_doors();
    void note_impassable(const StatedPortal& portal);
    void add_starts();
    void write_report();
    void warn(int line, std::string message, std::string action);

    IfcBuilding building_;
    const IfcRelations& relations_;
    const IfcModel& model_;
    const IfcOptions& options_;
    Scene scene_;
    std::shared_ptr<StatedBuilding> stated_;
    std::vector<std::vector<std::uint32_t>> looks_;
    std::map<std::size_t, FeatureId> thing_;  // feature of each whole, by its index in building_.parts
    std::map<std::string, std::set<std::string>> guessed_from_;
    std::map<std::string, int> prefabs_;  // number of times that each prefab replaces a part without a shape
    // Names of the parts that were cut to open a door, by the door's index in building_.parts.
    std::map<std::size_t, std::vector<std::string>> freed_;
    struct DoorPortal {
        std::size_t portal = 0;  // index into stated_->portals
        std::size_t part = 0;    // index into building_.parts
    };
    std::vector<DoorPortal> doors_, outer_doors_;
    // The side of each door that is under the open sky, along y of its gap. Only for files without rooms.
    std::map<std::size_t, double> sky_side_;
    RoomsByPlace rooms_;     // index over the rooms of stated_
    double ground_m_ = 0.0;  // height of the ground around the building
    int differing_ = 0, plain_ = 0;
};

// Returns the touch material that the file's words for a material suggest, in English or German. Empty if they suggest
// none.
std::string_view material_of_words(std::string_view words);
// Returns the prefab for the first known piece of furniture that the words name, in English or German. Null if they
// name none.
const Prefab* prefab_for(const std::vector<std::string>& words);
// Returns the part of a name that can be spoken: "M_Chair-Breuer:M_Chair-Breuer:174845" becomes "Chair-Breuer".
std::string spoken_part_name(const std::string& name);

}  // namespace handrail::ifc
