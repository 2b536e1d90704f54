// A learner: a person under a chosen name, and what the person has agreed to. Kept in learner.toml in the learner's
// own folder; unknown keys stay in it. Plain values and pure functions; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "worlds/base/result.h"

namespace handrail::learners {

// What a learner can agree to: that knowledge is remembered from session to session, that sessions are recorded, and
// that reports are written where others can find them.
enum class Purpose : std::uint8_t { Remember, Record, Share };
inline constexpr std::array<Purpose, 3> kPurposes = {Purpose::Remember, Purpose::Record, Purpose::Share};
// "remember", "record" or "share", as in files and on the command line.
std::string_view word_of(Purpose purpose);
std::optional<Purpose> purpose_named(std::string_view word);

// Checks for a calendar day such as "2026-11-24"; as texts, such days sort correctly.
bool is_day(std::string_view text);
// Today's date in UTC, by the computer's clock.
std::string today();

struct Consent {
    std::string given;  // day of consent
    std::string by;     // name of who gave it; may be empty
    std::string until;  // last day of validity; empty: until it is withdrawn
};

struct Learner {
    std::string id;       // eight random characters: the name of the folder
    std::string name;     // chosen name
    std::string created;  // day of creation
    std::array<std::optional<Consent>, kPurposes.size()> consents;

    std::optional<Consent>& consent(Purpose purpose) { return consents[static_cast<std::size_t>(purpose)]; }
    const std::optional<Consent>& consent(Purpose purpose) const { return consents[static_cast<std::size_t>(purpose)]; }
    // Returns true if consent was given and is still valid on that day.
    bool allows(Purpose purpose, std::string_view day) const;
};

// The consents valid on that day, such as "is remembered and is recorded"; a text for none, too.
std::string agreed_words(const Learner& learner, std::string_view day);

// Reads a file's text, which lacks the id. Fails with file and line, and never returns part of a learner.
Result<Learner> read_learner(const std::string& text, const std::string& file);
// The text of the file, with all unknown keys of `before`, an earlier text. Fails if `before` cannot be read.
Result<std::string> text_of(const Learner& learner, const std::string& before, const std::string& file);

// Checks that a name can be a learner's name: a single line, not too long for a list. Fails with what is wrong.
Result<std::string> good_learner_name(std::string_view typed);
// Returns true if it may be a real name: it has capitalised words and is not one of the offered names.
bool may_be_real(std::string_view name);
// Combines the name of a tree and of a bird, 64 of each, in the language spoken. The same number always gives the same
// name.
std::string offered_name(std::uint32_t number);

}  // namespace handrail::learners
