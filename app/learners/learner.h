// A learner: a person under a chosen name, and what that person has agreed to. Kept in learner.toml in the learner's
// own folder; keys that nobody here knows stay in it. Plain values and pure functions; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "worlds/base/result.h"

namespace handrail {

// What a learner can agree to: that what was learnt is remembered from session to session, that sessions are recorded,
// that reports are written where others find them.
enum class Purpose : std::uint8_t { Remember, Record, Share };
inline constexpr std::array<Purpose, 3> kPurposes = {Purpose::Remember, Purpose::Record, Purpose::Share};
// "remember", "record", "share": as files and the command line have it.
std::string_view word_of(Purpose purpose);
std::optional<Purpose> purpose_named(std::string_view word);

// A day of the calendar as "2026-11-24", so that texts compare as days do.
bool is_day(std::string_view text);
// Today by the clock of the computer, UTC.
std::string today();

struct Consent {
    std::string given;  // the day
    std::string by;     // who gave it; may be empty
    std::string until;  // the last day it holds; empty: until it is withdrawn
};

struct Learner {
    std::string id;       // eight characters by chance: the name of the folder
    std::string name;     // chosen
    std::string created;  // the day
    std::array<std::optional<Consent>, kPurposes.size()> consents;

    std::optional<Consent>& consent(Purpose purpose) { return consents[static_cast<std::size_t>(purpose)]; }
    const std::optional<Consent>& consent(Purpose purpose) const { return consents[static_cast<std::size_t>(purpose)]; }
    // Given, and not over on that day.
    bool allows(Purpose purpose, std::string_view day) const;
};

// "is remembered and is recorded", of what holds on that day; that there is nothing, in words, too.
std::string agreed_words(const Learner& learner, std::string_view day);

// Of a file's text, without the id. Fails with file and line; never half a learner.
Result<Learner> read_learner(const std::string& text, const std::string& file);
// As a file has it, with everything of `before`, the text of an earlier one, that nobody here knows. Fails where that
// cannot be read.
Result<std::string> text_of(const Learner& learner, const std::string& before, const std::string& file);

// Fit to be a learner's name: a person's line, not too long for a list. Says what is wrong with it.
Result<std::string> good_learner_name(std::string_view typed);
// It may be somebody's real name: words with capitals, and not one of those that are offered.
bool may_be_real(std::string_view name);
// A name of a tree and one of a bird, in the language spoken; 64 of each. The same number gives the same name.
std::string offered_name(std::uint32_t number);

}  // namespace handrail
