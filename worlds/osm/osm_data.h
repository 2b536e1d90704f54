// What of an OpenStreetMap file can matter for a building: places, ways and outlines with their tags. Plain values; the
// library that reads the file is known to osm_data.cpp alone, which reads with threads of its own while it is called.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "worlds/base/result.h"

namespace handrail {

struct OsmTags {
    std::vector<std::pair<std::string, std::string>> all;  // in file order

    // Empty: there is none.
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
    std::vector<std::pair<std::int64_t, bool>> ways;  // and whether each is a hole
    OsmTags tags;
};

struct OsmData {
    std::unordered_map<std::int64_t, OsmNode> nodes;  // looked up by number only
    std::vector<std::int64_t> tagged_nodes;           // in file order
    std::vector<OsmWay> ways;
    std::unordered_map<std::int64_t, std::size_t> way_number;  // looked up only
    std::vector<OsmArea> areas;
    // IndoorOSM writes no level on rooms: a relation of type level lists its ways, and names the level. Looked up only.
    std::unordered_map<std::int64_t, std::string> level_of_way;
    std::vector<OsmTags> levels;  // of those relations

    // As the way states its level, else as the relation does that lists the way; empty: neither does.
    std::string_view level_of(const OsmWay& way) const;
};

enum class OsmForm : std::uint8_t { None, Xml, XmlBzip2, Pbf };
// By its first bytes; bzip2 also by its name, since anything may be in it.
OsmForm osm_form(std::string_view bytes, std::string_view file_name);

inline constexpr std::size_t kMostOsmNodes = 4'000'000, kMostOsmWays = 1'000'000;

// Fails with one sentence for what is damaged, cut short or too large.
Result<OsmData> read_osm_data(std::string_view bytes, OsmForm form, const std::string& file_name,
                              const std::stop_token& stop);

}  // namespace handrail
