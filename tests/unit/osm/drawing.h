// Draws stations and campuses for tests as OpenStreetMap mappers draw them.
#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "worlds/base/vec.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/scene.h"

namespace handrail::test {

// Writes an OpenStreetMap file of nodes and ways. Places are in metres.
class Drawing {
public:
    using Tags = std::vector<std::pair<std::string, std::string>>;

    int node(double east_m, double north_m, const Tags& tags = {}) {
        constexpr double kDegree_m = 111'319.49;
        const double lat = 51.0 + north_m / kDegree_m, lon = 7.0 + east_m / (kDegree_m * std::cos(51.0 * kPi / 180.0));
        std::ostringstream text;
        text.precision(12);
        text << "<node id='" << ++ids_ << "' lat='" << lat << "' lon='" << lon << "'>" << words(tags) << "</node>\n";
        nodes_ += text.str();
        return ids_;
    }
    int way(const std::vector<int>& nodes, const Tags& tags) {
        ways_ += "<way id='" + std::to_string(++ids_) + "'>";
        for (const int n : nodes) ways_ += "<nd ref='" + std::to_string(n) + "'/>";
        ways_ += words(tags) + "</way>\n";
        return ids_;
    }
    int box(double west_m, double south_m, double east_m, double north_m, const Tags& tags) {
        const int first = node(west_m, south_m);
        return way({first, node(east_m, south_m), node(east_m, north_m), node(west_m, north_m), first}, tags);
    }
    void relation(const std::string& members, const Tags& tags) {
        relations_ += "<relation id='" + std::to_string(++ids_) + "'>" + members + words(tags) + "</relation>\n";
    }
    std::string text() const { return "<osm version='0.6'>\n" + nodes_ + ways_ + relations_ + "</osm>\n"; }
    Scene scene() const {
        Result<Scene> scene = read_osm(text(), "station.osm");
        EXPECT_TRUE(scene.has_value()) << scene.error().sentence();
        if (!scene) return {};
        const Result<void> valid = validate(*scene);
        EXPECT_TRUE(valid.has_value()) << valid.error().sentence();
        return std::move(*scene);
    }

private:
    static std::string words(const Tags& tags) {
        std::string text;
        for (const auto& [key, value] : tags) text += "<tag k='" + key + "' v='" + value + "'/>";
        return text;
    }

    int ids_ = 0;
    std::string nodes_, ways_, relations_;
};

}  // namespace handrail::test
