// Lets a screen reader have each key before we act on it. The question goes out at once and the answer is fetched
// later, so the app's loop never waits for another program; keys stay in order meanwhile. A reader that does not answer
// in time has lost its say. App thread.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace handrail {

// A key as X and screen readers know it.
struct KeyStroke {
    bool press = true;
    unsigned state = 0;  // X's modifier bits
    unsigned keycode = 0;
    unsigned keysym = 0;
    std::string name;  // of the keysym: "Return"
};

enum class KeyVerdict { Waiting, Ours, Readers };

struct KeyReader {
    std::function<std::uint64_t(const KeyStroke&)> offer;  // a number to ask with; 0: no reader is there
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
        std::string text;  // that it typed, UTF-8
        bool ours = true;  // else the reader used it up
    };

    void set_reader(KeyReader reader) { reader_ = std::move(reader); }
    void take(const Key& key, const KeyStroke& stroke, double now_s);
    // Typed by the key taken last; false when that one is not here any more.
    bool take_text(const std::string& utf8);
    // Decided since the last call, in the order they came.
    std::vector<Passed> decided(double now_s);
    // The keyboard went elsewhere: what has not been decided is dropped.
    void clear() { waiting_.clear(); }

private:
    struct Waiting {
        Key key;
        std::uint64_t ticket = 0;  // 0: ours
        double since_s = 0.0;
        std::string text;
    };
    KeyReader reader_;
    std::deque<Waiting> waiting_;
};

}  // namespace handrail
