// The parts of an OpenStreetMap file that can matter for a building: nodes, ways and outlines with their tags. Plain
// values. Only osm_data.cpp knows the library that reads the file; it uses threads of its own during the call.
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
    std::vector<std::pair<std::string, std::string>> all;  // in file order

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

// A relation of type multipolygon.
struct OsmArea {
    std::int64_t id = 0;
    std::vector<std::pair<std::int64_t, bool>> ways;  // id, and whether the way is a hole
    OsmTags tags;
};

struct OsmData {
    std::unordered_map<std::int64_t, OsmNode> nodes;  // by id; never iterated
    std::vector<std::int64_t> tagged_nodes;           // in file order
    std::vector<OsmWay> ways;
    std::unordered_map<std::int64_t, std::size_t> way_number;  // by id; never iterated
    std::vector<OsmArea> areas;
    // IndoorOSM writes no level on rooms. Instead, a relation of type level lists its ways and names the level. Never
    // iterated.
    std::unordered_map<std::int64_t, std::string> level_of_way;
    std::vector<OsmTags> levels;  // tags of those relations

    // The level that the way states, else the level of the relation that lists the way; empty if neither states one.
    std::string_view level_of(const OsmWay& way) const;
};

enum class OsmForm : std::uint8_t { None, Xml, XmlBzip2, Pbf };
// Recognises the format by the first bytes; bzip2 also by the file's name, because it can contain anything.
OsmForm osm_form(std::string_view bytes, std::string_view file_name);

inline constexpr std::size_t kMostOsmNodes = 4'000'000, kMostOsmWays = 1'000'000;

// Fails with one sentence if the file is damaged, cut short or too large.
Result<OsmData> read_osm_data(std::string_view bytes, OsmForm form, const std::string& file_name,
                              const std::stop_token& stop);

}  // namespace handrail::osm
