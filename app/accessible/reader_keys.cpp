#include "app/accessible/reader_keys.h"

#include <iterator>

#include "app/accessible/nodes.h"

namespace handrail::accessible {

std::uint64_t ReaderKeys::offer(const window::KeyStroke& stroke, double now_s) {
    if (!listened_to_) return 0;
    const std::lock_guard lock(mutex_);
    if (!offered_.empty() && now_s - offered_.front().since_s > window::KeyGate::kPatience_s) return 0;
    offered_.push_back({++last_ticket_, stroke, now_s});
    return last_ticket_;
}

window::KeyVerdict ReaderKeys::verdict(std::uint64_t ticket) {
    const std::lock_guard lock(mutex_);
    const auto found = verdicts_.find(ticket);
    if (found == verdicts_.end()) return ticket <= answered_ ? window::KeyVerdict::Ours : window::KeyVerdict::Waiting;
    const window::KeyVerdict verdict = found->second;
    verdicts_.erase(verdicts_.begin(), std::next(found));
    return verdict;
}

void ReaderKeys::set_heard(bool heard) { listened_to_ = heard && key_listener().listens; }

void ReaderKeys::query_reader() {
    for (;;) {
        Offered key;
        {
            const std::lock_guard lock(mutex_);
            if (offered_.empty()) return;
            key = offered_.front();
        }
        bool used = false;
        if (const KeyListener& reader = key_listener(); reader.listens) {
            AtkKeyEventStruct event{};
            event.type = key.stroke.press ? ATK_KEY_EVENT_PRESS : ATK_KEY_EVENT_RELEASE;
            event.state = key.stroke.state;
            event.keyval = key.stroke.keysym;
            event.string = key.stroke.name.data();
            event.length = static_cast<gint>(key.stroke.name.size());
            event.keycode = static_cast<guint16>(key.stroke.keycode);
            event.timestamp = static_cast<guint32>(1000.0 * key.since_s);
            used = reader.listens(&event, reader.data) != 0;
        }
        const std::lock_guard lock(mutex_);
        if (!offered_.empty() && offered_.front().ticket == key.ticket) offered_.pop_front();
        answered_ = key.ticket;
        verdicts_[key.ticket] = used ? window::KeyVerdict::Readers : window::KeyVerdict::Ours;
    }
}

}  // namespace handrail::accessible
