#include "worlds/osm/osm_words.h"

#include <array>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::osm {
namespace {

// A fact that one tag with one value states. `says` is the last part of the key of its text.
struct Fact {
    std::string_view key, value, says;
};
constexpr std::array kFacts{
    Fact{"tactile_paving", "yes", "tactile_paving"},
    Fact{"tactile_paving", "no", "no_tactile_paving"},
    Fact{"wheelchair", "yes", "wheelchair_yes"},
    Fact{"wheelchair", "limited", "wheelchair_limited"},
    Fact{"wheelchair", "no", "wheelchair_no"},
    Fact{"toilets:wheelchair", "yes", "toilets_wheelchair"},
    Fact{"toilets", "yes", "has_toilets"},
    Fact{"changing_table", "yes", "changing_table"},
    Fact{"ramp", "yes", "ramp"},
    Fact{"speech_output", "yes", "speech_output"},
    Fact{"access", "private", "private"},
    Fact{"access", "no", "private"},
    Fact{"kerb", "raised", "kerb_raised"},
    Fact{"kerb", "lowered", "kerb_lowered"},
    Fact{"kerb", "flush", "kerb_flush"},
};

bool any_with(const OsmTags& tags, std::string_view key_begins, std::string_view value) {
    for (const auto& [key, own] : tags.all)
        if (key.starts_with(key_begins) && own == value) return true;
    return false;
}

std::string sentence(std::string text) {
    if (!text.empty() && text.back() != '.' && text.back() != '!' && text.back() != '?') text += '.';
    return capitalised(text);
}

}  // namespace

std::string_view in_spoken(const OsmTags& tags, std::string_view key) {
    const std::string_view own = tags[std::string(key) + ":" + spoken_language()];
    if (!own.empty()) return own;
    if (const std::string_view plain = tags[key]; !plain.empty()) return plain;
    return tags[std::string(key) + ":en"];
}

std::string kind_of_space(const OsmTags& tags) {
    const bool male = tags.is("male", "yes"), female = tags.is("female", "yes");
    const bool toilets = tags.is("amenity", "toilets") || tags.is("room", "toilets") || tags.is("room", "toilet");
    if (toilets) return male == female ? "toilets" : male ? "toilets_men" : "toilets_women";
    if (tags.has("conveying") && !tags.is("conveying", "no")) return "escalator";
    if (tags.is("stairs", "yes") || tags.is("room", "stairs") || tags.is("indoor", "stairs") ||
        tags.is("highway", "steps") ||
        (tags.is("buildingpart", "verticalpassage") && tags.is("buildingpart:verticalpassage", "stairway")))
        return "stairs";
    if (tags.is("highway", "elevator") || tags.is("room", "elevator") || tags.is("indoor", "elevator") ||
        (tags.is("buildingpart", "verticalpassage") && tags.is("buildingpart:verticalpassage", "elevator")))
        return "lift";
    for (const std::string_view key : {"room", "amenity", "shop", "office"})
        if (const std::string_view value = tags[key]; !value.empty() && value != "yes") return std::string(value);
    if (tags.has("shop")) return "shop";
    if (tags.is("indoor", "corridor") || tags.is("buildingpart", "corridor") || tags.is("highway", "corridor"))
        return "corridor";
    return {};
}

std::string kind_words(std::string_view kind) {
    if (const std::string key = "osm_kind." + std::string(kind); has_phrase(key)) return phrase(key);
    std::string words(kind);
    for (char& c : words)
        if (c == '_' || c == ';') c = ' ';
    return words;
}

std::string name_of_space(const OsmTags& tags) {
    std::string ref(tags["ref"]);
    std::string name(in_spoken(tags, "name"));
    if (name.empty()) {
        if (const std::string kind = kind_of_space(tags); !kind.empty()) name = capitalised(kind_words(kind));
        else return ref;
    }
    return ref.empty() || name.find(ref) != std::string::npos ? name : name + " " + ref;
}

std::vector<std::string> facts_of(const OsmTags& tags) {
    std::vector<std::string> facts;
    for (const std::string_view key : {"blind:description", "description"})
        if (const std::string_view words = in_spoken(tags, key); !words.empty())
            facts.push_back(sentence(std::string(words)));
    for (const Fact& fact : kFacts) {
        const bool said = tags.is(fact.key, fact.value) ||
                          (fact.key == "speech_output" && any_with(tags, "speech_output:", fact.value));
        if (said) facts.push_back(phrase("osm_fact." + std::string(fact.says)));
    }
    const bool left = tags.is("handrail:left", "yes"), right = tags.is("handrail:right", "yes"),
               centre = tags.is("handrail:center", "yes");
    if (left && right) facts.push_back(phrase("osm_fact.handrail_both"));
    else if (left) facts.push_back(phrase("osm_fact.handrail_left"));
    else if (right) facts.push_back(phrase("osm_fact.handrail_right"));
    else if (centre) facts.push_back(phrase("osm_fact.handrail_centre"));
    else if (tags.is("handrail", "yes")) facts.push_back(phrase("osm_fact.handrail"));
    else if (tags.is("handrail", "no")) facts.push_back(phrase("osm_fact.no_handrail"));
    if (any_with(tags, "tactile_writing:braille", "yes")) facts.push_back(phrase("osm_fact.braille"));
    if (any_with(tags, "tactile_writing:e", "yes")) facts.push_back(phrase("osm_fact.raised_letters"));
    double steps = 0.0;
    if (parse_finite(tags["step_count"], steps) && steps >= 1.0 && steps < 10'000.0)
        facts.push_back(phrase("osm_fact.steps", {{"n", static_cast<std::int64_t>(steps)}}));
    return facts;
}

double number_in(std::string_view value) {
    double number = 0.0;
    return parse_finite(value.substr(0, value.find_first_not_of("0123456789.")), number) ? number : 0.0;
}

bool is_space(const OsmTags& tags) {
    const std::string_view indoor = tags["indoor"];
    if (indoor == "room" || indoor == "corridor" || indoor == "area" || indoor == "level") return indoor != "level";
    if (tags.is("highway", "elevator") || tags.is("stairs", "yes")) return true;
    if (indoor == "elevator" || indoor == "stairs") return true;
    if (indoor == "yes" && tags.has("room")) return true;
    const std::string_view part = tags["buildingpart"];
    return part == "room" || part == "corridor" || part == "hall" || part == "verticalpassage";
}

bool is_platform(const OsmTags& tags) {
    return tags.is("railway", "platform") || tags.is("highway", "platform") || tags.is("public_transport", "platform");
}

bool is_walked(const OsmTags& tags) {
    const std::string_view highway = tags["highway"];
    if (tags.is("access", "private") || tags.is("access", "no") || tags.is("foot", "no")) return false;
    return highway == "footway" || highway == "steps" || highway == "corridor" || highway == "pedestrian" ||
           highway == "path" || is_platform(tags);
}

}  // namespace handrail::osm
