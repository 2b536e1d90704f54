#include "app/core/dialogue/typed_words.h"

#include <algorithm>
#include <utility>

#include "app/core/dialogue/command_words.h"

namespace handrail::core {

std::vector<TypedWord> typed_words(std::string_view text) {
    constexpr std::string_view kBetween = " \t\r\n,.;:!?\"()-";
    std::vector<TypedWord> words;
    bool after_comma = false;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of(kBetween, begin), text.size());
        const std::string_view written = text.substr(begin, end - begin);
        TypedWord word{plain_word(written), std::string(written), begin > 0 && text[begin - 1] == '-' ? '-' : ' '};
        for (const std::string_view apostrophe : {"'", "\xe2\x80\x99"}) {
            word.has_apostrophe_s |= word.plain.ends_with(std::string(apostrophe) + "s");
            for (std::size_t at; (at = word.plain.find(apostrophe)) != std::string::npos;)
                word.plain.erase(at, apostrophe.size());
        }
        word.after_comma = after_comma;
        if (!word.plain.empty()) {
            words.push_back(std::move(word));
            after_comma = false;
        }
        after_comma |= end < text.size() && text[end] == ',';
        begin = end + 1;
    }
    return words;
}

std::vector<std::vector<TypedWord>> typed_parts(std::string_view text) {
    std::vector<std::vector<TypedWord>> parts;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('|', begin), text.size());
        parts.push_back(typed_words(text.substr(begin, end - begin)));
        begin = end + 1;
    }
    return parts;
}

std::string written_from(const std::vector<TypedWord>& words, std::size_t first, bool commas) {
    std::string text;
    for (std::size_t i = first; i < words.size(); ++i) {
        if (i > first && commas && words[i].after_comma) text += ',';
        if (i > first) text += words[i].before;
        text += words[i].written;
    }
    return text;
}

}  // namespace handrail::core
