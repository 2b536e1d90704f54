// Offers each key to a screen reader before the program acts on it. The request is sent at once and the answer is
// fetched later, so the app's loop never waits for another program; keys stay in order meanwhile. If a reader does not
// answer in time, the key is ours. App thread.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace handrail::window {

// A key in the terms of X and screen readers.
struct KeyStroke {
    bool press = true;
    unsigned state = 0;  // X's modifier bits
    unsigned keycode = 0;
    unsigned keysym = 0;
    std::string name;  // name of the keysym: "Return"
};

enum class KeyVerdict { Waiting, Ours, Readers };

struct KeyReader {
    // Returns a ticket for fetching the answer; 0: no reader listens.
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
        std::string text;  // the text that the key typed, UTF-8
        bool ours = true;  // false: the reader has used the key up
    };

    void set_reader(KeyReader reader) { reader_ = std::move(reader); }
    void take(const Key& key, const KeyStroke& stroke, double now_s);
    // Adds the text that the last key typed. Returns false if that key has already been passed on.
    bool take_text(const std::string& utf8);
    // The keys decided since the last call, in the order in which they came.
    std::vector<Passed> decided(double now_s);
    // Call it when the window loses the keyboard; drops all undecided keys.
    void clear() { waiting_.clear(); }

private:
    struct Waiting {
        Key key;
        std::uint64_t ticket = 0;  // 0: no reader was asked, so the key is ours
        double since_s = 0.0;
        std::string text;
    };
    KeyReader reader_;
    std::deque<Waiting> waiting_;
};

}  // namespace handrail::window
