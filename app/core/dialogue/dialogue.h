// Lists to choose from and lines to type, one kind of each for everything: the same in speech, in the terminal, in the
// picture and for screen readers. A stack: what opens over an open list gives it back when it is left. Plain state
// without a clock or a world; says what is to be said and does what was chosen through the caller's functions. App
// thread only.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace handrail {

// A quantity as a screen reader has it; `value` of the item says it in words.
struct ItemNumber {
    double now = 0.0, least = 0.0, most = 0.0;
    double step = 0.0;  // the smallest between two values it takes
    bool operator==(const ItemNumber&) const = default;
};

struct ListItem {
    std::string name;
    std::string value;  // said after the name; empty: none
    bool adjustable = false;
    std::optional<ItemNumber> number{};  // of an adjustable one that is a quantity
    // What people also type for it, as a question; never said or shown.
    std::string also_typed{};
};

struct ListSpec {
    std::string title;
    std::vector<ListItem> items;
    std::size_t at = 0;                       // where one begins
    std::function<void(std::size_t)> chosen;  // Enter
    std::function<std::string(std::size_t, int)>
        adjusted{};  // Left -1, Right +1 on an adjustable item; returns its value from now on, in words
    std::function<std::string(std::size_t, double)> put{};  // the quantity of an item, to a number; returns likewise
    std::function<void()> left{};                           // Escape
    bool stays_open = false;  // else Enter closes this list and all that it lies on, before `chosen` is called
};

// Text of at most kLongestTyped bytes of UTF-8, without blanks round it and never empty.
struct TextSpec {
    std::string question;
    std::string text;  // to begin with
    std::function<void(std::string)> done;
    std::function<void()> left{};
};
inline constexpr std::size_t kLongestTyped = 200;

// What a picture or a screen reader shows of it.
struct DialogueView {
    enum class Kind { None, List, Text } kind = Kind::None;
    std::string title;  // or the question
    std::vector<ListItem> items;
    std::size_t at = 0;
    std::string text;   // typed so far
    std::string where;  // what is said of the item or question one is at

    bool operator==(const DialogueView&) const = default;
};
bool operator==(const ListItem& a, const ListItem& b);

// What a key did.
struct DialogueReply {
    bool taken = false;  // false: the key means nothing here
    bool denied = false;
    std::string words;  // to be said; may be empty
    struct Answer {
        std::string question, text;
    };
    std::optional<Answer> answer = {};  // that was given to a question for a text
};

// What somebody does with an item of the open list without going through it: a screen reader's action. `name` is the
// item's as it was shown; a list that has changed since does nothing.
struct ItemAct {
    enum class Kind { GoTo, Choose, Less, More, Put } kind = Kind::Choose;
    std::size_t item = 0;
    std::string name;
    double number = 0.0;  // for Put
};

// Whether that is what somebody typed, without "to", "the" and the like in front.
bool is_called(std::string_view name, std::string_view typed);

class Dialogue {
public:
    // Both return what is to be said. A list without items opens nothing and says so.
    std::string open(ListSpec list);
    std::string ask(TextSpec question);
    bool is_open() const { return !stack_.empty(); }
    bool typing() const;
    void close_all() { stack_.clear(); }

    // A key by name went down, or repeats while it is held.
    DialogueReply key(std::string_view name, double now_s);
    // Characters, as the keyboard's layout makes them of keys. In a list they look for names that begin so.
    DialogueReply typed(std::string_view utf8, double now_s);
    // A line of a terminal: the name of a key (down, up, home, end, enter, escape, left, right, backspace), "list" for
    // all items, an item's number, the begin of its name or what is also typed for it; for a question the text itself.
    DialogueReply line(std::string_view line, double now_s);

    // Whether such a line would choose an item of the open list by its number or name; by all of its name, or only by
    // the begin of it or of a word in it, too.
    bool holds(std::string_view typed, bool by_all = false) const;

    // Whether the open list has a use for such a line: as a key's name, for all items, or to choose an item.
    bool has_use_for(std::string_view line) const;

    DialogueReply act(const ItemAct& act, double now_s);

    // What stands in the open list is other now; `at` stays where it is, as far as there is one. Nothing without an
    // open list.
    void change_items(std::vector<ListItem> items);

    DialogueView view() const;
    // The item, or question and text, that one is at; empty without any.
    std::string where() const;

private:
    using Part = std::variant<ListSpec, TextSpec>;
    DialogueReply list_key(ListSpec& list, std::string_view name, double now_s);
    // Whether what is typed next belongs to the name that is being typed.
    bool search_goes_on(double now_s) const;
    DialogueReply search(ListSpec& list, bool goes_on, double now_s);
    DialogueReply text_key(TextSpec& question, std::string_view name);
    DialogueReply choose(ListSpec& list);
    template <class Change>
    DialogueReply change_value(ListSpec& list, Change change);
    DialogueReply finish(TextSpec& question);
    DialogueReply leave();
    std::string item_words(const ListSpec& list) const;
    // What is said on being back in what lies on top now.
    std::string back_words() const;

    std::vector<std::unique_ptr<Part>> stack_;  // by pointer: stays in place while others open over it
    std::string search_;
    double searched_s_ = -1e9;
};

}  // namespace handrail
