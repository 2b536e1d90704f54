// Lists to choose from and lines to type. Everything uses these two kinds, and they work alike in speech, in the
// terminal, in the window and for screen readers. They form a stack: a list that opens over another returns to it when
// it is left. Plain state without a clock or a world. It returns what to announce, and calls the caller's functions for
// what was chosen. App thread only.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace handrail::core {

// A quantity for a screen reader; the item's `value` gives it in words.
struct ItemNumber {
    double now = 0.0, least = 0.0, most = 0.0;
    double step = 0.0;  // smallest difference between two possible values
    bool operator==(const ItemNumber&) const = default;
};

struct ListItem {
    std::string name;
    std::string value;  // announced after the name; empty: none
    bool adjustable = false;
    std::optional<ItemNumber> number{};  // of an adjustable item that is a quantity
    // A question that people also type to choose it; never announced or shown.
    std::string also_typed{};
};

struct ListSpec {
    std::string title;
    std::vector<ListItem> items;
    std::size_t at = 0;                       // selected at first
    std::function<void(std::size_t)> chosen;  // Enter
    std::function<std::string(std::size_t, int)>
        adjusted{};  // Called by Left (-1) and Right (+1) on an adjustable item; returns the new value in words.
    // Sets an item's quantity to a number; returns the new value in words.
    std::function<std::string(std::size_t, double)> put{};
    std::function<void()> left{};  // Escape
    bool stays_open = false;       // false: Enter closes this list and all lists under it before it calls `chosen`
};

// A text of at most kLongestTyped bytes of UTF-8. Surrounding blanks are removed, and it is never empty.
struct TextSpec {
    std::string question;
    std::string text;  // initial text
    std::function<void(std::string)> done;
    std::function<void()> left{};
};
inline constexpr std::size_t kLongestTyped = 200;

// What the window or a screen reader shows of the dialogue.
struct DialogueView {
    enum class Kind { None, List, Text } kind = Kind::None;
    std::string title;  // of the list, or the question
    std::vector<ListItem> items;
    std::size_t at = 0;
    std::string text;   // typed up to now
    std::string where;  // announcement for the selected item or the question

    bool operator==(const DialogueView&) const = default;
};
bool operator==(const ListItem& a, const ListItem& b);

// The result of a key.
struct DialogueReply {
    bool taken = false;  // false: the key has no meaning here
    bool denied = false;
    std::string words;  // to announce; may be empty
    struct Answer {
        std::string question, text;
    };
    std::optional<Answer> answer = {};  // set if a text question was answered
};

// An action of a screen reader on any item of the open list. `name` is the item's name as it was shown; if the list has
// changed since, nothing happens.
struct ItemAct {
    enum class Kind { GoTo, Choose, Less, More, Put } kind = Kind::Choose;
    std::size_t item = 0;
    std::string name;
    double number = 0.0;  // for Put
};

// True if `typed` is this name, without leading "to", "the" and the like.
bool is_called(std::string_view name, std::string_view typed);

class Dialogue {
public:
    // Both return what to announce. A list without items does not open, and the answer says so.
    std::string open(ListSpec list);
    std::string ask(TextSpec question);
    bool is_open() const { return !stack_.empty(); }
    bool typing() const;
    void close_all() { stack_.clear(); }

    // A key was pressed, given by name, or repeats while it is held.
    DialogueReply key(std::string_view name, double now_s);
    // Characters produced by the keyboard layout. In a list they search for names that begin with them.
    DialogueReply typed(std::string_view utf8, double now_s);
    // A line typed in a terminal. In a list it may be a key's name (down, up, home, end, enter, escape, left, right,
    // backspace), "list" for all items, an item's number, the beginning of its name, or its `also_typed`. For a
    // question it is the text itself.
    DialogueReply line(std::string_view line, double now_s);

    // True if such a line would choose an item of the open list by its number or name. by_all: only the complete name
    // counts; otherwise the beginning of the name or of a word in it is enough.
    bool holds(std::string_view typed, bool by_all = false) const;

    // True if the open list would accept such a line: as a key's name, as "list", or to choose an item.
    bool has_use_for(std::string_view line) const;

    DialogueReply act(const ItemAct& act, double now_s);

    // Replaces the items of the open list. `at` stays, if there are enough items. Without an open list, nothing
    // happens.
    void change_items(std::vector<ListItem> items);

    DialogueView view() const;
    // The selected item, or the question and its text; empty if nothing is open.
    std::string where() const;

private:
    using Part = std::variant<ListSpec, TextSpec>;
    DialogueReply list_key(ListSpec& list, std::string_view name, double now_s);
    // True if the next character continues the name that is being typed.
    bool search_goes_on(double now_s) const;
    DialogueReply search(ListSpec& list, bool goes_on, double now_s);
    DialogueReply text_key(TextSpec& question, std::string_view name);
    DialogueReply choose(ListSpec& list);
    template <class Change>
    DialogueReply change_value(ListSpec& list, Change change);
    DialogueReply finish(TextSpec& question);
    DialogueReply leave();
    std::string item_words(const ListSpec& list) const;
    // Announcement on return to the list or question that is now on top.
    std::string back_words() const;

    // Pointers, so that parts keep their address while others open over them.
    std::vector<std::unique_ptr<Part>> stack_;
    std::string search_;
    double searched_s_ = -1e9;
};

}  // namespace handrail::core
