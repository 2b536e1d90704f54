// Reads the parts of an OpenStreetMap file that can matter for a building: nodes, ways and outlines with their tags.
// Plain values. Only osm_data.cpp uses the library that reads the file. That library starts threads of its own, which
// end before the call returns.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::osm {

struct OsmTags {
    std::vector<std::pair<std::string, std::string>> all;  // keys and values in file order

    // Returns an empty text if the key is missing.
    std::string_view operator[](std::string_view key) const;
    bool has(std::string_view key) const { return !(*this)[key].empty(); }
    bool is(std::string_view key, std::string_view value) const { return (*this)[key] == value; }
};

struct OsmNode {
    double lon_deg = 0.0, lat_deg = 0.0;
    OsmTags tags;
};

struct OsmWay {
    std::int64_t id = 0;
    std::vector<std::int64_t> nodes;
    OsmTags tags;

    bool closed() const { return nodes.size() > 3 && nodes.front() == nodes.back(); }
};

// An area with holes: a relation of type multipolygon.
struct OsmArea {
    std::int64_t id = 0;
    std::vector<std::pair<std::int64_t, bool>> ways;  // the id of each way, and whether the way is a hole
    OsmTags tags;
};

struct OsmData {
    std::unordered_map<std::int64_t, OsmNode> nodes;  // nodes by id; never iterated, because the order is arbitrary
    std::vector<std::int64_t> tagged_nodes;           // ids of the nodes with tags, in file order
    std::vector<OsmWay> ways;
    // Index of each way, by its id; never iterated, because the order is arbitrary.
    std::unordered_map<std::int64_t, std::size_t> way_number;
    std::vector<OsmArea> areas;
    // The level of a way, by the way's id. IndoorOSM writes no level on rooms; instead, a relation of type level names
    // the level and lists its ways. The map is never iterated, because its order is arbitrary.
    std::unordered_map<std::int64_t, std::string> level_of_way;
    std::vector<OsmTags> levels;  // tags of the relations of type level

    // Returns the level that the way states, or else the level of the relation that lists the way. Empty if neither way
    // nor relation states one.
    std::string_view level_of(const OsmWay& way) const;
};

enum class OsmForm : std::uint8_t { None, Xml, XmlBzip2, Pbf };
// Recognises the format by the first bytes. For bzip2, the file's name is checked as well, because a bzip2 file can
// contain anything.
OsmForm osm_form(std::string_view bytes, std::string_view file_name);

inline constexpr std::size_t kMostOsmNodes = 4'000'000, kMostOsmWays = 1'000'000;

// Reads the file. Fails with one sentence if it is damaged, cut short or too large.
Result<OsmData> read_osm_data(std::string_view bytes, OsmForm form, const std::string& file_name,
                              const std::stop_token& stop);

}  // namespace handrail::osm
