#include "worlds/osm/osm_data.h"

#include <algorithm>
#include <array>
#include <osmium/io/bzip2_compression.hpp>
#include <osmium/io/pbf_input.hpp>
#include <osmium/io/reader.hpp>
#include <osmium/io/xml_input.hpp>
#include <osmium/osm/relation.hpp>
#include <osmium/osm/way.hpp>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::osm {
namespace {

constexpr std::size_t kMostRefs = 20'000'000, kMostTags = 60, kLongestValue = 1000, kMostLevels = 1'000;
// The tags of a node are kept only if it has one of these keys.
constexpr std::array<std::string_view, 8> kNodeKeys{"door",    "entrance", "indoor",         "level",
                                                    "highway", "amenity",  "tactile_paving", "information"};

OsmTags tags_of(const osmium::TagList& list) {
    OsmTags tags;
    for (const osmium::Tag& tag : list) {
        if (tags.all.size() >= kMostTags) break;
        std::string value = one_line(std::string_view(tag.value()).substr(0, kLongestValue));
        if (!value.empty()) tags.all.emplace_back(tag.key(), std::move(value));
    }
    return tags;
}

class Collector {
public:
    explicit Collector(OsmData& data) : data_(data) {}

    bool take(const osmium::OSMEntity& entity) {
        if (entity.type() == osmium::item_type::node) return take(static_cast<const osmium::Node&>(entity));
        if (entity.type() == osmium::item_type::way) return take(static_cast<const osmium::Way&>(entity));
        if (entity.type() == osmium::item_type::relation) take(static_cast<const osmium::Relation&>(entity));
        return true;
    }

private:
    bool take(const osmium::Node& node) {
        if (!node.location().valid() || node.deleted()) return true;
        if (data_.nodes.size() >= kMostOsmNodes) return false;
        OsmNode& made = data_.nodes[node.id()];
        made.lon_deg = node.location().lon();
        made.lat_deg = node.location().lat();
        const bool wanted = std::any_of(kNodeKeys.begin(), kNodeKeys.end(),
                                        [&](std::string_view key) { return node.tags().has_key(key.data()); });
        if (!wanted || !made.tags.all.empty()) return true;
        made.tags = tags_of(node.tags());
        if (!made.tags.all.empty()) data_.tagged_nodes.push_back(node.id());
        return true;
    }
    bool take(const osmium::Way& way) {
        if (way.deleted()) return true;
        refs_ += way.nodes().size();
        if (data_.ways.size() >= kMostOsmWays || refs_ > kMostRefs) return false;
        if (!data_.way_number.try_emplace(way.id(), data_.ways.size()).second) return true;
        OsmWay made;
        made.id = way.id();
        for (const osmium::NodeRef& node : way.nodes()) made.nodes.push_back(node.ref());
        made.tags = tags_of(way.tags());
        data_.ways.push_back(std::move(made));
        return true;
    }
    void take(const osmium::Relation& relation) {
        const char* type = relation.tags()["type"];
        if (relation.deleted() || !type) return;
        if (std::string_view(type) == "level") take_level(relation);
        if (std::string_view(type) != "multipolygon") return;
        OsmArea made;
        made.id = relation.id();
        for (const osmium::RelationMember& member : relation.members())
            if (member.type() == osmium::item_type::way && made.ways.size() < 10'000)
                made.ways.emplace_back(member.ref(), std::string_view(member.role()) == "inner");
        made.tags = tags_of(relation.tags());
        data_.areas.push_back(std::move(made));
    }

    void take_level(const osmium::Relation& relation) {
        const char* level = relation.tags()["level"];
        if (!level) return;
        if (data_.levels.size() < kMostLevels) data_.levels.push_back(tags_of(relation.tags()));
        for (const osmium::RelationMember& member : relation.members())
            if (member.type() == osmium::item_type::way && data_.level_of_way.size() < kMostOsmWays)
                data_.level_of_way.try_emplace(member.ref(), one_line(std::string_view(level).substr(0, 100)));
    }

    OsmData& data_;
    std::size_t refs_ = 0;
};

}  // namespace

std::string_view OsmTags::operator[](std::string_view key) const {
    for (const auto& [own, value] : all)
        if (own == key) return value;
    return {};
}

std::string_view OsmData::level_of(const OsmWay& way) const {
    if (way.tags.has("level")) return way.tags["level"];
    const auto listed = level_of_way.find(way.id);
    return listed == level_of_way.end() ? std::string_view() : std::string_view(listed->second);
}

OsmForm osm_form(std::string_view bytes, std::string_view file_name) {
    const std::string name = lower_ascii(file_name);
    if (bytes.starts_with("BZh") && name.ends_with(".osm.bz2")) return OsmForm::XmlBzip2;
    if (bytes.starts_with(std::string_view("\0\0\0", 3)) && bytes.substr(0, 40).find("OSMHeader") < 40)
        return OsmForm::Pbf;
    const std::string_view begin = bytes.substr(0, 2000);
    const bool xml = begin.substr(0, 200).find('<') < 200;
    return xml && (begin.find("<osm ") < 2000 || begin.find("<osm>") < 2000 || name.ends_with(".osm")) ? OsmForm::Xml
                                                                                                       : OsmForm::None;
}

Result<OsmData> read_osm_data(std::string_view bytes, OsmForm form, const std::string& file_name,
                              const std::stop_token& stop) {
    const auto damaged = [&](std::uint64_t line, std::string_view words) {
        return fail(phrase("osm.damaged", {{"words", one_line(words.substr(0, 120))}}), file_name,
                    static_cast<int>(std::min<std::uint64_t>(line, 1'000'000'000)));
    };
    OsmData data;
    try {
        const char* format = form == OsmForm::Pbf ? "pbf" : form == OsmForm::XmlBzip2 ? "osm.bz2" : "osm";
        osmium::thread::Pool pool(1);
        osmium::io::Reader reader(osmium::io::File(bytes.data(), bytes.size(), format), pool);
        Collector collector(data);
        while (const osmium::memory::Buffer buffer = reader.read()) {
            if (stop.stop_requested()) return fail(phrase("files.stopped"), file_name);
            for (const osmium::OSMEntity& entity : buffer.select<osmium::OSMEntity>())
                if (!collector.take(entity)) return fail(phrase("osm.too_large"), file_name);
        }
        reader.close();
    } catch (const osmium::xml_error& error) {
        return damaged(error.line, error.error_string);
    } catch (const std::exception& error) {
        return damaged(0, error.what());
    }
    return data;
}

}  // namespace handrail::osm
