// Puts tags into words: names of spaces and objects, and the facts about them that blind people want to know, in the
// language spoken. Pure functions.
#pragma once

#include <string>
#include <vector>

#include "worlds/osm/osm_data.h"

namespace handrail::osm {

// The value under `key` in the language spoken (key:de), else the plain value.
std::string_view in_spoken(const OsmTags& tags, std::string_view key);
// The kind of a space: the last part of a text's key under osm_kind ("stairs", "toilets_women"), or the tag's own
// value. Empty for a plain room.
std::string kind_of_space(const OsmTags& tags);
// The word for a kind: the text osm_kind.VALUE, else the value itself without underscores.
std::string kind_words(std::string_view kind);
// The spoken name, such as "Foyer E100", "Toilets F03" or "E023"; empty if the tags state none.
std::string name_of_space(const OsmTags& tags);
// One sentence for each fact: tactile paving, handrails, wheelchairs, descriptions, steps.
std::vector<std::string> facts_of(const OsmTags& tags);

// The number at the front of a value: 2.5 of "2.5 m"; 0 if there is none.
double number_in(std::string_view value);
// `is_space`: a room, corridor, staircase or lift that is drawn with an outline. `is_platform`: a platform of a
// railway, a tram or a bus.
bool is_space(const OsmTags& tags);
bool is_platform(const OsmTags& tags);
// Returns true if people walk along it or on it.
bool is_walked(const OsmTags& tags);

}  // namespace handrail::osm
