// Describes a learner: a person with a chosen name, and what the person has agreed to. The file learner.toml in the
// learner's own folder stores these data. Rewriting the file keeps its unknown keys. Plain values and pure functions;
// any thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "worlds/base/result.h"

namespace handrail::learners {

// What a learner can agree to. Remember: Handrail keeps knowledge from session to session. Record: Handrail records
// sessions. Share: Handrail writes reports to places where other people can find them.
enum class Purpose : std::uint8_t { Remember, Record, Share };
inline constexpr std::array<Purpose, 3> kPurposes = {Purpose::Remember, Purpose::Record, Purpose::Share};
// Returns "remember", "record" or "share", as in files and on the command line.
std::string_view word_of(Purpose purpose);
std::optional<Purpose> purpose_named(std::string_view word);

// Returns true if the text is a calendar day such as "2026-11-24". Sorting such texts sorts the days.
bool is_day(std::string_view text);
// Returns today's date in UTC, by the computer's clock.
std::string today();

struct Consent {
    std::string given;  // day on which the consent was given
    std::string by;     // name of the person who gave the consent; may be empty
    std::string until;  // last day on which the consent is valid; empty: until it is withdrawn
};

struct Learner {
    std::string id;       // eight random characters, which are also the name of the folder
    std::string name;     // chosen name
    std::string created;  // day on which the learner was created
    std::array<std::optional<Consent>, kPurposes.size()> consents;

    std::optional<Consent>& consent(Purpose purpose) { return consents[static_cast<std::size_t>(purpose)]; }
    const std::optional<Consent>& consent(Purpose purpose) const { return consents[static_cast<std::size_t>(purpose)]; }
    // Returns true if consent to the purpose was given and is still valid on that day.
    bool allows(Purpose purpose, std::string_view day) const;
};

// Returns the consents that are valid on that day in words, such as "is remembered and is recorded". If there are none,
// the words say so.
std::string agreed_words(const Learner& learner, std::string_view day);

// Reads a learner from `text`, the contents of learner.toml, which do not contain the id. Fails with file and line, and
// never returns only part of a learner.
Result<Learner> read_learner(const std::string& text, const std::string& file);
// Returns the contents of learner.toml for `learner`. They keep all unknown keys of `before`, the earlier contents.
// Fails if `before` cannot be parsed.
Result<std::string> text_of(const Learner& learner, const std::string& before, const std::string& file);

// Returns the typed text as a learner's name: a single line, short enough for a list. Fails with a sentence that says
// what is wrong with the text.
Result<std::string> good_learner_name(std::string_view typed);
// Returns true if the name may be a real name: it has capitalised words, and Handrail did not offer it.
bool may_be_real(std::string_view name);
// Returns a name made of a tree and a bird, 64 of each, in the spoken language. Equal numbers give equal names.
std::string offered_name(std::uint32_t number);

}  // namespace handrail::learners
