// Shows lists to choose from, and questions that the person answers by typing a line. All features use these two kinds,
// which behave alike in speech, in the terminal, in the window and for screen readers. They form a stack: when the
// person leaves a list that opened over another list, the other list returns. Plain state without a clock or a world.
// Each function returns the text to announce, and calls the functions that the caller gave for a choice. Use it on the
// app thread only.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace handrail::core {

// A quantity for screen readers. The item's `value` gives the same quantity in words.
struct ItemNumber {
    double now = 0.0, least = 0.0, most = 0.0;
    double step = 0.0;  // smallest difference between two possible values
    bool operator==(const ItemNumber&) const = default;
};

struct ListItem {
    std::string name;
    std::string value;  // announced after the name; empty: there is no value
    bool adjustable = false;
    std::optional<ItemNumber> number{};  // set if the item is adjustable and its value is a quantity
    // A question that a person may type to choose the item; never announced or shown.
    std::string also_typed{};
};

struct ListSpec {
    std::string title;
    std::vector<ListItem> items;
    std::size_t at = 0;                       // index of the selected item
    std::function<void(std::size_t)> chosen;  // called when the person presses Enter
    std::function<std::string(std::size_t, int)>
        adjusted{};  // Called by Left (-1) and Right (+1) on an adjustable item; returns the new value in words.
    // Sets the quantity of an item to a number; returns the new value in words.
    std::function<std::string(std::size_t, double)> put{};
    std::function<void()> left{};  // called when the person presses Escape
    // Entries that a typed name also chooses, but that the list does not show. `chosen` receives their index plus the
    // number of `items`. Typed letters that fit no item replace the items by these entries.
    std::vector<ListItem> hidden{};
    bool stays_open = false;  // false: Enter closes this list and all lists under it before it calls `chosen`
};

// A question that the person answers by typing a text of at most kLongestTyped bytes of UTF-8. Blanks at both ends are
// removed. An empty text is not accepted.
struct TextSpec {
    std::string question;
    std::string text;  // text that is there before the person types
    std::function<void(std::string)> done;
    std::function<void()> left{};
};
inline constexpr std::size_t kLongestTyped = 200;

// The part of the dialogue that the window and screen readers show.
struct DialogueView {
    enum class Kind { None, List, Text } kind = Kind::None;
    std::string title;  // title of the list, or the question
    std::vector<ListItem> items;
    std::size_t at = 0;
    std::string text;   // text typed until now
    std::string where;  // announcement of the selected item or of the question

    bool operator==(const DialogueView&) const = default;
};
bool operator==(const ListItem& a, const ListItem& b);

// The result of a key, of typed characters or of a line.
struct DialogueReply {
    bool taken = false;  // false: the input has no meaning in this dialogue
    bool denied = false;
    std::string words;  // text to announce; may be empty
    struct Answer {
        std::string question, text;
    };
    std::optional<Answer> answer = {};  // set if a text question was answered
};

// An action of a screen reader on any item of the open list. `name` is the name of the item as it was shown. If the
// item has another name by now, nothing happens.
struct ItemAct {
    enum class Kind { GoTo, Choose, Less, More, Put } kind = Kind::Choose;
    std::size_t item = 0;
    std::string name;
    double number = 0.0;  // the new number, only for Put
};

// Returns true if `typed` is this name, perhaps after words such as "to" and "the".
bool is_called(std::string_view name, std::string_view typed);

// Returns the entry that the line `typed` chooses: by its exact name, by the number of an item, or by the beginning of
// its name or of a word in it. Hidden entries follow the items. Returns no value if nothing matches. "To the kitchen"
// finds the kitchen, unless a name begins with "to". Umlauts may be written out.
std::optional<std::size_t> entry_called(const ListSpec& list, std::string_view typed);
// Returns true if `typed` is the complete name of this entry, or its `also_typed`.
bool is_called(const ListSpec& list, std::size_t entry, std::string_view typed);

class Dialogue {
public:
    // Open a list or a question, and return the text to announce. A list without items does not open, and the text says
    // so.
    std::string open(ListSpec list);
    std::string request_text(TextSpec question);
    bool is_open() const { return !stack_.empty(); }
    bool typing() const;
    void close_all() { stack_.clear(); }

    // Processes a key that was pressed or that repeats while it is held. `name` is the name of the key.
    DialogueReply key(std::string_view name, double now_s);
    // Processes characters from the keyboard layout. In a list, they search for a name that begins with them.
    DialogueReply typed(std::string_view utf8, double now_s);
    // Processes a line typed in a terminal. For a question, the line is the answer. In a list, the line may be:
    // - the name of a key (down, up, home, end, enter, escape, left, right, backspace),
    // - "list", which announces all items,
    // - the number of an item, the beginning of its name, or its `also_typed`.
    DialogueReply line(std::string_view line, double now_s);

    // Returns true if the open list would accept this line as the name of a key, as "list", or as the choice of an
    // item.
    bool has_use_for(std::string_view line) const;

    DialogueReply act(const ItemAct& act, double now_s);

    // Replaces the items of the open list. `at` stays the same if there are enough items. Does nothing if no list is
    // open.
    void change_items(std::vector<ListItem> items);

    DialogueView view() const;
    // Returns the announcement of the selected item, or of the question and its text. Returns an empty text if nothing
    // is open.
    std::string where() const;

private:
    using Part = std::variant<ListSpec, TextSpec>;
    DialogueReply list_key(ListSpec& list, std::string_view name, double now_s);
    // Returns true if the next character would continue the name that the person is typing.
    bool search_goes_on(double now_s) const;
    DialogueReply search(ListSpec& list, bool goes_on, double now_s);
    DialogueReply text_key(TextSpec& question, std::string_view name);
    DialogueReply choose(ListSpec& list, std::size_t at);
    template <class Change>
    DialogueReply change_value(ListSpec& list, Change change);
    DialogueReply finish(TextSpec& question);
    DialogueReply leave();
    std::string item_words(const ListSpec& list) const;
    // Returns the announcement when a list or question is on top again.
    std::string back_words() const;

    // Each list or question is stored behind a pointer, so that it keeps its address while others open over it.
    std::vector<std::unique_ptr<Part>> stack_;
    std::string search_;
    double searched_s_ = -1e9;
};

}  // namespace handrail::core
