#include "app/window/key_gate.h"

namespace handrail::window {

void KeyGate::take(const Key& key, const KeyStroke& stroke, double now_s) {
    waiting_.push_back({key, reader_.offer ? reader_.offer(stroke) : 0, now_s, {}});
}

bool KeyGate::take_text(const std::string& utf8) {
    if (waiting_.empty()) return false;
    waiting_.back().text += utf8;
    return true;
}

std::vector<KeyGate::Passed> KeyGate::decided(double now_s) {
    std::vector<Passed> passed;
    while (!waiting_.empty()) {
        const Waiting& first = waiting_.front();
        KeyVerdict verdict = first.ticket == 0 ? KeyVerdict::Ours : reader_.verdict(first.ticket);
        if (verdict == KeyVerdict::Waiting) {
            if (now_s - first.since_s < kPatience_s) break;
            verdict = KeyVerdict::Ours;
        }
        passed.push_back({first.key, first.text, verdict == KeyVerdict::Ours});
        waiting_.pop_front();
    }
    return passed;
}

}  // namespace handrail::window
