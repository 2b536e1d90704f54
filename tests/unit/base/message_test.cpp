#include <clocale>
#include <random>
#include <regex>

#include "worlds/base/language.h"
#include "worlds/base/message.h"
#include "worlds/base/plain_message.h"

namespace handrail {
namespace message_test {

constexpr double kNumbers[] = {0.0,   -0.0,      1.0,    -1.0,   0.5,     1.5,   2.5,      0.05,  0.15,    0.25, 0.35,
                               0.125, 0.375,     0.0005, 0.0015, 0.00025, 0.999, 0.9995,   9.995, 99.95,   10.0, 12.34,
                               1e-7,  1234.5678, 999.5,  1e6,    1e21,    -0.04, -12345.6, 1e300, 0.99999, 3.0,  100.0};
constexpr std::int64_t kWhole[] = {0, 1, 2, 3, -1, 10, 11, 100, 999, 1000, 12345, 1234567, -1000, 9223372036854775807};

std::string said(const std::unique_ptr<const Message>& message, std::span<const TextValue> values) {
    return message->filled(values).value_or("not filled");
}

// Gives each value of the pattern a value of the type that it has there, and sometimes of another type.
class SomeValues {
public:
    explicit SomeValues(const std::string& pattern) {
        static const std::regex use(R"(\{(\w+), *(number|plural|selectordinal|select))"), key(R"(([\w=]+) \{)");
        for (std::sregex_iterator at(pattern.begin(), pattern.end(), use), end; at != end; ++at)
            types_.emplace((*at)[1], (*at)[2]);
        for (std::sregex_iterator at(pattern.begin(), pattern.end(), key), end; at != end; ++at)
            texts_.push_back((*at)[1]);
    }
    TextValue next(const std::string& name) {
        const auto type = types_.find(name);
        const bool number = type != types_.end() && type->second != "select";
        switch (random_() % (number ? 16 : 8)) {
            case 0:
                return {name, texts_[random_() % texts_.size()]};
            case 1:
                return {name, 2};
            case 2:
                return {name, std::uniform_real_distribution<double>(-1e3, 1e3)(random_)};
            default:
                if (!number) return {name, texts_[random_() % texts_.size()]};
                if (random_() % 2 == 0) return {name, kNumbers[random_() % std::size(kNumbers)]};
                return {name, kWhole[random_() % std::size(kWhole)]};
        }
    }

private:
    std::map<std::string, std::string> types_;
    std::vector<std::string> texts_ = {"Küche", "it's {odd} '{'", ""};
    std::mt19937 random_{1};
};

TEST(PlainMessage, says_what_icu_says_for_every_bundled_text) {
    int compared = 0, filled = 0;
    for (const LanguageName& language : bundled_languages())
        for (const auto& [key, pattern] : bundled_texts(language.code)) {
            const auto icu = compile_message(pattern, language.code);
            const auto plain = compile_plain_message(pattern, language.code);
            ASSERT_TRUE(icu && plain) << key << ": " << pattern;
            const std::vector<std::string> names = icu->names();
            ASSERT_EQ(plain->names(), names) << key;
            SomeValues some(pattern);
            for (int i = 0; i < (names.empty() ? 1 : 24); ++i) {
                std::vector<TextValue> values;
                for (const std::string& name : names)
                    if (i != 1 || &name != &names.front()) values.push_back(some.next(name));
                const std::string expected = said(icu, values);
                ASSERT_EQ(said(plain, values), expected) << key << ": " << pattern;
                ++compared;
                filled += expected != "not filled";
            }
        }
    EXPECT_GT(compared, 10'000);
    EXPECT_GT(filled, compared / 2);
}

TEST(PlainMessage, writes_numbers_as_icu_does) {
    std::mt19937_64 random(1);
    for (const char* style : {"", ", integer", ",#0", ",#0.#", ",#0.##", ", ::.", ", ::.0", ", ::.00", ", ::.#",
                              ", ::.0#", ", ::.### group-off", ", ::.######### group-off", ", ::@##",
                              ", ::@# group-off", ", ::@##### group-off", ", ::group-off", ", ::precision-integer"})
        for (const char* language : {"en", "de"}) {
            const std::string pattern = "{x, number" + std::string(style) + "}";
            const auto icu = compile_message(pattern, language), plain = compile_plain_message(pattern, language);
            ASSERT_TRUE(icu && plain) << pattern;
            const auto compare = [&](const TextValue& value) {
                ASSERT_EQ(said(plain, {&value, 1}), said(icu, {&value, 1})) << pattern << " " << language;
            };
            for (const double number : kNumbers) compare({"x", number});
            for (const std::int64_t number : kWhole) compare({"x", number});
            for (int i = 0; i < 2000; ++i) {
                const auto bits = static_cast<std::int64_t>(random());
                compare({"x", static_cast<double>(bits % 2'000'000) / (i % 2 == 0 ? 1000.0 : 2048.0)});
                compare({"x", bits >> (i % 63)});
            }
        }
}

TEST(PlainMessage, rejects_what_icu_rejects) {
    for (const char* pattern :
         {"{", "{x", "{}", "{x,", "{x, number", "{x, nothing}", "{x, plural, one {a}}", "{x, select, yes {a}}",
          "{x, plural, other {a}", "{x, plural other {a}}", "{x, select, {a} other {b}}"}) {
        MessageFault fault;
        EXPECT_FALSE(compile_message(pattern, "en")) << pattern;
        EXPECT_FALSE(compile_plain_message(pattern, "en", &fault)) << pattern;
        EXPECT_TRUE(fault.name.starts_with("U_")) << pattern;
    }
    for (const char* pattern :
         {"it's", "it''s", "'{'x'}'", "'{x}' {x}", "}", "{ x }", "{x, plural, one {'#' #} other {#'s}}"}) {
        const auto icu = compile_message(pattern, "en"), plain = compile_plain_message(pattern, "en");
        ASSERT_EQ(icu == nullptr, plain == nullptr) << pattern;
        const TextValue value("x", 1);
        if (icu) {
            EXPECT_EQ(said(plain, {&value, 1}), said(icu, {&value, 1})) << pattern;
        }
    }
}

TEST(PlainMessage, begins_sentences_as_icu_does) {
    ASSERT_TRUE(std::setlocale(LC_CTYPE, "C.UTF-8"));  // which the C library of a page always uses
    for (const char* text :
         {"", "kitchen", "Kitchen", "über", "éclair", "ß", "šatna", "кухня", "κουζίνα", "1 step", "日本", "\xff"})
        EXPECT_EQ(plain_capitalised(text), capitalised(text)) << text;
}

}  // namespace message_test
}  // namespace handrail
