#include "app/core/dialogue/question.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <utility>
#include <vector>

#include "app/core/dialogue/typed_words.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr std::size_t kLongestQuestion = 200;  // in bytes; a longer line is no question
constexpr std::size_t kLeastForTypo = 6;       // a shorter word must be typed without a mistake

// The meanings that words have in a question. Each has a text in settings/languages, question_word, with bars between
// its words.
enum class Meaning : std::uint8_t {
    HowMany,
    Unit,
    Far,
    Size,
    Open,
    Which,
    What,
    List,
    There,
    Where,
    Find,
    Nearest,
    Go,
    Up,
    Down,
    UpperStorey,
    LowerStorey,
    Above,
    Below,
    Behind,
    Left,
    Right,
    Home,
    Own,
    Person,
    Called,
    Leads,
    Room,
    Door,
    Window,
    Stairs,
    Storey,
    Part,
    Ends,
    Off,
    Following,
    Beacon,
    Warmer,
    Lines,
    Learning,
    Still,
    Small,
};
constexpr std::array<std::string_view, 42> kMeanings{
    "how_many", "unit",   "far",     "size",     "open",   "which", "what",         "list",         "there",
    "where",    "find",   "nearest", "go",       "up",     "down",  "upper_storey", "lower_storey", "above",
    "below",    "behind", "left",    "right",    "home",   "own",   "person",       "called",       "leads",
    "room",     "door",   "window",  "stairs",   "storey", "part",  "ends",         "off",          "following",
    "beacon",   "warmer", "lines",   "learning", "still",  "small"};
using Meanings = std::bitset<kMeanings.size()>;

std::size_t index(Meaning meaning) { return static_cast<std::size_t>(meaning); }

// Returns the words in the form in which they are compared. An s after an apostrophe is left out: "what's" is "what",
// and "child's room" is "child room".
std::vector<std::string> plain(const std::vector<TypedWord>& words) {
    std::vector<std::string> all;
    for (const TypedWord& word : words)
        if (std::string form = word.plain.substr(0, word.plain.size() - (word.has_apostrophe_s ? 1 : 0)); !form.empty())
            all.push_back(std::move(form));
    return all;
}

std::vector<std::string> words_in(std::string_view text) { return plain(typed_words(text)); }

// Returns true if one letter was added, left out or replaced, or two neighbouring letters were exchanged.
bool one_mistake_apart(std::string_view one, std::string_view other) {
    if (one.size() > other.size()) std::swap(one, other);
    if (other.size() - one.size() > 1) return false;
    std::size_t same = 0;
    while (same < one.size() && one[same] == other[same]) ++same;
    const std::string_view rest = one.substr(same), other_rest = other.substr(same);
    if (one.size() < other.size()) return rest == other_rest.substr(1);
    if (rest.empty() || rest.substr(1) == other_rest.substr(1)) return true;
    return rest.size() > 1 && rest[0] == other_rest[1] && rest[1] == other_rest[0] &&
           rest.substr(2) == other_rest.substr(2);
}

// Returns true for the same word, also with another ending of one letter ("obere", "oberes") or with a typing mistake.
bool is_word(const std::string& typed, const std::string& word) {
    if (typed == word) return true;
    const std::size_t shorter = std::min(typed.size(), word.size());
    if (shorter + 1 >= kLeastForTypo && (typed.starts_with(word) || word.starts_with(typed)))
        return std::max(typed.size(), word.size()) == shorter + 1;
    return shorter >= kLeastForTypo && typed[0] == word[0] && one_mistake_apart(typed, word);
}

// Returns true if the words from `at` on are `phrase`.
bool begins(const std::vector<std::string>& words, std::size_t at, const std::vector<std::string>& phrase) {
    if (phrase.empty() || at + phrase.size() > words.size()) return false;
    for (std::size_t i = 0; i < phrase.size(); ++i)
        if (!is_word(words[at + i], phrase[i])) return false;
    return true;
}

// A name of the world at a place in the line.
struct Spotted {
    std::size_t name = 0;
    std::size_t at = 0, size = 0;  // its words
};

// Returns the parts of a text with this key in settings/languages. Each part is a sequence of words.
std::vector<std::vector<std::string>> parts_of(std::string_view key) {
    std::vector<std::vector<std::string>> parts;
    for (const std::vector<TypedWord>& part : typed_parts(phrase("question_word." + std::string(key))))
        parts.push_back(plain(part));
    return parts;
}

// The texts of all meanings in the language spoken.
struct Lexicon {
    std::array<std::vector<std::vector<std::string>>, kMeanings.size()> phrases;
    std::vector<std::vector<std::string>> same;  // pairs of words; the first has the meaning of the second

    Lexicon() : same(parts_of("same")) {
        for (std::size_t m = 0; m < kMeanings.size(); ++m) phrases[m] = parts_of(kMeanings[m]);
    }
    // Returns true if a phrase of any meaning begins at this word.
    bool knows(const std::vector<std::string>& words, std::size_t at) const {
        return std::any_of(phrases.begin(), phrases.end(), [&](const auto& of_meaning) {
            return std::any_of(of_meaning.begin(), of_meaning.end(),
                               [&](const auto& said) { return begins(words, at, said); });
        });
    }
};

// Returns the words of the line. Words that the world may call otherwise are replaced: "fridge" becomes "refrigerator",
// unless a name contains "fridge".
std::vector<std::string> words_of_line(std::string_view line, std::span<const NameInWorld> names,
                                       const Lexicon& lexicon) {
    std::vector<std::string> words = words_in(line);
    const auto is_in_a_name = [&](const std::string& word) {
        return std::any_of(names.begin(), names.end(), [&](const NameInWorld& each) {
            const std::vector<std::string> name = words_in(each.name);
            return std::find(name.begin(), name.end(), word) != name.end();
        });
    };
    for (std::string& word : words)
        for (const std::vector<std::string>& pair : lexicon.same)
            if (pair.size() == 2 && word == pair[0] && !is_in_a_name(word) && is_in_a_name(pair[1])) {
                word = pair[1];
                break;
            }
    return words;
}

// Returns the longest names in the line. Several names are returned if they have the same words, as a room and a thing
// can have.
std::vector<Spotted> spotted_in(const std::vector<std::string>& words, std::span<const NameInWorld> names) {
    std::vector<Spotted> found;
    for (std::size_t n = 0; n < names.size(); ++n) {
        const std::vector<std::string> name = words_in(names[n].name);
        for (std::size_t at = 0; at < words.size(); ++at) {
            if (!begins(words, at, name)) continue;
            if (!found.empty() && found.front().size < name.size()) found.clear();
            if (found.empty() || (found.front().size == name.size() && found.front().at == at))
                found.push_back({n, at, name.size()});
        }
    }
    return found;
}

// Returns the first name that contains a word of the line, if that word has no meaning in a question: "toilet" in
// "Girls' toilet". Other names with the same words are also returned.
std::vector<Spotted> partly_spotted_in(const std::vector<std::string>& words, std::span<const NameInWorld> names,
                                       const Lexicon& lexicon) {
    for (std::size_t at = 0; at < words.size(); ++at) {
        if (lexicon.knows(words, at)) continue;
        for (std::size_t n = 0; n < names.size(); ++n) {
            const std::vector<std::string> name = words_in(names[n].name);
            if (std::none_of(name.begin(), name.end(), [&](const std::string& w) { return is_word(words[at], w); }))
                continue;
            std::vector<Spotted> found;
            for (std::size_t other = n; other < names.size(); ++other)
                if (words_in(names[other].name) == name) found.push_back({other, at, 1});
            return found;
        }
    }
    return {};
}

// Returns true if the room or door is called "Room" or "Door". A question with that word means no certain one.
bool is_called_by_its_kind(const NameInWorld& name, const Lexicon& lexicon) {
    if (name.kind == NamedKind::Thing) return false;
    const std::vector<std::string> words = words_in(name.name);
    const Meaning meaning = name.kind == NamedKind::Room ? Meaning::Room : Meaning::Door;
    const auto& all = lexicon.phrases[index(meaning)];
    return std::find(all.begin(), all.end(), words) != all.end();
}

std::vector<Spotted> names_in(const std::vector<std::string>& words, std::span<const NameInWorld> names,
                              const Lexicon& lexicon) {
    std::vector<Spotted> found = spotted_in(words, names);
    std::erase_if(found, [&](const Spotted& each) { return is_called_by_its_kind(names[each.name], lexicon); });
    return found.empty() ? partly_spotted_in(words, names, lexicon) : found;
}

// The words of a line without the name, as meanings.
struct Understood {
    Meanings meanings;
    std::size_t words = 0, unknown = 0;
    std::optional<std::size_t> room, door, thing;  // names in the line by their kind; indices in the names of the world

    bool has(Meaning meaning) const { return meanings[index(meaning)]; }
};

Understood understood(const std::vector<std::string>& words, const std::vector<Spotted>& names,
                      std::span<const NameInWorld> in_world, const Lexicon& lexicon) {
    Understood all;
    for (const Spotted& spotted : names) {
        const NamedKind kind = in_world[spotted.name].kind;
        std::optional<std::size_t>& of_kind = kind == NamedKind::Room   ? all.room
                                              : kind == NamedKind::Door ? all.door
                                                                        : all.thing;
        if (!of_kind) of_kind = spotted.name;
    }
    const std::size_t name_at = names.empty() ? words.size() : names.front().at;
    const std::size_t name_size = names.empty() ? 0 : names.front().size;
    const auto in_name = [&](std::size_t at) { return at >= name_at && at < name_at + name_size; };
    std::vector<bool> known(words.size(), false);
    std::vector<bool> masked(words.size(), false);
    for (std::size_t at = 0; at < words.size(); ++at) {
        known[at] = in_name(at);
        for (const std::vector<std::string>& said : lexicon.phrases[index(Meaning::Small)])
            if (said.size() > 1 && begins(words, at, said))
                for (std::size_t i = 0; i < said.size(); ++i) masked[at + i] = true;
    }
    for (std::size_t m = 0; m < kMeanings.size(); ++m)
        for (std::size_t at = 0; at < words.size(); ++at) {
            // The words of a phrase such as "right now" have no meaning alone.
            if (masked[at] && m != index(Meaning::Small)) continue;
            // The words of a name have no other meaning. But a name of one word can be a common noun, as "Stairs" is:
            // the person may ask how many there are.
            if (in_name(at) && (name_size > 1 || m < index(Meaning::Room))) continue;
            for (const std::vector<std::string>& said : lexicon.phrases[m]) {
                if (!begins(words, at, said)) continue;
                all.meanings.set(m);
                for (std::size_t i = 0; i < said.size(); ++i) known[at + i] = true;
            }
        }
    all.words = words.size();
    all.unknown = static_cast<std::size_t>(std::count(known.begin(), known.end(), false));
    return all;
}

CommonNoun noun_of(const Understood& line) {
    if (line.has(Meaning::Door)) return CommonNoun::Door;
    if (line.has(Meaning::Window)) return CommonNoun::Window;
    if (line.has(Meaning::Stairs)) return CommonNoun::Stairs;
    if (line.has(Meaning::Storey)) return CommonNoun::Storey;
    if (line.has(Meaning::Room)) return CommonNoun::Room;
    return CommonNoun::None;
}

template <class... Several>
Meanings these(Several... several) {
    Meanings set;
    (set.set(index(several)), ...);
    return set;
}

// Which name a question is about.
enum class About : std::uint8_t { Nothing, Room, Door, Thing, Goal, Place };

// A rule of the grammar. It fits a line that has all meanings of `all`, at least one of `any` unless that is empty, and
// none of `none`. If `whole` is true, the line may have no unknown words.
struct Rule {
    QuestionKind kind;
    About about;
    Meanings all, any = {}, none = {};
    bool whole = false;
};

// The rules. The first that fits a line decides. Rules about a name come first; of a line without a name they are
// skipped, as are those about a kind of name that the line lacks.
const std::vector<Rule>& rules() {
    using enum Meaning;
    using Kind = QuestionKind;
    static const Meanings nouns = these(Room, Door, Window, Stairs, Storey), asks_what = these(What, Which, There);
    static const Meanings end = these(Ends, Off), asks = asks_what | these(Where, Far, HowMany);
    static const std::vector<Rule> all{
        // What guides the person is ended by its kind, even if its goal is named.
        {Kind::EndBeacon, About::Nothing, these(Beacon), end, asks},
        {Kind::EndWarmer, About::Nothing, these(Warmer), end, asks},
        {Kind::EndLines, About::Nothing, these(Lines), end, asks},
        {Kind::EndLearning, About::Nothing, these(Learning, Ends), {}, asks},
        {Kind::EndRoute, About::Nothing, these(Following, Ends), {}, asks},

        {Kind::HowFar, About::Goal, these(Far)},
        {Kind::HowFar, About::Goal, these(Unit), these(HowMany, What), these(Size)},
        {Kind::SizeOf, About::Room, these(Size)},
        {Kind::RoomOf, About::Thing, these(Room), {}, these(Go)},
        {Kind::WhichDoor, About::Door, these(Leads)},
        {Kind::WayTo, About::Goal, these(Go)},
        {Kind::IsOpen, About::Door, these(Open)},
        {Kind::Above, About::Room, these(Above), {}, these(Storey, Where)},
        {Kind::Below, About::Room, these(Below), {}, these(Storey, Where)},
        {Kind::SizeOf, About::Room, these(Leads), {}, these(Door)},
        {Kind::WhatIsIn, About::Room, {}, these(What, List), these(Where)},
        {Kind::WhereIs, About::Place, {}, these(Where, Find, Nearest, There)},
        {Kind::WhereIs, About::Place, {}, {}, {}, true},

        {Kind::Home, About::Nothing, these(Home, Go)},
        {Kind::OwnRoute, About::Nothing, these(Far, Still), {}, nouns},
        {Kind::OwnRoute, About::Nothing, these(Following), asks | these(Own),
         nouns | these(Up, Down, UpperStorey, LowerStorey), true},
        {Kind::OwnBeacon, About::Nothing, these(Beacon), {}, {}, true},
        {Kind::HowFar, About::Nothing, these(Far), nouns},
        {Kind::SizeOf, About::Nothing, these(Size), {}, these(HowMany, Storey)},
        {Kind::SizeOf, About::Nothing, these(Size, Unit)},
        {Kind::Nearest, About::Nothing, these(Nearest), nouns},
        {Kind::HowMany, About::Nothing, these(HowMany), nouns},
        {Kind::OwnStorey, About::Nothing, these(Own), these(UpperStorey, LowerStorey), asks_what | these(Go)},
        {Kind::IsOpen, About::Nothing, these(Door, Open, Leads), {}, asks_what | these(Where)},
        {Kind::WhichDoor, About::Nothing, these(Door), these(Leads, Behind)},
        {Kind::GoUp, About::Nothing, these(Go), these(Up, UpperStorey)},
        {Kind::GoDown, About::Nothing, these(Go), these(Down, LowerStorey)},
        {Kind::WhichDoor, About::Nothing, these(Door, Which), these(Own, Called)},
        {Kind::WhichDoor, About::Nothing, these(Door, What), these(Own, Called)},
        {Kind::IsOpen, About::Nothing, these(Door, Open)},
        {Kind::Above, About::Nothing, these(Above), {}, these(Storey)},
        {Kind::Below, About::Nothing, these(Below), {}, these(Storey)},
        {Kind::StoreyAbove, About::Nothing, these(UpperStorey)},
        {Kind::StoreyBelow, About::Nothing, these(LowerStorey)},
        {Kind::StoreyAbove, About::Nothing, these(Up), asks_what},
        {Kind::GoUp, About::Nothing, these(Up)},
        {Kind::StoreyBelow, About::Nothing, these(Down), asks_what},
        {Kind::GoDown, About::Nothing, these(Down)},
        {Kind::OwnPart, About::Nothing, these(Part), these(Own, Which, What)},
        {Kind::OwnStorey, About::Nothing, these(Storey), these(Own, Which, What)},
        {Kind::Behind, About::Nothing, these(Behind)},
        {Kind::Left, About::Nothing, these(Left)},
        {Kind::Right, About::Nothing, these(Right)},
        {Kind::WhichDoor, About::Nothing, these(Door, Which)},
        {Kind::Nearest, About::Nothing, these(Where), nouns, these(Own)},
        {Kind::Nearest, About::Nothing, these(Find), nouns, these(Own)},
        {Kind::Rooms, About::Nothing, these(Room, List)},
        // Unless the line is about the person, an unknown word can be the name of something that this world lacks.
        {Kind::Here, About::Nothing, these(Where, Person)},
        {Kind::Here, About::Nothing, these(Where, Own), {}, {}, true},
        {Kind::Here, About::Nothing, these(Called)},
        {Kind::Here, About::Nothing, these(Own, Room), these(Which, What)},
        {Kind::Rooms, About::Nothing, these(Room), these(There, Which)},
    };
    return all;
}

// Returns the name in the line that a rule is about. If a room and a thing have the same name, a route leads to the
// room, and a question about the place means the thing.
std::optional<std::size_t> name_for(About about, const Understood& line) {
    switch (about) {
        case About::Room:
            return line.room;
        case About::Door:
            return line.door;
        case About::Thing:
            return line.thing;
        case About::Goal:
            return line.room ? line.room : line.door ? line.door : line.thing;
        case About::Place:
            return line.thing ? line.thing : line.door ? line.door : line.room;
        case About::Nothing:
            break;
    }
    return std::nullopt;
}

bool fits(const Rule& rule, const Understood& line) {
    return (line.meanings & rule.all) == rule.all && (rule.any.none() || (line.meanings & rule.any).any()) &&
           (line.meanings & rule.none).none() && !(rule.whole && line.unknown > 0);
}

}  // namespace

std::optional<Question> question_in(std::string_view line, std::span<const NameInWorld> names) {
    if (line.size() > kLongestQuestion) return std::nullopt;
    const Lexicon lexicon;
    const std::vector<std::string> words = words_of_line(line, names, lexicon);
    if (words.empty()) return std::nullopt;
    const Understood all = understood(words, names_in(words, names, lexicon), names, lexicon);
    if (3 * all.unknown > all.words) return std::nullopt;
    // "How many stairs" and "the nearest window" do not mean the thing of that name.
    const bool of_a_noun = noun_of(all) != CommonNoun::None &&
                           (all.has(Meaning::Nearest) || (all.has(Meaning::HowMany) && !all.has(Meaning::Unit)));
    for (const Rule& rule : rules()) {
        if (!fits(rule, all)) continue;
        if (rule.about == About::Nothing) return Question{rule.kind, {}, noun_of(all)};
        if (const auto name = name_for(rule.about, all); name && !of_a_noun) return Question{rule.kind, name, {}};
    }
    return std::nullopt;
}

std::optional<std::size_t> name_in(std::string_view line, std::span<const NameInWorld> names) {
    if (line.size() > kLongestQuestion) return std::nullopt;
    const Lexicon lexicon;
    const std::vector<Spotted> found = names_in(words_of_line(line, names, lexicon), names, lexicon);
    return found.empty() ? std::nullopt : std::optional(found.front().name);
}

bool has_noun(std::string_view name, CommonNoun noun) {
    constexpr std::array kMeaningOf{Meaning::Small,  Meaning::Room,   Meaning::Door,
                                    Meaning::Window, Meaning::Stairs, Meaning::Storey};
    if (noun == CommonNoun::None) return false;
    const std::vector<std::string> words = words_in(name);
    const std::string_view key = kMeanings[index(kMeaningOf[static_cast<std::size_t>(noun)])];
    for (const std::vector<std::string>& said : parts_of(key))
        for (std::size_t at = 0; at < words.size(); ++at)
            if (begins(words, at, said)) return true;
    return false;
}

std::string_view noun_key(CommonNoun noun) {
    constexpr std::array<std::string_view, 6> kKeys{"none", "room", "door", "window", "stairs", "storey"};
    return kKeys[static_cast<std::size_t>(noun)];
}

}  // namespace handrail::core
