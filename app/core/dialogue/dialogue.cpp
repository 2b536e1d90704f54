#include "app/core/dialogue/dialogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "app/core/dialogue/command_words.h"
#include "app/core/dialogue/typed_sentences.h"
#include "app/core/dialogue/words.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {
namespace {

// Adds a full stop unless the text already ends a sentence.
std::string as_sentence(std::string text) {
    if (text.empty() || std::string_view(".?!").find(text.back()) == std::string_view::npos) text += '.';
    return text;
}

constexpr double kSearchGoesOn_s = 1.0;  // a letter typed within this time after the last one continues the same word

std::string_view without_blanks(std::string_view text) {
    constexpr std::string_view kBlank = " \t\r\n";
    const std::size_t first = text.find_first_not_of(kBlank);
    return first == std::string_view::npos ? std::string_view{}
                                           : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

bool begins_with(const std::string& name, const std::string& begin) {
    return !begin.empty() && lower_ascii(name).starts_with(begin);
}

// Returns true if any word of the name except the first begins with `begin`.
bool holds_word(const std::string& name, const std::string& begin) {
    const std::string lower = lower_ascii(name);
    for (std::size_t at = lower.find(begin); at != std::string::npos; at = lower.find(begin, at + 1))
        if (at > 0 && (lower[at - 1] == ' ' || lower[at - 1] == '-')) return true;
    return false;
}

// Returns true if `typed` is the item's `also_typed` text. The person may omit the question mark.
bool is_also_called(const ListItem& item, std::string_view typed) {
    if (typed.ends_with('?')) typed.remove_suffix(1);
    return !item.also_typed.empty() && is_called(item.also_typed, typed);
}

std::size_t entry_count(const ListSpec& list) { return list.items.size() + list.hidden.size(); }

const ListItem& entry(const ListSpec& list, std::size_t at) {
    return at < list.items.size() ? list.items[at] : list.hidden[at - list.items.size()];
}

// Joins two sentences, and adds a full stop to the first if it has none.
std::string sentences(const std::string& first, const std::string& then) {
    const bool ends = !first.empty() && std::string_view(".?!:").find(first.back()) != std::string_view::npos;
    return first + (ends ? " " : ". ") + then;
}

// Removes the last whole UTF-8 character from `text` and returns it.
std::string take_last_character(std::string& text) {
    std::size_t begin = text.size();
    while (begin > 0 && (static_cast<unsigned char>(text[--begin]) & 0xC0U) == 0x80U) {
    }
    std::string last = text.substr(begin);
    text.resize(begin);
    return last;
}

// Returns the key that this word stands for, or an empty text.
std::string_view key_of_word(std::string_view word) {
    constexpr std::string_view kKeys[] = {"Down", "Up", "Home", "End", "Enter", "Escape", "Left", "Right", "Space"};
    const auto* const found =
        std::find_if(std::begin(kKeys), std::end(kKeys), [&](auto name) { return lower_ascii(name) == word; });
    return found == std::end(kKeys) ? std::string_view{} : *found;
}

std::string spoken_character(const std::string& character) {
    return character == " " ? phrase("dialogue.space") : character;
}

}  // namespace

bool is_called(std::string_view name, std::string_view typed) {
    const std::string is = plain_word(name);
    return is == plain_word(typed) || is == plain_word(without_fillers(typed));
}

std::optional<std::size_t> entry_called(const ListSpec& list, std::string_view typed) {
    typed = without_blanks(typed);
    const std::size_t count = entry_count(list);
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(typed.data(), typed.data() + typed.size(), number);
    const bool is_number = error == std::errc{} && end == typed.data() + typed.size();
    // Platforms and rooms may have numbers as names. A name is preferred to the number of an item, because the person
    // has heard the name.
    for (std::size_t i = 0; is_number && i < count; ++i)
        if (entry(list, i).name == typed) return i;
    if (is_number && number >= 1 && number <= list.items.size()) return number - 1;
    const auto is = [](const std::string& name, const std::string& all) { return name == all; };
    for (const std::string& wanted : {plain_word(typed), plain_word(without_fillers(typed))})
        for (const auto fits : {+is, begins_with, holds_word})
            for (std::size_t i = 0; i < count && !wanted.empty(); ++i)
                if (fits(plain_word(entry(list, i).name), wanted)) return i;
    for (std::size_t i = 0; i < count; ++i)
        if (is_also_called(entry(list, i), typed)) return i;
    return std::nullopt;
}

bool is_called(const ListSpec& list, std::size_t at, std::string_view typed) {
    return is_called(entry(list, at).name, typed) || is_also_called(entry(list, at), typed);
}

bool operator==(const ListItem& a, const ListItem& b) {
    return a.name == b.name && a.value == b.value && a.adjustable == b.adjustable && a.number == b.number;
}

std::string Dialogue::open(ListSpec list) {
    if (list.items.empty()) return phrase("dialogue.nothing_there", {{"title", list.title}});
    list.at = std::min(list.at, list.items.size() - 1);
    search_.clear();
    stack_.push_back(std::make_unique<Part>(std::move(list)));
    return back_words();
}

std::string Dialogue::request_text(TextSpec question) {
    stack_.push_back(std::make_unique<Part>(std::move(question)));
    return sentences(back_words(), phrase("dialogue.escape_cancels"));
}

bool Dialogue::typing() const { return is_open() && std::holds_alternative<TextSpec>(*stack_.back()); }

std::string Dialogue::item_words(const ListSpec& list) const {
    const ListItem& item = list.items[list.at];
    // If one part ends and the next begins with a digit, a semicolon separates them: "Room 3; 12 steps, 4 of 28".
    const std::string words =
        item.value.empty() ? item.name : item.name + (ends_in_digit(item.name) ? "; " : ", ") + item.value;
    const bool digit = ends_in_digit(words);
    return phrase(
        "dialogue.item",
        {{"item", words}, {"digit", digit ? "yes" : "no"}, {"number", list.at + 1}, {"count", list.items.size()}});
}

std::string Dialogue::where() const {
    if (!is_open()) return {};
    if (const auto* list = std::get_if<ListSpec>(stack_.back().get())) return item_words(*list);
    const auto& question = std::get<TextSpec>(*stack_.back());
    return question.text.empty() ? question.question : sentences(question.question, question.text);
}

std::string Dialogue::back_words() const {
    if (!is_open()) return {};
    if (const auto* list = std::get_if<ListSpec>(stack_.back().get()))
        return fmt::format("{} {}", as_sentence(list->title), item_words(*list));
    return where();
}

DialogueReply Dialogue::key(std::string_view name, double now_s) {
    if (!is_open()) return {};
    Part& top = *stack_.back();
    if (name == "Escape") return leave();
    if (auto* list = std::get_if<ListSpec>(&top)) return list_key(*list, name, now_s);
    return text_key(std::get<TextSpec>(top), name);
}

DialogueReply Dialogue::list_key(ListSpec& list, std::string_view name, double now_s) {
    const std::size_t last = list.items.size() - 1, was = list.at;
    if (name == "Enter") return choose(list, list.at);
    if (name == "Left" || name == "Right") {
        if (!list.items[list.at].adjustable || !list.adjusted) return {true, true, item_words(list)};
        const int by = name == "Left" ? -1 : 1;
        return change_value(list, [&, adjusted = list.adjusted](std::size_t at) { return adjusted(at, by); });
    }
    if (name == "Down") list.at = std::min(list.at + 1, last);
    else if (name == "Up") list.at -= list.at > 0 ? 1 : 0;
    else if (name == "Home") list.at = 0;
    else if (name == "End") list.at = last;
    else if (name == "Space" && search_goes_on(now_s)) return typed(" ", now_s);
    else if (name == "Space") return {true, false, item_words(list)};
    else if (name == "F1") return {true, false, phrase("dialogue.help_list")};
    // Letters arrive as typed characters. While a list is open, every other key is ignored, so that it does not act in
    // the world.
    else return {true, false, {}};
    search_.clear();
    return {true, list.at == was, item_words(list)};
}

// `change` is a copy, because the function that it calls may open or close lists.
template <class Change>
DialogueReply Dialogue::change_value(ListSpec& list, Change change) {
    const std::size_t at = list.at;
    const std::string name = list.items[at].name;
    std::string value = change(at);
    // `change` may have replaced the items or moved this one, so the item is compared by name.
    if (is_open() && std::get_if<ListSpec>(stack_.back().get()) == &list && list.items[list.at].name == name)
        list.items[list.at].value = value;
    return {true, false, std::move(value)};
}

DialogueReply Dialogue::choose(ListSpec& list, std::size_t at) {
    const auto chosen = list.chosen;
    if (!list.stays_open) close_all();
    if (chosen) chosen(at);
    return {true, false, {}};
}

DialogueReply Dialogue::text_key(TextSpec& question, std::string_view name) {
    if (name == "Enter") return finish(question);
    if (name == "Backspace") {
        if (question.text.empty()) return {true, true, phrase("dialogue.nothing_typed")};
        return {true, false,
                phrase("dialogue.deleted", {{"letter", spoken_character(take_last_character(question.text))}})};
    }
    if (name == "Up" || name == "Down") return {true, false, where()};
    if (name == "F1") return {true, false, phrase("dialogue.help_text")};
    return {true, false, {}};
}

DialogueReply Dialogue::finish(TextSpec& question) {
    std::string text(without_blanks(question.text));
    if (text.empty()) return {true, true, phrase("dialogue.nothing_typed_leave")};
    const auto done = std::move(question.done);
    DialogueReply reply{true, false, {}, DialogueReply::Answer{std::move(question.question), text}};
    stack_.pop_back();
    if (done) done(std::move(text));
    return reply;
}

DialogueReply Dialogue::leave() {
    const std::unique_ptr<Part> part = std::move(stack_.back());
    stack_.pop_back();
    search_.clear();
    const auto& left = std::visit([](const auto& spec) -> const std::function<void()>& { return spec.left; }, *part);
    if (left) left();
    if (!is_open()) return {true, false, left ? std::string() : phrase("dialogue.closed")};
    return {true, false, back_words()};
}

DialogueReply Dialogue::typed(std::string_view utf8, double now_s) {
    if (!is_open()) return {};
    if (auto* question = std::get_if<TextSpec>(stack_.back().get())) {
        if (!is_utf8(utf8)) return {true, true, {}};
        if (question->text.size() + utf8.size() > kLongestTyped) return {true, true, phrase("dialogue.too_long")};
        question->text += utf8;
        return {true, false, spoken_character(std::string(utf8))};
    }
    auto& list = std::get<ListSpec>(*stack_.back());
    const std::string letters = lower_ascii(utf8);
    // A blank arrives twice: first as a key, then as a character. The key has already repeated the item or continued
    // the name, so the character is ignored.
    if (letters == " " && (!search_goes_on(now_s) || search_.ends_with(' '))) return {true, false, {}};
    const bool goes_on = search_goes_on(now_s) && search_ != letters;
    search_ = goes_on ? search_ + letters : letters;
    return search(list, goes_on, now_s);
}

bool Dialogue::search_goes_on(double now_s) const { return !search_.empty() && now_s - searched_s_ < kSearchGoesOn_s; }

DialogueReply Dialogue::search(ListSpec& list, bool goes_on, double now_s) {
    searched_s_ = now_s;
    // While the person continues a word, the search may stay at the present item. A first letter begins the search at
    // the next item. Names that begin with the letters come first, then names in which a later word begins with the
    // letters.
    for (const auto fits : {begins_with, holds_word})
        for (std::size_t step = goes_on ? 0 : 1; step <= list.items.size(); ++step) {
            const std::size_t i = (list.at + step) % list.items.size();
            if (!fits(list.items[i].name, search_)) continue;
            list.at = i;
            return {true, false, item_words(list)};
        }
    // Hidden entries are shown as soon as the person types the beginning of a name.
    for (const auto fits : {begins_with, holds_word})
        for (std::size_t i = 0; i < list.hidden.size(); ++i) {
            if (!fits(list.hidden[i].name, search_)) continue;
            list.chosen = [chosen = list.chosen, before = list.items.size()](std::size_t at) { chosen(before + at); };
            list.items = std::exchange(list.hidden, {});
            list.at = i;
            return {true, false, item_words(list)};
        }
    return {true, true, phrase("dialogue.nothing_begins", {{"letters", search_}})};
}

DialogueReply Dialogue::line(std::string_view text, double now_s) {
    if (!is_open()) return {};
    text = without_blanks(text);
    const std::string word = lower_ascii(text);
    auto* list = std::get_if<ListSpec>(stack_.back().get());
    if (!list) {
        auto& question = std::get<TextSpec>(*stack_.back());
        if (list_word(text) == "escape") return leave();
        if (text.empty() && question.text.empty()) return {true, false, where()};
        if (text.size() > kLongestTyped || !is_utf8(text)) return {true, true, phrase("dialogue.too_long")};
        if (!text.empty()) question.text = text;
        return finish(question);
    }
    if (text.empty()) return {true, false, item_words(*list)};
    const auto as_key = [&](std::string_view key_word) -> std::optional<DialogueReply> {
        if (const std::string_view name = key_of_word(key_word); !name.empty()) return key(name, now_s);
        if (key_word != "list") return std::nullopt;
        std::string all = as_sentence(list->title);
        for (std::size_t i = 0; i < list->items.size(); ++i) {
            const ListItem& item = list->items[i];
            all += fmt::format(" {}: {}{}{}.", i + 1, item.name, item.value.empty() ? "" : ", ", item.value);
        }
        return DialogueReply{true, false, std::move(all)};
    };
    if (auto done = as_key(word)) return *done;
    const auto found = entry_called(*list, text);
    if (!found) {
        // Item names are tried before the spoken language's words for keys, because both may begin with the same
        // letters.
        if (auto done = as_key(list_word(text))) return *done;
        return {true, true, phrase("dialogue.not_in_list", {{"typed", text}})};
    }
    if (*found < list->items.size()) list->at = *found;
    return choose(*list, *found);
}

bool Dialogue::has_use_for(std::string_view line) const {
    const std::string word = list_word(lower_ascii(without_blanks(line)));
    const auto* list = is_open() ? std::get_if<ListSpec>(stack_.back().get()) : nullptr;
    return word.empty() || word == "list" || !key_of_word(word).empty() || (list && entry_called(*list, line));
}

DialogueReply Dialogue::act(const ItemAct& act, double now_s) {
    auto* list = is_open() ? std::get_if<ListSpec>(stack_.back().get()) : nullptr;
    if (!list || act.item >= list->items.size() || list->items[act.item].name != act.name) return {};
    list->at = act.item;
    search_.clear();
    switch (act.kind) {
        case ItemAct::Kind::GoTo:
            return {true, false, item_words(*list)};
        case ItemAct::Kind::Choose:
            return key("Enter", now_s);
        case ItemAct::Kind::Less:
            return key("Left", now_s);
        case ItemAct::Kind::More:
            return key("Right", now_s);
        case ItemAct::Kind::Put:
            if (!list->items[act.item].number || !list->put) return {true, true, item_words(*list)};
            return change_value(*list, [&, put = list->put](std::size_t at) { return put(at, act.number); });
    }
    return {};
}

void Dialogue::change_items(std::vector<ListItem> items) {
    auto* list = is_open() ? std::get_if<ListSpec>(stack_.back().get()) : nullptr;
    if (!list || items.empty()) return;
    const std::string name = list->items[list->at].name;
    list->items = std::move(items);
    list->at = std::min(list->at, list->items.size() - 1);
    if (list->items[list->at].name == name) return;
    for (std::size_t i = 0; i < list->items.size(); ++i)
        if (list->items[i].name == name) list->at = i;
}

DialogueView Dialogue::view() const {
    if (!is_open()) return {};
    if (const auto* list = std::get_if<ListSpec>(stack_.back().get()))
        return {DialogueView::Kind::List, list->title, list->items, list->at, {}, where()};
    const auto& question = std::get<TextSpec>(*stack_.back());
    return {DialogueView::Kind::Text, question.question, {}, 0, question.text, where()};
}

}  // namespace handrail::core
