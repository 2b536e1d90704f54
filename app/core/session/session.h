// Runs a session: it knows where the person is in the world, carries out commands, and makes the output for servos,
// sound and window. It has no window, device, sound library, thread or clock. The caller ticks it about 60 times a
// second and passes its outputs on. Use it on the app thread only.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/core/bodies/bodies.h"
#include "app/core/context/leave_requested.h"
#include "app/core/context/session_state.h"
#include "app/core/context/soundscape.h"
#include "app/core/context/touch_events.h"
#include "app/core/desk/desk_visit.h"
#include "app/core/labyrinth/labyrinth.h"
#include "app/core/lessons/lesson_session.h"
#include "app/core/menu/menu.h"
#include "app/core/menu/simplified_list.h"
#include "app/core/session/hand_output.h"
#include "app/core/session/hand_path.h"
#include "app/core/session/lesson_view.h"
#include "app/core/session/session_features.h"
#include "app/core/session/session_input.h"
#include "app/core/session/session_options.h"
#include "app/core/wayfinding/guide.h"
#include "audio-cues/plan/cue_planner.h"
#include "haptic/servo/servo_tick.h"
#include "settings/settings.h"
#include "worlds/base/background_task.h"

namespace handrail::core {

inline constexpr double kFrame_s = 1.0 / 60.0;  // time between two ticks in real time

class Session {
public:
    Session(const settings::Settings& settings, const HandFacts& hand, const SessionOptions& options = {});
    Session(const Session&) = delete;  // not copyable, because open lists and waiting sounds keep its address
    Session& operator=(const Session&) = delete;

    // Applies one input (session_input.h). All input goes through this function. Returns false if a key, text, line or
    // action was not used. tick() explains `now_s`.
    bool apply(SessionInput input, double now_s);

    // Functions that a recording sets. The session calls the functions of all recordings, one after the other. `comes`
    // gets each input with its time before the input acts. `not_taken` is called when apply() returns false for the
    // last input.
    struct InputListener {
        std::function<void(const SessionInput& input, double now_s)> comes;
        std::function<void()> not_taken;
    };
    void add_input_listener(InputListener listener) { watched_.inputs.push_back(std::move(listener)); }

    // Add, remove or move a thing while the session continues. A hand that touches the thing feels neither a knock nor
    // a gap. On failure, each function returns a sentence and changes nothing. worlds/scene/models.h lists the reasons.
    // Two more reasons are too many things and a speed that is not positive. The walker collides with a moving thing at
    // its position at that moment.
    Result<void> add_thing(const std::string& name, std::shared_ptr<const Scene> model, const Placement& at,
                           const std::string& material, double now_s);
    Result<void> remove_thing(const std::string& name, double now_s);
    Result<void> send_thing(const std::string& name, const Placement& to, double speed_m_per_s);
    // Returns the present position of the thing with this name, or no value if there is none.
    std::optional<Placement> thing_at(const std::string& name) const;

    // Returns the state of the session for a teacher. The call casts some rays. The first call in each room examines
    // the whole room.
    LessonView lesson_view();

    // Returns the requests to the owner, who reads them after each tick.
    OwnerRequests& requests() { return state_.requests; }
    const Dialogue& dialogue() const { return state_.lists.dialogue; }

    // Advances the session to `now_s`, which must never decrease. The walker moves for at most 0.1 s in each tick.
    void tick(double now_s, const servo::ToolState& tool, const servo::ToolState& left_tool = {});

    // Saves what the person has learnt about the present world, if the person wants progress to be remembered. The
    // session does this every minute, and the owner calls it at the end.
    void keep_learnt(double now_s);

    // The following functions return the outputs, which the owner fetches after each tick.
    std::shared_ptr<const Scene> scene() const { return state_.world.scene; }
    std::shared_ptr<const render::HapticScene> haptic_scene() const { return hand_.touch_view.felt(); }
    // Returns the output for a hand: 0 is the only or right hand, 1 the left hand.
    HandOutput hand(std::size_t which = 0) const;
    const servo::BodyFrame& bodies() const { return state_.world.things.frame(); }
    // Returns the world. Its member `entered` increases when another world is entered. If a thing is added, moved or
    // removed, scene() changes but `entered` does not.
    const WorldState& world() const { return state_.world; }
    // The result is not const, because an owner may follow a route (Guide::follow_to).
    Guide& guide() { return guide_; }
    const Bodies& free_bodies() const { return bodies_; }
    // Advances movable things in virtual time. Call it every millisecond if a hand is to feel them.
    void step_bodies(double now_s) { bodies_.step_engine(now_s); }
    bool two_hands() const { return state_.hands.two(); }
    cues::Listener listener() const;
    // Returns the desk. The world is paused while the hand is at the desk.
    const DeskVisit& desk_visit() const { return desk_visit_; }
    DeskVisit& desk_visit() { return desk_visit_; }
    bool at_desk() const { return state_.hands.at_desk(); }
    std::vector<cues::CueRequest> take_cues() { return state_.cues.take(); }
    // Returns the events since the last call (session_event.h). Announcements and sounds are not included.
    std::vector<SessionEvent> take_events() { return state_.events.take(); }
    // Returns the settings that were changed in the session, as key and value, since the last call. The owner stores
    // and saves them.
    std::vector<std::pair<std::string, std::string>> take_setting_changes() {
        return std::exchange(state_.person.changes, {});
    }
    const settings::Settings& settings() const { return state_.person.settings; }
    // Returns what the window shows now. The first call after the rooms were found computes their outlines.
    ViewState view(const servo::ToolState& tool);
    const KeyMap& keys() const { return state_.person.keys; }
    // Returns true if nothing is pending: no steps, no turn, no held key, no answer.
    bool idle() const;
    // Returns true if the first minutes have not yet reached the step that greets the person in the world.
    bool greeting_waits() const { return lesson_session_.greeting_waits(); }
    const Vec3& feet_m() const { return state_.avatar.walker->state().feet_m; }
    const WalkerState& avatar() const { return state_.avatar; }
    double heading_rad() const { return state_.avatar.heading_rad; }
    // Returns the free width across the walking direction, at the height of the waist. The result is 0 if a side is
    // open.
    double passage_width_m() const { return walk_.walking.passage_width_m(); }

    // Returns true while a background task makes a scene or searches for the rooms of the world.
    bool works_in_background() const { return hand_.touch_view.busy() || settled_.busy() || where_.rooms.awaited(); }

    // Returns a sentence with questions that would have worked instead of this line; empty if there is none.
    std::string question_hint(std::string_view line) const { return questions_.answers.hint(line); }

    // Returns the answer to "where am I", which is also announced when a world is entered.
    std::string where_am_i() const { return where_.queries.where_am_i(); }

private:
    void wire();  // session_wiring.cpp defines this function
    // The following functions each apply one input of session_input.h.
    void enter_world(EnteringWorld world, const std::optional<Placed>& begins_at, double now_s);
    void place(const Vec3& feet_m, double heading_rad, double now_s);
    void set_hand(const HandFacts& hand, const settings::Settings& settings, double now_s);
    void set_left_hand(const HandFacts& hand, double now_s);
    void offer_hand(const std::string& spoken_name, double now_s) { hand_.forces.offer(spoken_name, now_s); }
    void change_settings(const settings::Settings& settings, double now_s);
    void take_settings(settings::Settings settings, double now_s);
    Result<void> set(std::string_view key, const std::string& value, double now_s);
    void follow(std::string_view key, settings::Settings changed, double now_s);
    void speak_language_of(const settings::Settings::Speech& speech, double now_s);
    void press(Command command, double now_s, int times = 1);
    void release(Command command);
    bool take_key(std::string_view key, double now_s);
    bool take_text(std::string_view utf8, double now_s);
    bool take_line(std::string_view line, double now_s);
    struct Wish {
        std::optional<Command> command;  // the list in which to choose; none: a question
        std::string choice;
    };
    std::optional<Wish> wish_in(std::string_view line) const;
    void grant(const Wish& wish, std::string_view line, double now_s);
    void choose(Command command, const std::string& name, double now_s);
    bool leave_lists(double now_s);
    bool take_act(const ItemAct& act, double now_s);
    void know_stops(std::uint32_t stops, double now_s);
    void steer(const Steering& steering) { walk_.walking.steer(walk_.cane.take(steering)); }
    void set_focus(bool focused);
    void move_hand(const Vec3& by_device_m) { hand_.workspace.move_hand(by_device_m); }
    void go_on_at(const LastPlace& place, double now_s);
    void say(std::string text, cues::SpeechClass speech_class, double now_s) {
        state_.cues.say(std::move(text), speech_class, now_s);
    }
    void say_anew(cues::SpeechTopics topics, double now_s);
    void act(Command command, double now_s, int times = 1);
    void carry_out(Command command, double now_s, int times);
    bool act_itself(Command command, double now_s);
    struct Carriers;  // session_commands.cpp defines this struct
    void answer_what_was_too_early(double now_s);
    void publish_pose(double now_s, PoseChange change) { hand_.workspace.publish(now_s, change); }
    void play(cues::SoundKind kind, double now_s) { state_.cues.play(kind, now_s); }
    void play_at(cues::SoundKind kind, const Vec3& place_m, double now_s) { state_.cues.play_at(kind, place_m, now_s); }
    void cue(cues::CueRequest request) { state_.cues.cue(std::move(request)); }
    void answer(std::string text, double now_s) { state_.cues.answer(std::move(text), now_s); }
    void quiet(double now_s) { state_.cues.quiet(now_s); }
    // The following functions are for lists. session_dialogue.cpp defines them.
    bool reply(const DialogueReply& reply, double now_s);
    void bring_out(double now_s);
    // The following functions are for changes of the world.
    void change_world(Scene scene, double now_s);
    void settle();
    void take_settled();
    void report_changes(double now_s);
    std::string task_words() const;  // session_view.cpp defines this function
    bool anything_moves() const;     // returns true if things move that will come to rest without further input
    // The following functions are for additions by the person. session_additions.cpp defines them.
    void take_additions();
    void announce_additions(double now_s);
    bool save_additions(double now_s);
    void tick_additions(double now_s);
    void offer_last_place(double now_s);
    void take_others_additions();
    std::string entering_text() const;
    // The following functions are for an instructor's lessons. session_teaching.cpp defines them.
    void teach(const TeacherActed& act, double now_s);
    void lead_in_lesson(const TeacherActed& act, double now_s);
    void lay_blocked();

    SessionState state_;
    TouchEvents touch_events_{state_.context};
    Whereabouts where_{state_};
    MoverFeatures movers_{state_};
    Bodies bodies_{state_.context, state_.world, state_.hands};
    Guide guide_{state_.context, where_.rooms, movers_.doors};
    Questions questions_{state_, where_, guide_};
    WalkingFeatures walk_{state_};
    HandFeatures hand_{state_, walk_.keys_held};
    DeskVisit desk_visit_{state_.context};
    LeaveRequested leave_requested_;
    LessonSession lesson_session_{state_.context, leave_requested_};
    Menu menu_{state_.context};
    SimplifiedList simplified_list_{state_.context, where_.rooms};
    // Makes the scene in which all things are where they have come to rest.
    BackgroundTask<std::shared_ptr<const Scene>> settled_{state_.context.executor, "settle", state_.context.arrivals};
    PlacesFeatures places_{state_, where_.rooms, guide_.planned()};
    Soundscape soundscape_;
    LearningFeatures learn_{state_, where_.rooms, soundscape_};
    Labyrinth labyrinth_{state_.context, bodies_, soundscape_};
    SoundDictionary dictionary_;
    struct Given {
        std::optional<SideFile> side_file;  // side file of the world that is entered next
        std::optional<LastPlace> last_place;
    };
    Given given_;
    struct Shown {
        Pictures pictures = Pictures::Both;
        bool game = false;  // true: the world is a labyrinth
        HandPath hand_path;
    };
    Shown shown_;  // what only the window needs
    struct Watched {
        std::vector<InputListener> inputs;
        bool leads = false, list_open = false;  // the values that the events Leading and ListShown reported last
    };
    Watched watched_;
};

}  // namespace handrail::core
