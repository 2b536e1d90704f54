#include "tests/support/heard_legs.h"
#include "tests/support/names.h"

#include <algorithm>
#include <vector>

namespace handrail::test {

LegForm english_legs() {
    return {{{"Straight on", 0},
             {"Turn slightly right", 1},
             {"Turn half right", 2},
             {"Turn half right, then slightly right", 3},
             {"Turn right", 4},
             {"Turn right, then slightly right", 5},
             {"Turn sharp right", 6},
             {"Turn sharp right, then slightly right", 7},
             {"Turn round", 8},
             {"Turn slightly left", -1},
             {"Turn half left", -2},
             {"Turn half left, then slightly left", -3},
             {"Turn left", -4},
             {"Turn left, then slightly left", -5},
             {"Turn sharp left", -6},
             {"Turn sharp left, then slightly left", -7}},
            std::regex("^(\\d+) steps?( to .*)?$"),
            std::regex("^(\\d+) steps?, until (you meet .*|something stops you)$"),
            std::regex("^(?:\\d+ stairs?|Ramp) (?:up|down), (?:in (\\d+) steps?|just ahead), to the end$"),
            std::regex("^(Open|Shut) it$"),
            std::regex("^(About )?\\d+ steps?( and \\d+ stairs?)? in all(: .*)?$"),
            "You are there.",
            "Landing",
            "Foot of the stairs"};
}

LegForm german_legs() {
    return {
        {{"Geradeaus", 0},
         {"Leicht rechts abbiegen", 1},
         {"Halb rechts abbiegen", 2},
         {"Halb rechts abbiegen, dann leicht rechts", 3},
         {"Rechts abbiegen", 4},
         {"Rechts abbiegen, dann leicht rechts", 5},
         {"Scharf rechts abbiegen", 6},
         {"Scharf rechts abbiegen, dann leicht rechts", 7},
         {"Umdrehen", 8},
         {"Leicht links abbiegen", -1},
         {"Halb links abbiegen", -2},
         {"Halb links abbiegen, dann leicht links", -3},
         {"Links abbiegen", -4},
         {"Links abbiegen, dann leicht links", -5},
         {"Scharf links abbiegen", -6},
         {"Scharf links abbiegen, dann leicht links", -7}},
        std::regex("^(\\d+) Schritte?( bis .*)?$"),
        std::regex("^(\\d+) Schritte?, bis (zum Anstoßen: .*|es nicht mehr weitergeht)$"),
        std::regex("^(?:\\d+ Stufen?|Rampe) (?:hinauf|hinab), (?:in (\\d+) Schritt(?:en)?|gleich vorn), bis zum Ende$"),
        std::regex("^(Öffnen|Schließen)$"),
        std::regex("^(Etwa )?\\d+ Schritte?( und \\d+ Stufen?)? insgesamt(: .*)?$"),
        "Das Ziel ist erreicht.",
        "Treppenabsatz",
        "Fuß der Treppe"};
}

namespace {

// Returns the sentences of a text without their full stops.
std::vector<std::string> sentences_of(const std::string& text) {
    std::vector<std::string> sentences;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(". ", at), text.size());
        std::string sentence = text.substr(at, end - at);
        if (!sentence.empty() && sentence.back() == '.') sentence.pop_back();
        sentences.push_back(std::move(sentence));
        at = end + 2;
    }
    return sentences;
}

}  // namespace

std::vector<std::string> legs_in(const std::string& text, const LegForm& form) {
    std::vector<std::string> legs;
    for (const std::string& sentence : sentences_of(text)) {
        if (legs.empty() || form.turns.count(sentence) > 0) legs.push_back(sentence + ".");
        else legs.back() += " " + sentence + ".";
    }
    return legs;
}

std::optional<HeardLeg> understood(const std::string& text, const LegForm& form) {
    std::vector<std::string> sentences = sentences_of(text);
    if (!sentences.empty() && std::regex_match(sentences[0], form.in_all)) sentences.erase(sentences.begin());
    if (sentences.size() < 2) return std::nullopt;
    const auto turn = form.turns.find(sentences[0]);
    if (turn == form.turns.end()) return std::nullopt;
    HeardLeg requested;
    requested.turn_notches = turn->second;
    std::smatch found;
    if (std::regex_match(sentences[1], found, form.until)) {
        requested.until = HeardLeg::Until::Stopped;
        requested.steps = std::stoi(found[1]);
    } else if (std::regex_match(sentences[1], found, form.flight)) {
        requested.until = HeardLeg::Until::FlightOver;
        requested.steps = found[1].matched ? std::stoi(found[1]) : 0;
    } else if (std::regex_match(sentences[1], found, form.counted)) {
        requested.steps = std::stoi(found[1]);
    } else {
        return std::nullopt;
    }
    for (std::size_t i = 2; i < sentences.size(); ++i)
        requested.use = requested.use || std::regex_match(sentences[i], form.use);
    return requested;
}

std::optional<Direction> direction_in(const std::string& text) {
    static const std::string side =
        "(?:(\\d+) degrees (right|left)|(?:to the )?(ahead|behind|slightly|half|right|left)( right| left)?)";
    static const std::regex pattern("(\\d+) steps?,? " + side), close("close by,? " + side);
    std::smatch found;
    Direction direction;
    std::string degrees, degrees_side, word, half;
    if (std::regex_search(text, found, pattern)) {
        direction.steps = std::stoi(found[1]);
        degrees = found[2], degrees_side = found[3], word = found[4], half = found[5];
    } else if (std::regex_search(text, found, close)) {
        degrees = found[1], degrees_side = found[2], word = found[3], half = found[4];
    } else {
        return std::nullopt;
    }
    if (!degrees.empty()) {
        direction.right_deg = std::stod(degrees) * (degrees_side == "right" ? 1.0 : -1.0);
    } else {
        const double to = half == " right" ? 1.0 : half == " left" ? -1.0 : 0.0;
        direction.right_deg = word == "right"      ? 90.0
                              : word == "left"     ? -90.0
                              : word == "behind"   ? (to == 0.0 ? 180.0 : to * 135.0)
                              : word == "slightly" ? to * 22.5
                                                   : to * 45.0;
    }
    return direction;
}

}  // namespace handrail::test
