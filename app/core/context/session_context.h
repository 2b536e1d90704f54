// Provides everything that a feature of a session may read and request. The session makes one context, and each feature
// keeps a reference to that context. The context owns nothing, and features only read its const members. A feature that
// needs another feature gets a reference to it in its constructor. Use the context on the app thread only.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "app/core/context/cues.h"
#include "app/core/context/hands_state.h"
#include "app/core/context/lists.h"
#include "app/core/context/owner_requests.h"
#include "app/core/context/person.h"
#include "app/core/context/session_event.h"
#include "app/core/kept/side_file.h"
#include "app/core/world/walker_state.h"
#include "app/core/world/world_state.h"
#include "worlds/base/arrivals.h"
#include "worlds/base/contract.h"
#include "worlds/base/executor.h"
#include "worlds/base/language.h"
#include "worlds/base/result.h"

namespace handrail::core {

class RoomsKept;

// Requests that involve several features. Only the session can carry them out, so it sets all of these functions.
struct SessionRequests {
    // Saves what the person added to the world. If another session has changed the same file, all sessions read the
    // file again. If the file could not be written, the session announces that, returns false and tries again later.
    std::function<bool(double now_s)> save_additions;
    // Moves the walker, and the hand's workspace with the walker, to another place in this world.
    std::function<void(const Vec3& feet_m, double heading_rad, double now_s)> place;
    // Makes this place the base of the world until a world is entered again.
    std::function<void(const Vec3& feet_m, double heading_rad)> move_base;
    // Has the same effect as pressing and releasing the command's key.
    std::function<void(Command command, double now_s)> perform;
    // Changes the setting with this key, for example "workspace.scale" or "keys.forward". The change is effective at
    // once and saved. On failure, it returns a sentence as the error and changes nothing.
    std::function<Result<void>(std::string_view key, const std::string& value, double now_s)> set;
};

struct SessionContext {
    const settings::Settings& settings;
    const KeyMap& keys;
    const WorldState& world;
    const WalkerState& avatar;
    const HandsState& hands;
    Cues& cues;
    Lists& lists;
    SideFile& additions;  // what the person added to the present world; each feature writes its own lists and tables
    Events& events;
    OwnerRequests& requests;
    const Executor& executor;  // runs background tasks
    Arrivals* arrivals;        // receives the results of background tasks; may be null
    RoomsKept* rooms_kept;     // rooms kept by other sessions in the same world; may be null
    SessionRequests session_requests = {};
    // Time of the last tick. Everything that a list or question triggers happens at this time.
    double tick_s = -1.0;

    void say(std::string text, cues::SpeechClass speech_class, double now_s) const {
        cues.say(std::move(text), speech_class, now_s);
    }
    void announce(cues::SpeechTopic topic, std::string text, double now_s,
                  const Cues::AnnounceOptions& how = {}) const {
        cues.announce(topic, std::move(text), now_s, how);
    }
    void warn(std::string text, double now_s) const { cues.warn(std::move(text), now_s); }
    void answer(std::string text, double now_s) const { cues.answer(std::move(text), now_s); }
    // Saves what the person has just added, then says `words`. If saving failed, the announcement adds a sentence about
    // that.
    void keep_and_answer(const std::string& words, double now_s) const {
        answer(session_requests.save_additions(now_s) ? words : phrase("guide.not_saved", {{"words", words}}), now_s);
    }
    // Sets a setting to a value that is known to be valid.
    void set(std::string_view key, const std::string& value, double now_s) const {
        const bool fits = session_requests.set(key, value, now_s).has_value();
        contract_pre(fits);
    }
    void play(cues::SoundKind kind, double now_s) const { cues.play(kind, now_s); }
    void play_at(cues::SoundKind kind, const Vec3& place_m, double now_s) const { cues.play_at(kind, place_m, now_s); }
    void open_list(ListSpec list, double now_s) const { lists.open(std::move(list), now_s); }
    void request_text(TextSpec question, double now_s) const { lists.request_text(std::move(question), now_s); }
};

}  // namespace handrail::core
