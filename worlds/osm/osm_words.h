// What tags say in words: names of spaces and things, and what blind people want to know of them, in the language
// spoken. Pure functions.
#pragma once

#include <string>
#include <vector>

#include "worlds/osm/osm_data.h"

namespace handrail {

// The value under `key` in the language spoken (key:de), else as it is.
std::string_view in_spoken(const OsmTags& tags, std::string_view key);
// "stairs", "toilets_women", ...: the last part of a text's key under osm_kind, or the tag's own value; empty: nothing
// but a room.
std::string kind_of_space(const OsmTags& tags);
// What a value is called: osm_kind.VALUE, else the value itself without underscores.
std::string kind_words(std::string_view kind);
// "Foyer E100", "Toilets F03", "E023"; empty where nothing says it.
std::string name_of_space(const OsmTags& tags);
// A sentence each: tactile paving, handrails, wheelchairs, descriptions, steps.
std::vector<std::string> facts_of(const OsmTags& tags);

// The number at the front of a value: 2.5 of "2.5 m"; 0 if there is none.
double number_in(std::string_view value);
// A platform of a railway, a tram or a bus.
// A room, corridor, staircase or lift that is drawn with an outline.
bool is_space(const OsmTags& tags);
bool is_platform(const OsmTags& tags);
// People walk along it, or on it.
bool is_walked(const OsmTags& tags);

}  // namespace handrail
