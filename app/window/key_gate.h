// Offers each key to a screen reader before the program acts on the key. This class sends the request at once and
// fetches the answer later, so the app's loop never waits for another program. Keys keep their order. If a reader does
// not answer in time, the program acts on the key. App thread.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace handrail::window {

// A key as X and screen readers describe it.
struct KeyStroke {
    bool press = true;
    unsigned state = 0;  // X's modifier bits
    unsigned keycode = 0;
    unsigned keysym = 0;
    std::string name;  // name of the keysym, such as "Return"
};

enum class KeyVerdict { Waiting, Ours, Readers };

struct KeyReader {
    // `offer` offers a key to the reader. It returns a ticket, with which `verdict` returns the reader's answer; 0: no
    // reader listens.
    std::function<std::uint64_t(const KeyStroke&)> offer;
    std::function<KeyVerdict(std::uint64_t)> verdict;
};

class KeyGate {
public:
    static constexpr double kPatience_s = 0.25;

    struct Key {
        int glfw_key = 0, glfw_action = 0, glfw_modifiers = 0;
    };
    struct Passed {
        Key key;
        std::string text;  // the text in UTF-8 that the key typed
        bool ours = true;  // false: the reader has used the key, so the program ignores it
    };

    void set_reader(KeyReader reader) { reader_ = std::move(reader); }
    void take(const Key& key, const KeyStroke& stroke, double now_s);
    // Adds the text that the last key typed. Returns false if decided() has already returned that key.
    bool take_text(const std::string& utf8);
    // Returns the keys that were decided since the last call, in the order in which they were pressed.
    std::vector<Passed> decided(double now_s);
    // Call this function when the window loses the keyboard. Drops all undecided keys.
    void clear() { waiting_.clear(); }

private:
    struct Waiting {
        Key key;
        std::uint64_t ticket = 0;  // 0: no reader was asked, so the program acts on the key
        double since_s = 0.0;
        std::string text;
    };
    KeyReader reader_;
    std::deque<Waiting> waiting_;
};

}  // namespace handrail::window
