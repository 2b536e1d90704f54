#include "worlds/words/word_patterns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/scene/material.h"

namespace handrail::words {
namespace {

constexpr std::size_t kMostWords = 120, kMostNumbers = 4000, kMostOfName = 12;

// A pattern of words. `words` contains:
//   - alternatives ("by|x"),
//   - a question mark after an optional word,
//   - placeholders in braces: a number {n}, a unit {u}, a compass direction {c}, a wall {w} or a corner {k} with its
//     noun, a material {m}, a name {name}.
// `kinds` lists the kinds of sentence in which the pattern may occur: r room, d door or opening, l lift, drop or stairs
// between rooms, w window, t thing, s start, h head of a storey or building.
struct Pattern {
    Statement says;
    std::string_view kinds, words;
};

constexpr Pattern kEnglish[] = {
    {Statement::Size3, "t", "{n} {u}? by|x|times {n} {u}? by|x|times {n} {u}?"},
    {Statement::Size2, "rtl", "{n} {u}? by|x|times {n} {u}?"},
    {Statement::High, "rtwh", "{n} {u}? high|tall"},
    {Statement::Wide, "dwtl", "{n} {u}? wide"},
    {Statement::Thick, "h", "{n} {u}? thick"},
    {Statement::AboveFloor, "twh", "{n} {u}? above|over the? floor|ground"},
    {Statement::SideOf, "r", "{n} {u}? to? the? {c} of {name}"},
    {Statement::SideOf, "r", "to|on? the? {c} of {name}"},
    {Statement::SideOf, "r", "{n} {u}? behind|beyond|before {name}"},
    {Statement::SideOf, "r", "in? behind|beyond|front|before of? {name}"},
    {Statement::Above, "r", "above|over|below|under|underneath {name}"},
    {Statement::Further, "r", "{n} {u}? further|farther|more to? the? {c}"},
    {Statement::Flush, "r", "flush|aligned with|at|to|in? the|its? {c} end|wall|side|edge?"},
    {Statement::Flush, "r", "flush|aligned with|at|to|in? {w}"},
    {Statement::CornerAt, "r", "its|the|south-west|southwest? corner at {n} {u}? {c} and? {n} {u}? {c}"},
    {Statement::At, "dwtsl", "at {n} {u}? {c} and? {n} {u}? {c}"},
    {Statement::Offset, "ts", "{n} {u}? {c} and? {n} {u}? {c}"},
    {Statement::CornerList, "r", "with? corners|corner at|are?"},
    {Statement::Hole, "r", "with? a? hole|courtyard at?"},
    {Statement::FromWall, "dwts", "and? {n} {u}? from|off {w}"},
    {Statement::Along, "dwts", "{n} {u}? along|down|on {w}"},
    {Statement::Along, "dwts", "{n} {u}? along"},
    {Statement::MiddleOf, "dwts", "in|at the? middle|centre|center of {w}"},
    {Statement::Middle, "dwts", "in|at the? middle|centre|center"},
    {Statement::InCorner, "ts", "in|at|into {k}"},
    {Statement::InWall, "dwts", "in|on|at|along|against|by {w}"},
    {Statement::ByWindow, "ts", "by|at|under|below|beside|near|in|before the|its? window"},
    {Statement::ByDoor, "ts", "by|at|beside|near|next to? the|its? door to the? {name}"},
    {Statement::ByDoor, "ts", "by|at|beside|near|next to? the|its? door"},
    {Statement::NextTo, "ts", "next to {name}"},
    {Statement::NextTo, "ts", "beside|near|by {name}"},
    {Statement::Outside, "d", "to? the? outside|outdoors|street"},
    {Statement::To, "dl", "to|into {name}"},
    {Statement::DropOf, "l", "of {n} {u}?"},
    {Statement::FromRoom, "l", "from {name}"},
    {Statement::UpSide, "l", "up to? the? {c}"},
    {Statement::UpAndBack, "l", "up to? the? {c} and? back"},
    {Statement::Railing, "r", "with? a? railing|balustrade|parapet|banister of? {n} {u}? high|tall?"},
    {Statement::Railing, "r", "with? a? {n} {u}? high|tall? railing|balustrade|parapet|banister"},
    {Statement::Raised, "r", "raised by {n} {u}?"},
    {Statement::Sunk, "r", "sunk|lowered by {n} {u}?"},
    {Statement::Stairs, "r", "stairs|staircase|steps up? to {name}"},
    {Statement::Lift, "r", "lift|elevator up? to {name}"},
    {Statement::UpTo, "r", "up to {name}"},
    {Statement::Landmark, "tw", "a? landmark"},
    {Statement::Clue, "tw", "a? clue"},
    {Statement::Called, "dwtsl", "called|named {name}"},
    {Statement::Floor, "r", "a? {m} floor"},
    {Statement::Floor, "r", "with? a? floor is|of {m}"},
    {Statement::MadeOf, "t", "made? of {m}"},
    {Statement::Walls, "h", "made? of {m}"},
    {Statement::Facing, "s", "facing|looking {c}"},
    {Statement::ByItself, "d", "opens|opening by itself"},
    {Statement::ByItself, "d", "automatic"},
    {Statement::In, "s", "in|here {name}"},
};

constexpr Pattern kGerman[] = {
    {Statement::Size3, "t", "{n} {u}? mal|x|auf {n} {u}? mal|x|auf {n} {u}?"},
    {Statement::Size2, "rtl", "{n} {u}? mal|x|auf {n} {u}?"},
    {Statement::High, "rtwh", "{n} {u}? hoch|hohe|hoher|hohes"},
    {Statement::Wide, "dwtl", "{n} {u}? breit|breite|breiter|breites"},
    {Statement::Thick, "h", "{n} {u}? dick|stark"},
    {Statement::AboveFloor, "twh", "{n} {u}? über|ueber dem? boden|fußboden|fussboden|grund|erdboden"},
    {Statement::SideOf, "r", "{n} {u}? {c} von|vom|der|des|zu {name}"},
    {Statement::SideOf, "r", "im? {c} von|vom|der|des|zu {name}"},
    {Statement::SideOf, "r", "links|rechts von|vom|der|neben? {name}"},
    {Statement::SideOf, "r", "{n} {u}? hinter|vor {name}"},
    {Statement::SideOf, "r", "hinter|vor {name}"},
    {Statement::Above, "r", "über|ueber|oberhalb|unter|unterhalb von|vom? {name}"},
    {Statement::Further, "r", "{n} {u}? weiter|versetzt nach|im? {c}"},
    {Statement::Flush, "r", "bündig|buendig am|mit|an|im? der|dem? {c} ende|wand|seite|rand?"},
    {Statement::Flush, "r", "bündig|buendig am|mit|an|im? {w}"},
    {Statement::CornerAt, "r", "südwestecke|suedwestecke|ecke bei|an {n} {u}? nach? {c} und? {n} {u}? nach? {c}"},
    {Statement::At, "dwtsl", "bei|an {n} {u}? nach? {c} und? {n} {u}? nach? {c}"},
    {Statement::Offset, "ts", "{n} {u}? nach? {c} und? {n} {u}? nach? {c}"},
    {Statement::CornerList, "r", "mit? ecken|ecke bei|an?"},
    {Statement::Hole, "r", "mit? loch|aussparung|innenhof bei|an?"},
    {Statement::FromWall, "dwts", "und? {n} {u}? von|vom|ab|aus {w}"},
    {Statement::Along, "dwts", "{n} {u}? entlang|an|längs|laengs|auf {w}"},
    {Statement::Along, "dwts", "{n} {u}? entlang"},
    {Statement::MiddleOf, "dwts", "in der? mitte von? {w}"},
    {Statement::MiddleOf, "dwts", "mitten in|an {w}"},
    {Statement::Middle, "dwts", "in der? mitte"},
    {Statement::InCorner, "ts", "in|an {k}"},
    {Statement::InWall, "dwts", "in|an|bei|entlang|auf {w}"},
    {Statement::ByWindow, "ts", "am|beim|unter|an|neben|vor|im dem|das? fenster"},
    {Statement::ByDoor, "ts", "neben|an|bei|hinter der? tür|tuer zu|zum|zur|nach|in|ins {name}"},
    {Statement::ByDoor, "ts", "neben|an|bei|hinter der? tür|tuer"},
    {Statement::NextTo, "ts", "neben|bei|beim|am {name}"},
    {Statement::Outside, "d", "nach|ins draußen|draussen|außen|aussen|freie"},
    {Statement::To, "dl", "zu|zum|zur|nach|in|ins {name}"},
    {Statement::DropOf, "l", "von {n} {u}?"},
    {Statement::FromRoom, "l", "von|vom {name}"},
    {Statement::UpSide, "l", "hinauf nach {c}"},
    {Statement::UpAndBack, "l", "hinauf nach {c} und? zurück|zurueck"},
    {Statement::Railing, "r", "mit? einem|einer? geländer|gelaender|brüstung|bruestung von? {n} {u}? hoch|höhe?"},
    {Statement::Railing, "r",
     "mit? einem|einer? {n} {u}? hohes|hohen|hohem|hoher|hohe? geländer|gelaender|brüstung|bruestung"},
    {Statement::Raised, "r", "um? {n} {u}? erhöht|erhoeht|höher|hoeher"},
    {Statement::Sunk, "r", "um? {n} {u}? vertieft|tiefer"},
    {Statement::Stairs, "r", "treppe|stufen hinauf? zu|zum|zur|nach|in|ins {name}"},
    {Statement::Lift, "r", "aufzug|fahrstuhl|lift hinauf? zu|zum|zur|nach|in|ins {name}"},
    {Statement::UpTo, "r", "hinauf|hoch zu|zum|zur|nach|in|ins|bis {name}"},
    {Statement::Landmark, "tw", "eine? landmarke|wegmarke|merkmal|orientierungspunkt"},
    {Statement::Clue, "tw", "ein? hinweis"},
    {Statement::Called, "dwtsl", "genannt|namens|heißt|heisst {name}"},
    {Statement::Floor, "r", "mit? boden|fußboden|fussboden aus {m}"},
    {Statement::MadeOf, "t", "aus {m}"},
    {Statement::Walls, "h", "aus {m}"},
    {Statement::Facing, "s", "mit? blick|blickrichtung|schaut nach|richtung? {c}"},
    {Statement::ByItself, "d", "öffnet|oeffnet sich|von? selbst"},
    {Statement::ByItself, "d", "automatisch|selbsttätig"},
    {Statement::In, "s", "in|im|hier {name}"},
};

struct KindWord {
    std::string_view word;
    SentenceKind kind;
};
// Words that begin a sentence and determine its kind. The words in kColons do so only if a colon follows.
constexpr KindWord kEnglishHeads[] = {
    {"door", SentenceKind::Door},           {"sliding door", SentenceKind::SlidingDoor},
    {"automatic door", SentenceKind::Door}, {"opening", SentenceKind::Opening},
    {"open", SentenceKind::Opening},        {"doorway", SentenceKind::Opening},
    {"passage", SentenceKind::Opening},     {"window", SentenceKind::Window},
    {"lift from", SentenceKind::Lift},      {"elevator from", SentenceKind::Lift},
    {"drop of", SentenceKind::Drop},        {"drop from", SentenceKind::Drop},
    {"stairs from", SentenceKind::Flight},  {"staircase from", SentenceKind::Flight},
    {"start", SentenceKind::Start}};
constexpr KindWord kGermanHeads[] = {{"tür", SentenceKind::Door},
                                     {"tuer", SentenceKind::Door},
                                     {"schiebetür", SentenceKind::SlidingDoor},
                                     {"automatische tür", SentenceKind::Door},
                                     {"öffnung", SentenceKind::Opening},
                                     {"oeffnung", SentenceKind::Opening},
                                     {"offen", SentenceKind::Opening},
                                     {"durchgang", SentenceKind::Opening},
                                     {"fenster", SentenceKind::Window},
                                     {"aufzug von", SentenceKind::Lift},
                                     {"fahrstuhl von", SentenceKind::Lift},
                                     {"lift von", SentenceKind::Lift},
                                     {"kante von", SentenceKind::Drop},
                                     {"treppe von", SentenceKind::Flight},
                                     {"treppe vom", SentenceKind::Flight},
                                     {"start", SentenceKind::Start}};
constexpr KindWord kColons[] = {
    {"room", SentenceKind::Room},         {"raum", SentenceKind::Room},        {"zimmer", SentenceKind::Room},
    {"thing", SentenceKind::Thing},       {"ding", SentenceKind::Thing},       {"gegenstand", SentenceKind::Thing},
    {"building", SentenceKind::Building}, {"world", SentenceKind::Building},   {"gebäude", SentenceKind::Building},
    {"gebaeude", SentenceKind::Building}, {"welt", SentenceKind::Building},    {"storey", SentenceKind::Storey},
    {"story", SentenceKind::Storey},      {"level", SentenceKind::Storey},     {"floor", SentenceKind::Storey},
    {"stockwerk", SentenceKind::Storey},  {"geschoss", SentenceKind::Storey},  {"geschoß", SentenceKind::Storey},
    {"etage", SentenceKind::Storey},      {"step", SentenceKind::Step},        {"schritt", SentenceKind::Step},
    {"walls", SentenceKind::Walls},       {"wände", SentenceKind::Walls},      {"waende", SentenceKind::Walls},
    {"language", SentenceKind::Language}, {"sprache", SentenceKind::Language}, {"fixture", SentenceKind::Thing},
    {"einbau", SentenceKind::Thing},
};

constexpr std::string_view kEnglishArticles[] = {"the", "a", "an", "its", "his", "our", "my"};
constexpr std::string_view kGermanArticles[] = {"der", "die",  "das",   "dem",    "den",   "des",
                                                "ein", "eine", "einen", "seiner", "ihrer", "einem"};
// Words without a meaning for the description, which are ignored.
constexpr std::string_view kNoise[] = {"and", "with", "is",   "are",   "lies",   "stands", "there", "und",
                                       "mit", "ist",  "sind", "liegt", "steht",  "hier",   "here",  "it",
                                       "es",  "room", "raum", "raums", "raumes", "also",   "auch",  "from",
                                       "von", "at",   "bei",  "in",    "to",     "nach"};

std::span<const Pattern> patterns_of(WordLanguage language) {
    return language == WordLanguage::German ? std::span<const Pattern>(kGerman) : std::span<const Pattern>(kEnglish);
}
std::span<const KindWord> heads_of(WordLanguage language) {
    return language == WordLanguage::German ? std::span<const KindWord>(kGermanHeads)
                                            : std::span<const KindWord>(kEnglishHeads);
}
std::span<const std::string_view> articles_of(WordLanguage language) {
    return language == WordLanguage::German ? std::span<const std::string_view>(kGermanArticles)
                                            : std::span<const std::string_view>(kEnglishArticles);
}

template <class Range, class Value>
bool has(const Range& range, const Value& value) {
    return std::find(std::begin(range), std::end(range), value) != std::end(range);
}

// Returns the index of a compass direction: "north", "northern", "nördlichen" and "Nord" give 0. Returns -1 for any
// other word.
int side_of(std::string_view word) {
    static const std::map<std::string, int, std::less<>> kSides = [] {
        std::map<std::string, int, std::less<>> sides;
        constexpr std::array<std::string_view, 4> kEnglishSides{"north", "east", "south", "west"},
            kGermanSides{"nord", "ost", "süd", "west"}, kPlain{"nord", "ost", "sued", "west"};
        const auto add = [&](const std::string& name, int side) { sides.emplace(name, side); };
        const auto add_german = [&](const std::string& stem, const std::string& soft, int side) {
            for (const char* end : {"", "en"}) add(stem + end, side);
            for (const char* end : {"lich", "liche", "lichen", "licher", "liches", "lichem"}) add(soft + end, side);
        };
        const auto softened = [](std::string stem) {  // forms with umlauts: nördlich, östlich
            if (const std::size_t o = stem.rfind('o'); o != std::string::npos) stem.replace(o, 1, "ö");
            return stem;
        };
        for (int i = 0; i < 4; ++i) {
            const auto n = static_cast<std::size_t>(i);
            const std::string english(kEnglishSides[n]);
            for (const char* end : {"", "ern", "wards", "ward"}) add(english + end, 2 * i);
            for (const auto& names : {kGermanSides, kPlain}) {
                const std::string german(names[n]);
                add_german(german, softened(german), 2 * i);
                add_german(german, german, 2 * i);
            }
        }
        for (const int main : {0, 2})
            for (const int other : {1, 3}) {
                const int side = main == 0 ? (other == 1 ? 1 : 7) : (other == 1 ? 3 : 5);
                const auto m = static_cast<std::size_t>(main), o = static_cast<std::size_t>(other);
                for (const char* between : {"", "-"}) {
                    for (const char* end : {"", "ern"})
                        add(std::string(kEnglishSides[m]) + between + std::string(kEnglishSides[o]) + end, side);
                    for (const auto& names : {kGermanSides, kPlain}) {
                        const std::string german = std::string(names[m]) + between + std::string(names[o]);
                        add_german(german, std::string(names[m]) + between + softened(std::string(names[o])), side);
                        add_german(german, german, side);
                    }
                }
            }
        for (const char* seen : {"left", "linke", "linken", "linker", "left-hand", "links"}) add(seen, kLeftSide);
        for (const char* seen : {"right", "rechte", "rechten", "rechter", "right-hand", "rechts"})
            add(seen, kRightSide);
        for (const char* seen : {"front", "vordere", "vorderen", "vorderer"}) add(seen, kFrontSide);
        for (const char* seen : {"back", "rear", "far", "hintere", "hinteren", "hinterer"}) add(seen, kBackSide);
        return sides;
    }();
    const auto found = kSides.find(word);
    return found == kSides.end() ? -1 : found->second;
}

// Returns the index of the direction in a German compound such as "Nordwand" or "Nordwestecke"; -1 if the word is none.
int compound_side(std::string_view word, bool corner) {
    static constexpr std::string_view kWalls[] = {"wand", "seite", "ende", "endes", "mauer"}, kCorners[] = {"ecke"};
    const auto nouns = corner ? std::span<const std::string_view>(kCorners) : std::span<const std::string_view>(kWalls);
    for (const std::string_view noun : nouns) {
        if (!word.ends_with(noun) || word.size() == noun.size()) continue;
        std::string_view stem = word.substr(0, word.size() - noun.size());
        if (stem.ends_with('-')) stem.remove_suffix(1);
        if (const int side = side_of(stem); side >= 0) return side;
    }
    return -1;
}

// Returns the length of a unit in metres; 0 if the word is not a unit.
double unit_m(std::string_view word, double step_m) {
    static constexpr std::string_view kMetres[] = {"metre", "metres", "meter", "meters", "metern", "m"},
                                      kCentimetres[] = {"cm",          "centimetre", "centimetres", "centimeter",
                                                        "centimeters", "zentimeter", "zentimetern"},
                                      kSteps[] = {"step", "steps", "pace", "paces", "schritt", "schritte", "schritten"},
                                      kFeet[] = {"foot", "feet", "ft", "fuß", "fuss"};
    if (has(kMetres, word)) return 1.0;
    if (has(kCentimetres, word)) return 0.01;
    if (has(kSteps, word)) return step_m;
    return has(kFeet, word) ? 0.3048 : 0.0;
}
bool is_step(std::string_view word) { return unit_m(word, 2.0) == 2.0; }

std::optional<double> number_word(std::string_view word) {
    static constexpr std::array<std::string_view, 13> kEnglishNumbers{
        "half", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"};
    static constexpr std::array<std::string_view, 13> kGermanNumbers{
        "halben", "eins", "zwei", "drei", "vier", "fünf", "sechs", "sieben", "acht", "neun", "zehn", "elf", "zwölf"};
    for (std::size_t i = 0; i < kEnglishNumbers.size(); ++i)
        if (word == kEnglishNumbers[i] || word == kGermanNumbers[i] || (i == 1 && word == "einen"))
            return i == 0 ? 0.5 : static_cast<double>(i);
    return std::nullopt;
}

// True for kinds of sentence about a connection from one room to another, in which the sentence may name the first
// room.
bool is_from_room(SentenceKind kind) {
    return kind == SentenceKind::Lift || kind == SentenceKind::Drop || kind == SentenceKind::Flight;
}

class Matcher {
public:
    Matcher(const WordSentence& sentence, const SpeakersOf& speaker, SentenceKind kind)
        : tokens_(sentence.tokens), speaker_(speaker) {
        kind_ = kind == SentenceKind::Room     ? 'r'
                : kind == SentenceKind::Window ? 'w'
                : kind == SentenceKind::Start  ? 's'
                : kind == SentenceKind::Thing  ? 't'
                : is_from_room(kind)           ? 'l'
                : kind == SentenceKind::Door || kind == SentenceKind::SlidingDoor || kind == SentenceKind::Opening
                    ? 'd'
                    : 'h';
    }

    // Returns the longest pattern that matches at this position, with the position after it.
    std::optional<std::pair<SaidPart, std::size_t>> at(std::size_t place, bool within_name = false) {
        std::optional<std::pair<SaidPart, std::size_t>> best;
        for (const Pattern& pattern : patterns_of(speaker_.language)) {
            if (pattern.kinds.find(kind_) == std::string_view::npos) continue;
            SaidPart part;
            part.says = pattern.says;
            std::size_t end = place;
            if (!match(pattern.words, end, part, within_name) || end == place) continue;
            if (!best || end > best->second) best.emplace(std::move(part), end);
        }
        return best;
    }
    bool in_steps() const { return in_steps_; }

private:
    const WordToken* token(std::size_t at) const { return at < tokens_.size() ? &tokens_[at] : nullptr; }

    bool match(std::string_view pattern, std::size_t& at, SaidPart& part, bool within_name) {
        bool steps = false;
        std::vector<std::size_t> without_unit;  // numbers to which the next unit in the text also applies
        while (!pattern.empty()) {
            std::string_view item = pattern.substr(0, pattern.find(' '));
            pattern.remove_prefix(std::min(item.size() + 1, pattern.size()));
            const bool may_miss = item.ends_with('?');
            if (may_miss) item.remove_suffix(1);
            const WordToken* now = token(at);
            bool fits = false;
            if (item == "{u}") {
                const double unit =
                    now && now->kind == WordToken::Kind::Word ? unit_m(now->folded, speaker_.step_m) : 0.0;
                if (unit > 0.0) {
                    steps |= is_step(now->folded);
                    for (const std::size_t n : without_unit) part.numbers[n] *= unit;
                    without_unit.clear();
                    ++at;
                    fits = true;
                }
            } else if (item == "{n}") {
                fits = number(at, part);
                if (fits) without_unit.push_back(part.numbers.size() - 1);
            } else if (item == "{c}") {
                const int side = now && now->kind == WordToken::Kind::Word ? side_of(now->folded) : -1;
                fits = side >= 0;
                if (fits) part.sides.push_back(side), ++at;
            } else if (item == "{w}" || item == "{k}") {
                fits = side_with_noun(at, part, item == "{k}");
            } else if (item == "{m}") {
                fits = material(at, part);
            } else if (item == "{name}") {
                fits = name(at, part, within_name);
            } else if (now && now->kind == WordToken::Kind::Word) {
                fits = one_of(item, now->folded);
                if (fits) side_word(now->folded, part), ++at;
            }
            if (!fits && !may_miss) return false;
        }
        if (part.says == Statement::CornerList || part.says == Statement::Hole) return corners(at, part);
        in_steps_ |= steps && !within_name;
        return true;
    }

    static bool one_of(std::string_view alternatives, std::string_view word) {
        while (!alternatives.empty()) {
            const std::string_view one = alternatives.substr(0, alternatives.find('|'));
            if (one == word) return true;
            alternatives.remove_prefix(std::min(one.size() + 1, alternatives.size()));
        }
        return false;
    }

    // Reads the direction from words such as "behind" and "links", which belong to a pattern and are a direction at the
    // same time.
    static void side_word(std::string_view word, SaidPart& part) {
        if (part.says == Statement::SideOf && part.sides.empty()) {
            if (word == "behind" || word == "beyond" || word == "hinter") part.sides.push_back(kBackSide);
            if (word == "front" || word == "before" || word == "vor") part.sides.push_back(kFrontSide);
            if (word == "links") part.sides.push_back(kLeftSide);
            if (word == "rechts") part.sides.push_back(kRightSide);
        }
    }

    bool number(std::size_t& at, SaidPart& part) const {
        const WordToken* now = token(at);
        if (!now) return false;
        if (now->kind == WordToken::Kind::Number) {
            part.numbers.push_back(now->number);
        } else if (const auto value = now->kind == WordToken::Kind::Word ? number_word(now->folded) : std::nullopt) {
            part.numbers.push_back(*value);
        } else {
            return false;
        }
        ++at;
        return true;
    }

    bool article(std::size_t at) const {
        const WordToken* now = token(at);
        return now && now->kind == WordToken::Kind::Word && has(articles_of(speaker_.language), now->folded);
    }

    bool side_with_noun(std::size_t& at, SaidPart& part, bool corner) const {
        static constexpr std::string_view kWalls[] = {"wall", "end",   "side",  "wand", "seite",
                                                      "ende", "endes", "mauer", "edge"},
                                          kCorners[] = {"corner", "ecke"};
        std::size_t here = at;
        if (article(here)) ++here;
        const WordToken *now = token(here), *next = token(here + 1);
        if (!now || now->kind != WordToken::Kind::Word) return false;
        if (const int side = compound_side(now->folded, corner); side >= 0) {
            part.sides.push_back(side);
            at = here + 1;
            return true;
        }
        const int side = side_of(now->folded);
        if (side < 0 || !next || next->kind != WordToken::Kind::Word) return false;
        if (!(corner ? has(kCorners, next->folded) : has(kWalls, next->folded))) return false;
        part.sides.push_back(side);
        at = here + 2;
        return true;
    }

    bool material(std::size_t& at, SaidPart& part) const {
        for (const std::size_t words : {2, 1}) {
            std::string text;
            for (std::size_t i = at; i < at + words && token(i); ++i)
                text += (text.empty() ? "" : " ") + token(i)->folded;
            if (std::string found = material_of_word(text); !found.empty() && at + words <= tokens_.size()) {
                part.name = std::move(found);
                at += words;
                return true;
            }
        }
        return false;
    }

    // Reads a name: the longest known name that matches. Without a known name, reads up to a comma or to the beginning
    // of a pattern.
    bool name(std::size_t& at, SaidPart& part, bool within_name) {
        if (const WordToken* now = token(at); now && now->kind == WordToken::Kind::Name) {
            part.name = now->text;
            ++at;
            return !part.name.empty();
        }
        // After "called" follows a new name. It may begin like the name of a room, so known names are tried only for
        // other patterns.
        const bool own = part.says == Statement::Called;
        if (!own && known_name(at, part)) return true;
        std::size_t here = at;
        if (article(here) && token(here + 1) && token(here + 1)->kind != WordToken::Kind::Comma) {
            ++here;
            if (const WordToken* now = token(here); now->kind == WordToken::Kind::Name) {
                part.name = now->text;
                at = here + 1;
                return !part.name.empty();
            }
            if (!own && known_name(here, part)) {
                at = here;
                return true;
            }
        }
        std::string text;
        std::size_t end = here;
        for (; end < std::min(tokens_.size(), here + kMostOfName); ++end) {
            const WordToken& now = tokens_[end];
            if (now.kind != WordToken::Kind::Word && now.kind != WordToken::Kind::Number) break;
            if (!within_name && end > here && this->at(end, true)) break;
            text += (text.empty() ? "" : " ") + now.text;
        }
        if (text.empty()) return false;
        part.name = text;
        at = end;
        return true;
    }

    // Returns the known name in the nominative for a German declined form: "des großen Saals" stands for "Großer Saal".
    // Empty if no known name matches.
    std::string nominative(const std::string& key) const {
        constexpr std::size_t kMostDeclined = 3;
        constexpr std::array<std::string_view, 8> kNounEnds{"", "s", "es", "ses", "n", "en", "ns", "ens"};
        constexpr std::array<std::string_view, 4> kEnds{"en", "er", "em", "es"}, kNominatives{"er", "es", "e", "en"};
        std::vector<std::string> made{""};
        std::size_t words = 0;
        for (std::size_t from = 0; from <= key.size() && words < kMostDeclined; ++words) {
            const std::size_t end = std::min(key.find(' ', from), key.size());
            const std::string word = key.substr(from, end - from);
            std::vector<std::string> forms{word};
            if (end == key.size())
                for (const std::string_view cut : kNounEnds)
                    if (!cut.empty() && word.size() > cut.size() + 2 && word.ends_with(cut))
                        forms.push_back(word.substr(0, word.size() - cut.size()));
            if (end < key.size())
                for (const std::string_view cut : kEnds)
                    if (word.size() > cut.size() + 2 && word.ends_with(cut))
                        for (const std::string_view put : kNominatives)
                            forms.push_back(word.substr(0, word.size() - cut.size()) + std::string(put));
            std::vector<std::string> longer;
            for (const std::string& begin : made)
                for (const std::string& form : forms) {
                    std::string& name = longer.emplace_back(begin);
                    if (!begin.empty()) name += ' ';
                    name += form;
                }
            made = std::move(longer);
            if (end == key.size()) {
                for (const std::string& name : made)
                    if (speaker_.names.contains(name)) return name;
                return {};
            }
            from = end + 1;
        }
        return {};
    }

    bool known_name(std::size_t& at, SaidPart& part) const {
        std::string text, key;
        std::size_t known_end = at;
        for (std::size_t i = at; i < std::min(tokens_.size(), at + kMostOfName); ++i) {
            const WordToken& now = tokens_[i];
            if (now.kind != WordToken::Kind::Word && now.kind != WordToken::Kind::Number) break;
            text += (text.empty() ? "" : " ") + now.text;
            key += (key.empty() ? "" : " ") + now.folded;
            const bool exact = speaker_.names.contains(key);
            std::string declined =
                exact || speaker_.language == WordLanguage::English ? std::string() : nominative(key);
            if (!exact && declined.empty()) continue;
            part.name = exact ? text : std::move(declined);
            known_end = i + 1;
        }
        if (known_end == at) return false;
        at = known_end;
        return true;
    }

    // Reads pairs of numbers. Commas, units and words for east and north may be between them.
    bool corners(std::size_t& at, SaidPart& part) {
        double unit = 1.0;
        bool steps = false;
        std::size_t end = at;
        for (std::size_t i = at; i < tokens_.size() && part.numbers.size() < kMostNumbers; ++i) {
            const WordToken& now = tokens_[i];
            if (now.kind == WordToken::Kind::Number) {
                part.numbers.push_back(now.number);
                end = i + 1;
            } else if (now.kind == WordToken::Kind::Word) {
                const int side = side_of(now.folded);
                if (const double found = unit_m(now.folded, speaker_.step_m); found > 0.0) {
                    unit = found;
                    steps = is_step(now.folded);
                    end = i + 1;
                } else if ((side == 4 || side == 6) && !part.numbers.empty()) {
                    part.numbers.back() = -part.numbers.back();
                    end = i + 1;
                } else if (side == 0 || side == 2) {
                    end = i + 1;
                } else if (now.folded != "and" && now.folded != "und") {
                    break;
                }
            } else if (now.kind != WordToken::Kind::Comma) {
                break;
            }
        }
        if (part.numbers.size() < 6) return false;
        for (double& number : part.numbers) number *= unit;
        in_steps_ |= steps;
        at = end;
        return true;
    }

    std::span<const WordToken> tokens_;
    const SpeakersOf& speaker_;
    char kind_ = 't';
    bool in_steps_ = false;
};

std::string joined(std::span<const WordToken> tokens) {
    std::string text;
    for (const WordToken& token : tokens)
        if (token.kind != WordToken::Kind::Comma && token.kind != WordToken::Kind::Colon)
            text += (text.empty() ? "" : " ") + token.text;
    return text;
}

}  // namespace

const SaidPart* SaidSentence::find(Statement says) const {
    for (const SaidPart& part : parts)
        if (part.says == says) return &part;
    return nullptr;
}

WordLanguage language_of(std::span<const WordSentence> sentences) {
    static constexpr std::string_view kEnglishWords[] = {
        "the",  "by",       "of",   "to",    "door",  "window", "metres", "metre", "steps", "along", "high",
        "wall", "building", "room", "north", "south", "east",   "storey", "with",  "at",    "wide"};
    static constexpr std::string_view kGermanWords[] = {
        "der",     "die",     "das",       "mal",  "von",      "zu",    "zum",    "zur",      "tür",
        "tuer",    "fenster", "meter",     "hoch", "schritte", "wand",  "raum",   "nördlich", "südlich",
        "östlich", "und",     "stockwerk", "mit",  "bei",      "breit", "gebäude"};
    int english = 0, german = 0;
    for (const WordSentence& sentence : sentences) {
        const std::vector<WordToken>& tokens = sentence.tokens;
        if (tokens.size() > 2 && tokens[1].kind == WordToken::Kind::Colon &&
            (tokens[0].folded == "language" || tokens[0].folded == "sprache"))
            return tokens[2].folded == "german" || tokens[2].folded == "deutsch" || tokens[2].folded == "de"
                       ? WordLanguage::German
                       : WordLanguage::English;
        for (const WordToken& token : tokens) {
            if (token.kind != WordToken::Kind::Word) continue;
            english += has(kEnglishWords, token.folded) ? 1 : 0;
            german += has(kGermanWords, token.folded) ? 1 : 0;
        }
    }
    return german > english ? WordLanguage::German : WordLanguage::English;
}

namespace {

// Determines the kind of the sentence from its first words, and returns the position after these words.
std::size_t kind_of(const WordSentence& sentence, WordLanguage language, SaidSentence& said) {
    const std::vector<WordToken>& tokens = sentence.tokens;
    if (tokens.size() > 1 && tokens[1].kind == WordToken::Kind::Colon)
        for (const KindWord& head : kColons)
            if (tokens[0].kind == WordToken::Kind::Word && tokens[0].folded == head.word) {
                said.kind = head.kind;
                said.explicit_kind = true;
                said.fixture = head.word == "fixture" || head.word == "einbau";
                return 2;
            }
    std::size_t from = 0;
    while (from + 1 < tokens.size() && tokens[from + 1].kind == WordToken::Kind::Word &&
           has(articles_of(language), tokens[from].folded))
        ++from;
    for (const std::size_t words : {2, 1}) {
        if (from + words > tokens.size()) continue;
        std::string text;
        bool plain = true;
        for (std::size_t i = from; i < from + words; ++i) {
            text += (text.empty() ? "" : " ") + tokens[i].folded;
            plain &= tokens[i].kind == WordToken::Kind::Word;
        }
        for (const KindWord& head : heads_of(language))
            if (plain && text == head.word) {
                said.kind = head.kind;
                if (text.starts_with("automat")) said.parts.push_back({Statement::ByItself, {}, {}, {}});
                // Skips only the first word of such a beginning, because "from" or "of" already belongs to the
                // description.
                return is_from_room(said.kind) ? from + 1 : from + words;
            }
    }
    return from;
}

// Returns the patterns that match in a sentence if it is read as a sentence of the kind `kind`.
std::set<Statement> said_as(const WordSentence& sentence, const SpeakersOf& speaker, SentenceKind kind,
                            std::size_t from) {
    std::set<Statement> says;
    Matcher matcher(sentence, speaker, kind);
    for (std::size_t i = from; i < std::min(sentence.tokens.size(), kMostWords); ++i)
        if (const auto part = matcher.at(i)) {
            says.insert(part->first.says);
            i = part->second - 1;
        }
    return says;
}

// Determines from the content of the sentence whether it describes a room (true) or a thing.
bool is_room(const WordSentence& sentence, const SpeakersOf& speaker, std::size_t from) {
    const std::set<Statement> as_room = said_as(sentence, speaker, SentenceKind::Room, from);
    const auto any = [](const std::set<Statement>& says, std::initializer_list<Statement> of) {
        return std::any_of(of.begin(), of.end(), [&](Statement one) { return says.contains(one); });
    };
    const std::set<Statement> as_thing = said_as(sentence, speaker, SentenceKind::Thing, from);
    if (any(as_thing, {Statement::Size3, Statement::AboveFloor})) return false;
    if (any(as_room, {Statement::SideOf, Statement::Above, Statement::Flush, Statement::Further, Statement::CornerAt,
                      Statement::CornerList, Statement::Stairs, Statement::Lift, Statement::Floor, Statement::Raised,
                      Statement::Sunk}))
        return true;
    if (any(as_thing,
            {Statement::Size3, Statement::At, Statement::Offset, Statement::Along, Statement::FromWall,
             Statement::InWall, Statement::MiddleOf, Statement::Middle, Statement::InCorner, Statement::ByWindow,
             Statement::ByDoor, Statement::NextTo, Statement::Landmark, Statement::Clue, Statement::MadeOf}))
        return false;
    return as_room.contains(Statement::Size2);
}

}  // namespace

SaidSentence head_of(const WordSentence& sentence, const SpeakersOf& speaker) {
    WordSentence head{sentence.line, sentence.first, sentence.paragraph, {}};
    for (const WordToken& token : sentence.tokens) {
        if (head.tokens.size() > 40) break;
        head.tokens.push_back(token);
    }
    return understood(head, speaker);
}

namespace {

// Recognises several things of a known kind: "Two chairs", "4 Stühle".
void note_count(const WordToken& first, const std::string& names, SaidSentence& said) {
    constexpr double kMostOfThem = 50.0;
    const std::optional<double> word =
        first.kind == WordToken::Kind::Word ? number_word(first.folded) : std::optional<double>();
    const double count = first.kind == WordToken::Kind::Number ? first.number : word.value_or(0.0);
    if (count < 2.0 || count > kMostOfThem || count != std::floor(count)) return;
    const std::optional<std::string> one = one_of_several(names);
    if (!one) return;
    said.name = *one;
    said.count = static_cast<int>(count);
}

// Reads a sentence: first its subject, then the description of the subject. Collects the words that were not
// understood.
class SentenceReader {
public:
    SentenceReader(const WordSentence& sentence, const SpeakersOf& speaker)
        : sentence_(sentence),
          speaker_(speaker),
          at_(kind_of(sentence, speaker.language, said_)),
          kind_(with_kind()),
          matcher_(sentence, speaker, kind_) {
        if (!has_subject()) subject_end_ = at_;
    }

    SaidSentence read() {
        // In sentences about the building or the language, all words after the beginning are the name.
        const bool all_name = kind_ == SentenceKind::Building || kind_ == SentenceKind::Language;
        for (int looked_at = 0; at_ < sentence_.tokens.size(); ++looked_at) {
            if (looked_at >= static_cast<int>(kMostWords)) {
                not_understood();
                break;
            }
            if (all_name) ++at_;
            else if (!take_comma() && !take_name() && !take_part()) leave_word();
        }
        lose(sentence_.tokens.size());
        if (has_subject()) name_subject();
        said_.in_steps = matcher_.in_steps();
        return std::move(said_);
    }

private:
    static constexpr std::size_t kOpen = std::string::npos;

    SentenceKind with_kind() {
        if (said_.kind == SentenceKind::Thing && !said_.explicit_kind && (sentence_.first || sentence_.paragraph) &&
            is_room(sentence_, speaker_, at_))
            said_.kind = SentenceKind::Room;
        return said_.kind;
    }
    bool has_subject() const {
        return kind_ == SentenceKind::Room || kind_ == SentenceKind::Thing || kind_ == SentenceKind::Building ||
               kind_ == SentenceKind::Storey || kind_ == SentenceKind::Language;
    }
    const WordToken& token() const { return sentence_.tokens[at_]; }
    bool begins_subject() const { return at_ == subject_from_ && has_subject(); }

    void not_understood() {
        if (lost_from_ == kOpen) lost_from_ = at_;
    }
    void lose(std::size_t end) {
        if (lost_from_ == kOpen) return;
        if (std::string text = joined(std::span(sentence_.tokens).subspan(lost_from_, end - lost_from_)); !text.empty())
            said_.not_understood.push_back(std::move(text));
        lost_from_ = kOpen;
    }

    bool take_comma() {
        if (token().kind != WordToken::Kind::Comma && token().kind != WordToken::Kind::Colon) return false;
        if (subject_end_ == kOpen && at_ > subject_from_) subject_end_ = at_;
        lose(at_);
        ++at_;
        return true;
    }

    // Reads a subject in quotation marks.
    bool take_name() {
        if (token().kind != WordToken::Kind::Name || !begins_subject()) return false;
        subject_end_ = ++at_;
        return true;
    }

    // Reads a pattern. A number or word at the very beginning of the subject belongs to the name, even if it matches a
    // pattern. Only phrases such as "stairs to ..." are name and pattern at once.
    bool take_part() {
        auto part = matcher_.at(at_);
        if (!part) return false;
        const bool names = begins_subject();
        if (names && part->first.says != Statement::Stairs && part->first.says != Statement::Lift) return false;
        if (subject_end_ == kOpen) subject_end_ = names ? at_ + 1 : at_;
        lose(at_);
        said_.parts.push_back(std::move(part->first));
        at_ = part->second;
        return true;
    }

    // Skips a word that matches nothing. The word becomes part of the subject, is ignored, or is added to the words
    // that were not understood.
    void leave_word() {
        const bool noise = token().kind == WordToken::Kind::Word &&
                           (has(kNoise, token().folded) || has(articles_of(speaker_.language), token().folded));
        if (subject_end_ != kOpen && !noise) not_understood();
        ++at_;
    }

    void name_subject() {
        const std::size_t end = std::min(subject_end_, sentence_.tokens.size());
        const auto words = [&](std::size_t from) {
            return joined(std::span(sentence_.tokens).subspan(from, end - from));
        };
        said_.name = words(subject_from_);
        if (kind_ == SentenceKind::Thing && !said_.explicit_kind && end > subject_from_ + 1)
            note_count(sentence_.tokens[subject_from_], words(subject_from_ + 1), said_);
    }

    const WordSentence& sentence_;
    const SpeakersOf& speaker_;
    SaidSentence said_;
    std::size_t at_;
    const SentenceKind kind_;
    Matcher matcher_;
    const std::size_t subject_from_ = at_;
    std::size_t subject_end_ = kOpen, lost_from_ = kOpen;
};

}  // namespace

SaidSentence understood(const WordSentence& sentence, const SpeakersOf& speaker) {
    return SentenceReader(sentence, speaker).read();
}

std::string name_key(std::string_view name, WordLanguage language) {
    std::string key = folded(name);
    for (const std::string_view article : articles_of(language))
        if (key.size() > article.size() + 1 && key.starts_with(article) && key[article.size()] == ' ')
            return key.substr(article.size() + 1);
    return key;
}

bool needs_quotation_marks(std::string_view name, WordLanguage language) {
    static const auto plain_words = [](WordLanguage of) {
        std::set<std::string, std::less<>> words;
        for (const Pattern& pattern : patterns_of(of)) {
            std::string word;
            for (const char c : std::string(pattern.words) + " ") {
                if (c == ' ' || c == '|' || c == '?' || c == '{' || c == '}') {
                    if (!word.empty()) words.insert(word);
                    word.clear();
                } else {
                    word += c;
                }
            }
        }
        for (const KindWord& head : heads_of(of)) {
            words.emplace(head.word.substr(head.word.rfind(' ') + 1));
            if (is_from_room(head.kind)) words.emplace(head.word.substr(0, head.word.find(' ')));
        }
        for (const KindWord& head : kColons) words.emplace(head.word);
        for (const std::string_view article : articles_of(of)) words.emplace(article);
        for (const std::string_view noise : kNoise) words.emplace(noise);
        return words;
    };
    static const std::array kWords{plain_words(WordLanguage::English), plain_words(WordLanguage::German)};
    const auto& words = kWords[static_cast<std::size_t>(language)];
    const std::vector<WordSentence> sentences = sentences_of(name);
    if (sentences.size() != 1 || sentences[0].tokens.size() > kMostOfName) return true;
    std::string back;
    for (std::size_t i = 0; i < sentences[0].tokens.size(); ++i) {
        const WordToken& token = sentences[0].tokens[i];
        if (token.kind != WordToken::Kind::Word && (token.kind != WordToken::Kind::Number || i == 0)) return true;
        if (words.contains(token.folded) || side_of(token.folded) >= 0 || compound_side(token.folded, false) >= 0 ||
            compound_side(token.folded, true) >= 0 || unit_m(token.folded, 1.0) > 0.0 || number_word(token.folded) ||
            !material_of_word(token.folded).empty())
            return true;
        back += (back.empty() ? "" : " ") + token.text;
    }
    return back != name;
}

namespace {

struct MaterialWord {
    std::string_view word, name;
};

// If a material has several rows, Handrail writes the first German word.
std::span<const MaterialWord> material_words() {
    static constexpr MaterialWord kRows[] = {
        {"putz", "plaster"},
        {"gips", "plaster"},
        {"holz", "wood"},
        {"parkett", "wood"},
        {"wooden", "wood"},
        {"kunststoff", "plastic"},
        {"plastik", "plastic"},
        {"ziegel", "brick"},
        {"ziegeln", "brick"},
        {"backstein", "brick"},
        {"bricks", "brick"},
        {"beton", "concrete"},
        {"stein", "stone"},
        {"fliesen", "tile"},
        {"tiles", "tile"},
        {"tiled", "tile"},
        {"metall", "metal"},
        {"stahl", "metal"},
        {"steel", "metal"},
        {"stahlgitter", "steel_grille"},
        {"steel grille", "steel_grille"},
        {"glas", "glass"},
        {"eis", "ice"},
        {"teppich", "carpet"},
        {"erde", "earth"},
        {"gummi", "rubber"},
        {"stoff", "cloth"},
        {"gras", "grass"},
        {"rasen", "grass"},
    };
    return kRows;
}

}  // namespace

std::string material_of_word(std::string_view word) {
    for (const MaterialWord& row : material_words())
        if (row.word == word) return std::string(row.name);
    const MaterialSpec* spec = word.empty() ? nullptr : find_material(word);
    return spec ? std::string(spec->name) : std::string();
}

std::string word_of_material(std::string_view name, WordLanguage language) {
    for (const MaterialWord& row : material_words())
        if (row.name == name && language == WordLanguage::German) return capitalised(row.word);
    return name == "steel_grille" ? "steel grille" : std::string(name);
}

namespace {

struct UsualSize {
    // `several` is the German plural. The English plural adds an s, except for the words in one_of_several.
    std::string_view english, german, several;
    double x, y, z;
};

std::span<const UsualSize> usual_sizes() {
    static constexpr UsualSize kRows[] = {
        {"armchair", "sessel", "sessel", 0.8, 0.8, 0.9},
        {"wheelchair", "rollstuhl", "rollstühle", 0.7, 1.1, 0.9},
        {"chair", "stuhl", "stühle", 0.45, 0.45, 0.9},
        {"desk", "schreibtisch", "schreibtische", 1.4, 0.7, 0.75},
        {"table", "tisch", "tische", 1.2, 0.8, 0.75},
        {"bed", "bett", "betten", 1.0, 2.0, 0.5},
        {"sofa", "sofa", "sofas", 1.9, 0.85, 0.85},
        {"bench", "bank", "bänke", 1.5, 0.45, 0.45},
        {"shelf", "regal", "regale", 0.8, 0.35, 1.8},
        {"bookcase", "bücherregal", "bücherregale", 1.0, 0.35, 1.9},
        {"cupboard", "schrank", "schränke", 1.0, 0.6, 1.9},
        {"wardrobe", "kleiderschrank", "kleiderschränke", 1.5, 0.6, 2.0},
        {"cabinet", "kommode", "kommoden", 0.8, 0.45, 0.9},
        {"toilet", "toilette", "toiletten", 0.4, 0.65, 0.45},
        {"basin", "waschbecken", "waschbecken", 0.6, 0.45, 0.85},
        {"sink", "spüle", "spülen", 0.8, 0.6, 0.9},
        {"stove", "herd", "herde", 0.6, 0.6, 0.9},
        {"oven", "ofen", "öfen", 0.6, 0.6, 0.9},
        {"refrigerator", "kühlschrank", "kühlschränke", 0.6, 0.6, 1.6},
        {"fridge", "kühlschrank", "kühlschränke", 0.6, 0.6, 1.6},
        {"bath", "badewanne", "badewannen", 1.7, 0.75, 0.6},
        {"tub", "wanne", "wannen", 1.7, 0.75, 0.6},
        {"shower", "dusche", "duschen", 0.9, 0.9, 2.0},
        {"piano", "klavier", "klaviere", 1.5, 0.6, 1.2},
        {"counter", "theke", "theken", 2.0, 0.6, 1.0},
        {"pillar", "säule", "säulen", 0.4, 0.4, 2.5},
        {"column", "pfeiler", "pfeiler", 0.4, 0.4, 2.5},
        {"plant", "pflanze", "pflanzen", 0.4, 0.4, 1.2},
        {"bin", "mülleimer", "mülleimer", 0.35, 0.35, 0.6},
        {"radiator", "heizkörper", "heizkörper", 1.0, 0.12, 0.6},
        {"machine", "automat", "automaten", 0.7, 0.7, 1.8},
    };
    return kRows;
}

const UsualSize* usual_row(std::string_view name) {
    const std::string key = folded(name);
    for (const UsualSize& row : usual_sizes())
        if (key.find(row.english) != std::string::npos || key.find(row.german) != std::string::npos) return &row;
    return nullptr;
}

}  // namespace

std::optional<std::string> one_of_several(std::string_view names) {
    const std::string key = folded(names);
    // Folding may change letters but not their number, so `names` can be cut by lengths that were found in the folded
    // key.
    const auto cut = [&](std::string_view several, std::string_view one) -> std::optional<std::string> {
        if (!key.ends_with(several)) return std::nullopt;
        return capitalised(std::string(names.substr(0, names.size() - several.size())) + std::string(one));
    };
    for (const UsualSize& row : usual_sizes()) {
        std::string english = std::string(row.english) + "s";
        if (row.english == "bench") english = "benches";
        if (row.english == "shelf") english = "shelves";
        if (auto one = cut(english, row.english)) return one;
        if (auto one = cut(row.several, row.german)) return one;
    }
    return std::nullopt;
}

bool usually_known(std::string_view name) { return usual_row(name) != nullptr; }

Vec3 usual_size_m(std::string_view name) {
    const UsualSize* row = usual_row(name);
    return row ? Vec3(row->x, row->y, row->z) : Vec3(0.6, 0.6, 0.8);
}

}  // namespace handrail::words
