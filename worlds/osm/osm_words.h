// Puts tags into words in the spoken language: names of spaces and objects, and facts about them that blind people want
// to know. Pure functions.
#pragma once

#include <string>
#include <vector>

#include "worlds/osm/osm_data.h"

namespace handrail::osm {

// Returns the value of `key` in the spoken language (key:de), or else the value of the plain key.
std::string_view in_spoken(const OsmTags& tags, std::string_view key);
// Returns the kind of a space: the last part of a text's key under osm_kind ("stairs", "toilets_women"), or the tag's
// own value if there is no such text. Empty for a plain room.
std::string kind_of_space(const OsmTags& tags);
// Returns the word for a kind: the text osm_kind.VALUE, or else the value itself without underscores.
std::string kind_words(std::string_view kind);
// Returns the spoken name, such as "Foyer E100", "Toilets F03" or "E023". Empty if the tags state none.
std::string name_of_space(const OsmTags& tags);
// Returns one sentence for each fact, about tactile paving, handrails, wheelchair access, descriptions and steps.
std::vector<std::string> facts_of(const OsmTags& tags);

// Returns the number at the front of a value: 2.5 for "2.5 m". Returns 0 if there is none.
double number_in(std::string_view value);
// is_space returns true for a room, corridor, staircase or lift that is drawn with an outline. is_platform returns true
// for a platform of a railway, a tram or a bus.
bool is_space(const OsmTags& tags);
bool is_platform(const OsmTags& tags);
// Returns true if people walk along this way or on this area.
bool is_walked(const OsmTags& tags);

}  // namespace handrail::osm
