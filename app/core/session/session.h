// The session: where one is in the world, what a command does, what is published to servo, ears and window. No window,
// device or sound library, no thread, no clock of its own: the caller ticks it about 60 times a second and carries its
// outputs. App thread only.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/core/context/asked_to_leave.h"
#include "app/core/context/session_context.h"
#include "app/core/context/soundscape.h"
#include "app/core/context/telling.h"
#include "app/core/context/touch_events.h"
#include "app/core/context/workspace_scale.h"
#include "app/core/desk/desk_visit.h"
#include "app/core/dialogue/command.h"
#include "app/core/dialogue/dialogue.h"
#include "app/core/dialogue/key_map.h"
#include "app/core/dialogue/words.h"
#include "app/core/hand/forces.h"
#include "app/core/hand/touch_view.h"
#include "app/core/hand/workspace.h"
#include "app/core/kept/last_place.h"
#include "app/core/kept/side_file.h"
#include "app/core/kept/ways.h"
#include "app/core/kept/world_shelf.h"
#include "app/core/learning/clock_hunt.h"
#include "app/core/learning/place_learning.h"
#include "app/core/lessons/lesson_session.h"
#include "app/core/menu/menu.h"
#include "app/core/menu/simplified_list.h"
#include "app/core/movers/doors.h"
#include "app/core/movers/triggers.h"
#include "app/core/places/kept_ways.h"
#include "app/core/places/mark_list.h"
#include "app/core/session/session_input.h"
#include "app/core/walking/walking.h"
#include "app/core/wayfinding/guide.h"
#include "app/core/whereabouts/asking.h"
#include "app/core/whereabouts/rooms.h"
#include "app/core/world/beside.h"
#include "app/core/world/body_state.h"
#include "app/core/world/entering.h"
#include "app/core/world/mover_play.h"
#include "app/core/world/placed_things.h"
#include "app/core/world/questions.h"
#include "app/core/world/surroundings.h"
#include "app/core/world/walker.h"
#include "app/core/world/world_state.h"
#include "audio-cues/plan/cue_planner.h"
#include "haptic/servo/servo_tick.h"
#include "settings/settings.h"

namespace handrail {

class Session {
public:
    Session(const Settings& settings, const HandFacts& hand);
    Session(const Session&) = delete;  // lists that are open and sounds that wait know it by its place
    Session& operator=(const Session&) = delete;

    // The one way in (session_input.h). False where a key, text, line or act was not taken. now_s as in tick.
    bool apply(SessionInput input, double now_s);

    // Sets a thing down, takes it away or sends it elsewhere while everything goes on: touched, it neither knocks nor
    // leaks. Each fails with a sentence and changes nothing: see worlds/scene/models.h; too many things at once; a
    // speed that is not above zero. Walking meets a thing where it is.
    Result<void> add_thing(const std::string& name, std::shared_ptr<const Scene> model, const Placement& at,
                           const std::string& material, double now_s);
    Result<void> remove_thing(const std::string& name, double now_s);
    Result<void> send_thing(const std::string& name, const Placement& to, double speed_m_per_s);
    // Where the thing of that name is now; none of that name: nothing.
    std::optional<Placement> thing_at(const std::string& name) const;

    // A hand was offered and taken, by the force key; true once.
    bool offer_taken() { return forces_.offer_taken(); }
    void open_list(ListSpec list, double now_s) { lists_.open(std::move(list), now_s); }
    void ask_text(TextSpec question, double now_s) { lists_.ask(std::move(question), now_s); }
    const Dialogue& dialogue() const { return lists_.dialogue; }

    // now_s never goes back; steps over 0.1 s are cut to 0.1 s of walking.
    void tick(double now_s, const ToolState& tool, const ToolState& left_tool = {});

    // What others take after each tick.
    std::shared_ptr<const Scene> scene() const { return world_.scene; }
    std::shared_ptr<const HapticScene> haptic_scene() const { return touch_view_.felt(); }
    // Rises when another world was entered; scene() may be another one without that, when something was added, moved or
    // removed.
    int worlds_entered() const { return world_.entered; }
    // Of the only or right hand, and of the left one.
    WorkspacePose pose() const { return workspace_.pose(); }
    WorkspacePose left_pose() const { return workspace_.left_pose(); }
    const BodyFrame& bodies() const { return world_.things.frame(); }
    const ServoTuning& tuning() const { return hands_.tuning; }
    const GuidancePath& guidance() const { return guide_.path(); }  // of the only or right hand
    const WorldState& world() const { return world_; }
    const Guide& guide() const { return guide_; }
    ServoTuning left_tuning() const { return touch_view_.left_tuning(); }
    bool two_hands() const { return hands_.two(); }
    const Vec3& hand_target_m() const { return workspace_.hand_target_m(); }  // device frame
    Listener listener() const;
    // The desk, which the hand is at now and then: the world waits meanwhile.
    const DeskVisit& desk_visit() const { return desk_visit_; }
    DeskVisit& desk_visit() { return desk_visit_; }
    bool at_desk() const { return hands_.at_desk(); }
    // A live change of one setting: in force at once, and told by take_setting_changes. Fails as SettingsStore::set
    // does.
    Result<void> change_setting(std::string_view key, const std::string& value, double now_s);
    std::vector<CueRequest> take_cues() { return cues_.take(); }
    // What has happened since they were last taken, beside what is said and played (session_event.h).
    std::vector<SessionEvent> take_events() { return events_.take(); }
    // Settings the person changed by a command, to be stored and saved: key and value.
    std::vector<std::pair<std::string, std::string>> take_setting_changes() {
        return std::exchange(person_.changes, {});
    }
    const Settings& settings() const { return person_.settings; }
    ViewState view(const ToolState& tool, const std::string& last_spoken) const;
    const KeyMap& keys() const { return person_.keys; }
    // Where best times are kept; until told, they last as long as the session.
    void keep_records_in(const std::filesystem::path& folder) { hunt_.keep_records_in(folder); }
    // Files of languages of the person's own; until this is called there are the bundled ones.
    void find_languages_in(const std::filesystem::path& folder) { menu_.languages().find_in(folder); }
    // Nothing is on its way any more: no steps pending, no turn unfinished, nothing held.
    bool idle() const;
    // The set-up by voice was asked for; once for each time.
    bool take_calibration_request() { return std::exchange(calibration_asked_, false); }
    // Asked for by the first minutes: headphones and the hand only. The owner tells when it is over, or left.
    bool take_first_set_up() { return lesson_session_.take_first_set_up(); }
    bool greeting_waits() const { return lesson_session_.greeting_waits(); }

    // The world that was chosen, for the owner to read and enter.
    std::optional<std::filesystem::path> take_world_request() { return std::exchange(world_wanted_, std::nullopt); }
    // The last place is to be gone on at: the owner reads that world where it is another one.
    std::optional<LastPlace> take_last_place_request() { return std::exchange(last_place_wanted_, std::nullopt); }
    bool wants_to_leave() const { return wants_to_leave_; }
    const Vec3& feet_m() const { return body_.walker->state().feet_m; }
    bool standing() const { return body_.walker->state().on_ground; }
    double heading_rad() const { return body_.heading_rad; }
    // Free space across the way, at the height of the waist; 0 where a side is open.
    double passage_width_m() const { return walking_.passage_width_m(); }

    // Rooms and ways of worlds entered from now on are found on a thread beside everything else; without this when they
    // are first asked for.
    void find_rooms_beside() { rooms_.find_beside(); }
    // Likewise what a hand feels of them, and of every later scale: until it is there the hand feels what there was, at
    // first the world as sharp as it is.
    void feel_beside() { touch_view_.make_beside(); }
    // What is done beside has not come to its end.
    bool works_beside() const { return touch_view_.busy() || settled_.busy(); }

    // The answer to "where am I", also used on entering.
    std::string where_am_i() const { return asking_.where_am_i(); }

private:
    void wire();  // session_wiring.cpp
    // What session_input.h tells, each by itself.
    void enter_world(EnteringWorld world, double now_s);
    void place(const Vec3& feet_m, double heading_rad, double now_s);
    void set_hand(const HandFacts& hand, const Settings& settings, double now_s);
    void set_left_hand(const HandFacts& hand, double now_s);
    void offer_hand(const std::string& spoken_name, double now_s) { forces_.offer(spoken_name, now_s); }
    void change_settings(const Settings& settings, double now_s);
    void press(Command command, double now_s, int times = 1);
    void release(Command command);
    bool take_key(std::string_view key, double now_s);
    bool take_text(std::string_view utf8, double now_s);
    bool take_line(std::string_view line, double now_s);
    bool take_act(const ItemAct& act, double now_s);
    void know_stops(std::uint32_t stops, double now_s);
    void steer(const Steering& steering) { walking_.steer(steering); }
    void set_focus(bool focused);
    void move_hand(const Vec3& by_device_m) { workspace_.move_hand(by_device_m); }
    void go_on_at(const LastPlace& place, double now_s);
    void say(std::string text, SpeechClass speech_class, double now_s) {
        cues_.say(std::move(text), speech_class, now_s);
    }
    void act(Command command, double now_s, int times = 1);
    void publish_pose(double now_s, PoseChange change) { workspace_.publish(now_s, change); }
    void play(SoundKind kind, double now_s) { cues_.play(kind, now_s); }
    void play_at(SoundKind kind, const Vec3& place_m, double now_s) { cues_.play_at(kind, place_m, now_s); }
    void cue(CueRequest request) { cues_.cue(std::move(request)); }
    void answer(std::string text, double now_s) { cues_.answer(std::move(text), now_s); }
    void quiet(double now_s) { cues_.quiet(now_s); }
    void rescale(const Settings& changed, double now_s) { workspace_.rescale(changed, now_s); }
    void feel_otherwise(const Settings& changed, double now_s) { workspace_.feel_otherwise(changed, now_s); }
    // Lists: session_dialogue.cpp.
    bool reply(const DialogueReply& reply, double now_s);
    std::string change_setting(std::string_view key, const std::string& value);
    void bring_out(double now_s);
    // The world as it changes.
    void change_world(Scene scene, double now_s);
    void settle(double now_s);
    void take_settled();
    // What the person added: session_additions.cpp.
    void take_additions();
    void tell_additions(double now_s);
    void save_additions(double now_s);
    void ask_for_last_place(double now_s);
    void take_others_additions();
    std::string entering_text() const;

    Person person_;
    HandsState hands_;
    WorldState world_;
    BodyState body_;
    Cues cues_{body_};
    Lists lists_{cues_};
    SideFile additions_;
    Events events_;
    SessionContext context_{person_.settings, person_.keys, world_, body_, hands_, cues_, lists_, additions_, events_};
    TouchEvents touch_events_{context_};
    Rooms rooms_{context_};
    Asking asking_{context_, rooms_};
    Doors doors_{context_, world_, body_};
    Triggers triggers_{context_, world_};
    Guide guide_{context_, rooms_, doors_};
    HeldKeys keys_held_;
    ByEar by_ear_{context_, body_, keys_held_};
    Footing footing_{context_, body_};
    Walking walking_{context_, body_, keys_held_, by_ear_, footing_};
    TouchView touch_view_{context_, world_, body_, hands_};
    Workspace workspace_{context_, person_, hands_, keys_held_, touch_view_};
    Forces forces_{context_, hands_};
    DeskVisit desk_visit_{context_};
    AskedToLeave asked_to_leave_;
    LessonSession lesson_session_{context_, asked_to_leave_};
    Menu menu_{context_};
    SimplifiedList simplified_list_{context_, rooms_};
    Beside<std::shared_ptr<const Scene>> settled_;  // the world with its things where they have come to rest
    MarkList mark_list_{context_, world_.marks};
    KeptWays kept_ways_{context_, rooms_, guide_.planned()};
    Soundscape soundscape_;
    PlaceLearning learning_{context_, rooms_};
    ClockHunt hunt_{context_, rooms_, soundscape_};
    SoundDictionary dictionary_;
    std::optional<SideFile> side_file_next_;
    std::optional<std::filesystem::path> world_wanted_;
    std::optional<LastPlace> last_place_, last_place_wanted_;
    bool plan_view_ = false;
    bool wants_to_leave_ = false;
    bool calibration_asked_ = false;
};

}  // namespace handrail
