#include "app/learners/learner.h"

#include <fmt/chrono.h>
#include <toml++/toml.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <sstream>
#include <vector>

#include "app/core/kept/side_file.h"
#include "settings/parse_toml.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::learners {
namespace {

constexpr std::array<std::string_view, kPurposes.size()> kWords = {"remember", "record", "share"};
constexpr std::size_t kLongestLearner_bytes = 60;

int line_of_node(const toml::node* node) { return node ? static_cast<int>(node->source().begin.line) : 0; }

// Parses a file as TOML. If parsing fails, the error is a sentence of Handrail, not of the TOML library.
Result<toml::table> parsed(const std::string& text, const std::string& file) {
    if (!is_utf8(text)) return fail(phrase("learner.no_text"), file);
    try {
        return settings::parse_toml(text);
    } catch (const toml::parse_error& error) {
        return fail(phrase("learner.damaged"), file, static_cast<int>(error.source().begin.line));
    }
}

// Returns the text under `key`; empty if there is none. The value may also be a TOML date, which is returned as text.
Result<std::string> text_at(const toml::table& table, std::string_view key, const std::string& file) {
    const toml::node* node = table.get(key);
    if (!node) return std::string();
    if (const auto* text = node->as_string()) return text->get();
    if (const auto* day = node->as_date())
        return fmt::format("{:04}-{:02}-{:02}", day->get().year, day->get().month, day->get().day);
    return fail(phrase("learner.needs_text", {{"key", key}}), file, line_of_node(node));
}

Result<std::string> day_at(const toml::table& table, std::string_view key, const std::string& file) {
    auto day = text_at(table, key, file);
    if (day && !day->empty() && !is_day(*day))
        return fail(phrase("learner.needs_day", {{"key", key}, {"text", one_line(*day)}}), file,
                    line_of_node(table.get(key)));
    return day;
}

Result<Consent> read_consent(const toml::table& table, const std::string& file) {
    Consent consent;
    for (const auto& [key, to] : {std::pair{"given", &consent.given}, std::pair{"until", &consent.until}}) {
        auto day = day_at(table, key, file);
        if (!day) return tl::unexpected(day.error());
        *to = std::move(*day);
    }
    if (consent.given.empty())
        return fail(phrase("learner.consent_undated"), file, static_cast<int>(table.source().begin.line));
    auto by = text_at(table, "by", file);
    if (!by) return tl::unexpected(by.error());
    consent.by = one_line(*by);
    return consent;
}

std::vector<std::string> words_of(std::string_view text) {
    std::istringstream in{std::string(text)};
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

bool is_one_of(std::string_view key, const std::string& word) {
    const std::vector<std::string> words = words_of(phrase(key));
    return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::string_view word_of(Purpose purpose) { return kWords[static_cast<std::size_t>(purpose)]; }

std::optional<Purpose> purpose_named(std::string_view word) {
    const auto found = std::find(kWords.begin(), kWords.end(), word);
    if (found == kWords.end()) return std::nullopt;
    return kPurposes[static_cast<std::size_t>(found - kWords.begin())];
}

bool is_day(std::string_view text) {
    if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
    int numbers[3] = {0, 0, 0};
    for (std::size_t i = 0, at = 0; i < text.size(); ++i) {
        if (i == 4 || i == 7) {
            ++at;
            continue;
        }
        if (text[i] < '0' || text[i] > '9') return false;
        numbers[at] = numbers[at] * 10 + (text[i] - '0');
    }
    using namespace std::chrono;
    return year_month_day(year(numbers[0]), month(static_cast<unsigned>(numbers[1])),
                          day(static_cast<unsigned>(numbers[2])))
        .ok();
}

std::string today() { return fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr))); }

bool Learner::allows(Purpose purpose, std::string_view day) const {
    const std::optional<Consent>& given = consent(purpose);
    return given && (given->until.empty() || day <= given->until);
}

std::string agreed_words(const Learner& learner, std::string_view day) {
    constexpr std::array<const char*, kPurposes.size()> kKeys = {"learner.remember", "learner.record", "learner.share"};
    std::string words;
    for (const Purpose purpose : kPurposes) {
        if (!learner.allows(purpose, day)) continue;
        const std::string one = phrase(kKeys.at(static_cast<std::size_t>(purpose)));
        words = words.empty() ? one : phrase("learner.and", {{"one", words}, {"other", one}});
    }
    return words.empty() ? phrase("learner.agreed_to_nothing") : words;
}

Result<Learner> read_learner(const std::string& text, const std::string& file) {
    const auto table = parsed(text, file);
    if (!table) return tl::unexpected(table.error());
    Learner learner;
    const auto typed = text_at(*table, "name", file);
    if (!typed) return tl::unexpected(typed.error());
    auto name = good_learner_name(*typed);
    if (!name) return fail(std::move(name.error().message), file, std::max(1, line_of_node(table->get("name"))));
    learner.name = std::move(*name);
    auto created = day_at(*table, "created", file);
    if (!created) return tl::unexpected(created.error());
    learner.created = std::move(*created);
    const toml::node* consents = table->get("consent");
    if (!consents) return learner;
    for (const Purpose purpose : kPurposes) {
        const toml::node* one = consents->is_table() ? consents->as_table()->get(word_of(purpose)) : consents;
        if (!one) continue;
        if (!consents->is_table() || !one->is_table())
            return fail(phrase("learner.consent_no_table", {{"purpose", word_of(purpose)}}), file, line_of_node(one));
        auto consent = read_consent(*one->as_table(), file);
        if (!consent) return tl::unexpected(consent.error());
        learner.consent(purpose) = std::move(*consent);
    }
    return learner;
}

Result<std::string> text_of(const Learner& learner, const std::string& before, const std::string& file) {
    if (const auto readable = before.empty() ? Result<Learner>() : read_learner(before, file); !readable)
        return tl::unexpected(readable.error());
    auto table = parsed(before, file);
    if (!table) return tl::unexpected(table.error());
    table->insert_or_assign("name", learner.name);
    if (!learner.created.empty()) table->insert_or_assign("created", learner.created);
    if (!table->contains("consent")) table->insert("consent", toml::table());
    toml::table& consents = *table->get("consent")->as_table();
    for (const Purpose purpose : kPurposes) {
        const std::optional<Consent>& consent = learner.consent(purpose);
        if (!consent) {
            consents.erase(word_of(purpose));
            continue;
        }
        if (!consents.contains(word_of(purpose))) consents.insert(word_of(purpose), toml::table());
        toml::table& one = *consents.get(word_of(purpose))->as_table();
        for (const auto& [key, value] :
             {std::pair{"given", &consent->given}, std::pair{"by", &consent->by}, std::pair{"until", &consent->until}})
            if (value->empty()) one.erase(key);
            else one.insert_or_assign(key, *value);
    }
    if (consents.empty()) table->erase("consent");
    std::ostringstream out;
    out.exceptions(std::ios::badbit);
    out << *table << '\n';
    return out.str();
}

Result<std::string> good_learner_name(std::string_view typed) {
    auto name = core::good_name(typed);
    if (!name) return name;
    if (name->size() > kLongestLearner_bytes)
        return fail(phrase("side_file.name_too_long", {{"most", kLongestLearner_bytes}}));
    if (name->starts_with("-") || name->find('/') != std::string::npos) return fail(phrase("learner.name_like_option"));
    return name;
}

bool may_be_real(std::string_view name) {
    const std::vector<std::string> words = words_of(name);
    const auto capital = [](const std::string& word) {
        // A word that begins with a non-ASCII letter may be a name, because this function cannot tell which non-ASCII
        // letters are capitals.
        return (word.front() >= 'A' && word.front() <= 'Z') || static_cast<unsigned char>(word.front()) >= 0x80;
    };
    if (std::count_if(words.begin(), words.end(), capital) < 2) return false;
    return !(words.size() == 2 && is_one_of("learner.trees", words[0]) && is_one_of("learner.birds", words[1]));
}

std::string offered_name(std::uint32_t number) {
    const std::vector<std::string> trees = words_of(phrase("learner.trees")), birds = words_of(phrase("learner.birds"));
    return trees[number % trees.size()] + " " + birds[number / trees.size() % birds.size()];
}

}  // namespace handrail::learners
