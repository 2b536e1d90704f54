#include "worlds/base/language.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <toml++/toml.h>
#include <algorithm>
#include <atomic>
#include <cctype>
#include <cstdlib>
#include <deque>
#include <map>
#include <mutex>
#include <unordered_map>

#include "worlds/base/bundled_languages.h"
#include "worlds/base/files.h"
#include "worlds/base/message.h"
#include "worlds/base/text.h"
#include "worlds/base/typist.h"

namespace handrail {
namespace {

constexpr std::size_t kMaxFileBytes = 4U << 20;
constexpr std::string_view kEnglish = "en";

struct Language {
    std::string code;
    std::map<std::string, std::string, std::less<>> texts;
    std::filesystem::path folder;  // folder that holds the person's own file for this language
};

// Collects the texts of a table under the keys "section.key". Adds a diagnostic for each value that is not a text or
// that `fits` rejects. `fits` returns the fault of a text, or an empty string.
template <class Fits>
void gather(const toml::table& table, const std::string& prefix, const std::string& file, const Fits& fits,
            Language& into, std::vector<Diagnostic>& faults) {
    for (const auto& [name, node] : table) {
        const std::string key = prefix + std::string(name.str());
        const int line = static_cast<int>(node.source().begin.line);
        if (const toml::table* inner = node.as_table()) gather(*inner, key + ".", file, fits, into, faults);
        else if (const auto* value = node.as_string(); !value)
            faults.push_back({Severity::Warning, file, line, 0, phrase("language.not_a_text", {{"key", key}}), ""});
        else if (const std::string fault = fits(key, value->get()); !fault.empty())
            faults.push_back({Severity::Warning, file, line, 0, fault, ""});
        else into.texts[key] = value->get();
    }
}

// Keeps a language for ever. Languages outlive even the static objects of the process, because another thread may still
// read a language that was just replaced.
Language& kept(Language language) {
    static std::mutex guard;
    static auto& all = *new std::deque<Language>;
    const std::scoped_lock lock(guard);
    return all.emplace_back(std::move(language));
}

// Reads a bundled file without checking its texts, because tests check the bundled files.
const Language* make_bundled(const BundledLanguage& source) {
    Language made{std::string(source.code), {}, {}};
    std::vector<Diagnostic> faults;
    gather(
        toml::parse(source.content), "", "", [](const std::string&, const std::string&) { return std::string(); }, made,
        faults);
    return &kept(std::move(made));
}

const Language* bundled(std::string_view code) {
    static std::mutex guard;
    static auto& made = *new std::map<std::string, const Language*, std::less<>>;
    for (const BundledLanguage& source : kBundledLanguages)
        if (source.code == code) {
            const std::scoped_lock lock(guard);
            const Language*& language = made[std::string(code)];
            if (!language) language = make_bundled(source);
            return language;
        }
    return nullptr;
}

const Language& english() {
    static const Language& language = *bundled(kEnglish);
    return language;
}

std::atomic<const Language*> spoken{nullptr};

const Language& language_spoken() {
    const Language* language = spoken.load(std::memory_order_acquire);
    return language ? *language : english();
}

const std::string* find(const Language& language, std::string_view key) {
    const auto at = language.texts.find(key);
    return at == language.texts.end() ? nullptr : &at->second;
}

// True if the code has only letters, digits, "-" and "_", so that it cannot form a path to another folder.
bool may_be_code(std::string_view code) {
    return !code.empty() && std::all_of(code.begin(), code.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_';
    });
}

// True if the pattern needs no formatting, because it has neither values nor quotes.
bool is_plain(std::string_view pattern) { return pattern.find_first_of("{}'") == std::string_view::npos; }

// Cache of compiled patterns. Compiling a pattern takes longer than all the rest of phrase(). Only one thread at a
// time may use a message.
struct Compiled {
    std::mutex guard;
    // The key is the address of a pattern. Patterns belong to kept languages, so their addresses never change.
    std::unordered_map<const std::string*, std::unique_ptr<const Message>> messages;
};
Compiled& compiled() {
    // Never destroyed, because another thread may still use it while the process ends.
    static auto& all = *new Compiled;
    return all;
}

// Fills the values into `pattern`, which must be a text of `language`. `language` must be a kept language.
std::string fill(const Language& language, const std::string& pattern, std::initializer_list<TextValue> values) {
    if (is_plain(pattern)) return pattern;
    const std::scoped_lock lock(compiled().guard);
    auto& message = compiled().messages[&pattern];
    if (!message) message = compile_message(pattern, language.code);
    return message ? message->filled({values.begin(), values.size()}).value_or(pattern) : pattern;
}

// Returns a sentence with the reason why `pattern` cannot replace the English text under `key`, or an empty string if
// `pattern` can.
std::string misfit(const std::string& key, const std::string& pattern) {
    std::vector<std::string> named, offered;
    if (pattern.empty()) return phrase("language.empty_text", {{"key", key}});
    if (const std::string fault = pattern_fault(pattern, &named); !fault.empty())
        return phrase("language.bad_pattern", {{"key", key}, {"fault", fault}});
    const std::string* original = find(english(), key);
    if (!original) return phrase("language.unknown_key", {{"key", key}});
    pattern_fault(*original, &offered);
    for (const std::string& name : named)
        if (!std::binary_search(offered.begin(), offered.end(), name))
            return phrase("language.unknown_value", {{"key", key}, {"name", name}});
    return "";
}

std::atomic<ActsBy> acts_by{ActsBy::WindowKeys};

}  // namespace

void speak_to(ActsBy who) { acts_by.store(who, std::memory_order_relaxed); }
ActsBy spoken_to() { return acts_by.load(std::memory_order_relaxed); }

std::string phrase(std::string_view key, std::initializer_list<TextValue> values) {
    const Language& language = language_spoken();
    if (speaks_to_typist()) {
        const std::string typed = std::string(key) + "_typed";
        if (const std::string* pattern = find(language, typed)) return fill(language, *pattern, values);
        // The person's own language file may lack the key with "_typed" and have only the key without it.
        if (const std::string* pattern = find(english(), typed); pattern && !find(language, key))
            return fill(english(), *pattern, values);
    }
    if (const std::string* pattern = find(language, key)) {
        std::string said = fill(language, *pattern, values);
        // A text may be empty only if the English text is empty too; else the English text is used.
        if (!said.empty() || &language == &english()) return said;
    }
    if (const std::string* pattern = find(english(), key)) return fill(english(), *pattern, values);
    return std::string(key);
}

bool has_phrase(std::string_view key) { return find(language_spoken(), key) || find(english(), key); }

std::vector<LanguageName> bundled_languages() {
    std::vector<LanguageName> names;
    for (const BundledLanguage& source : kBundledLanguages)
        names.push_back({std::string(source.code), *find(*bundled(source.code), "language.name")});
    std::stable_partition(names.begin(), names.end(),
                          [](const LanguageName& language) { return language.code == kEnglish; });
    return names;
}

std::vector<LanguageName> languages_to_choose(const std::filesystem::path& folder) {
    std::vector<LanguageName> names = bundled_languages();
    std::error_code ec;
    for (std::filesystem::directory_iterator file(folder, ec), end; !ec && file != end; file.increment(ec)) {
        const std::string code = file->path().stem().string();
        if (file->path().extension() != ".toml" || !may_be_code(code) || bundled(code)) continue;
        const Result<std::string> content = read_whole_file(file->path(), kMaxFileBytes);
        if (!content || !is_utf8(*content)) continue;
        try {
            const toml::table table = toml::parse(*content);
            names.push_back({code, table["language"]["name"].value_or(code)});
        } catch (const toml::parse_error&) {
        }
    }
    std::sort(names.begin() + static_cast<std::ptrdiff_t>(std::size(kBundledLanguages)), names.end(),
              [](const auto& a, const auto& b) { return a.code < b.code; });
    return names;
}

std::string language_of_environment(const std::filesystem::path& folder) {
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        const char* locale = std::getenv(name);
        if (!locale || !*locale) continue;
        std::string code = std::string(locale).substr(0, std::string_view(locale).find_first_of("_.@"));
        if (!may_be_code(code)) break;
        const bool comes_along = std::any_of(kBundledLanguages.begin(), kBundledLanguages.end(),
                                             [&](const auto& source) { return source.code == code; });
        std::error_code ec;
        if (comes_along || (!folder.empty() && std::filesystem::exists(folder / (code + ".toml"), ec))) return code;
        break;
    }
    return std::string(kEnglish);
}

std::string in_spoken_language(const std::string& text, const OtherLanguages& others) {
    if (others.empty()) return text;
    const std::string& code = language_spoken().code;
    const auto same =
        std::find_if(others.begin(), others.end(), [&](const TextIn& other) { return other.language == code; });
    return same == others.end() ? text : same->text;
}

std::string spoken_language() { return language_spoken().code; }

std::filesystem::path spoken_language_folder() { return language_spoken().folder; }

Result<std::vector<Diagnostic>> speak_language(std::string_view code, const std::filesystem::path& folder) {
    const Language* language = bundled(code);
    const std::filesystem::path path = folder / (std::string(code) + ".toml");
    std::vector<Diagnostic> faults;
    std::error_code ec;
    if (may_be_code(code) && !folder.empty() && std::filesystem::exists(path, ec)) {
        const Result<std::string> content = read_whole_file(path, kMaxFileBytes);
        if (!content) return tl::unexpected(content.error());
        if (!is_utf8(*content)) return fail(phrase("language.not_utf8"), path.filename().string());
        try {
            const toml::table table = toml::parse(*content);
            Language own{std::string(code), {}, folder};
            if (language) {
                own.texts = language->texts;
                // Stores the bundled language first, so that faults in the person's own texts are reported in the
                // language that the person chose.
                spoken.store(language, std::memory_order_release);
            }
            gather(table, "", path.filename().string(), misfit, own, faults);
            language = &kept(std::move(own));
        } catch (const toml::parse_error& error) {
            return fail(phrase("language.damaged", {{"reason", std::string(error.description())}}),
                        path.filename().string(), static_cast<int>(error.source().begin.line));
        }
    }
    if (!language) {
        std::vector<std::string> codes;
        for (const BundledLanguage& source : kBundledLanguages) codes.emplace_back(source.code);
        return fail(phrase("language.unknown",
                           {{"code", std::string(code)}, {"codes", fmt::format("{}", fmt::join(codes, ", "))}}));
    }
    spoken.store(language, std::memory_order_release);
    return faults;
}

std::string pattern_fault(std::string_view pattern, std::vector<std::string>* names) {
    MessageFault fault;
    const std::unique_ptr<const Message> message = compile_message(pattern, std::string(kEnglish), &fault);
    if (!message) return phrase("language.fault_at", {{"fault", fault.name}, {"character", fault.character + 1}});
    if (names) *names = message->names();
    return "";
}

std::vector<std::pair<std::string, std::string>> bundled_texts(std::string_view code) {
    const Language* language = bundled(code);
    if (!language) return {};
    return {language->texts.begin(), language->texts.end()};
}

}  // namespace handrail
