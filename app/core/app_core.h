// The session: where one is in the world, what a command does, what is published to servo, ears and window. No window, device or sound
// library, no thread, no clock of its own: the caller ticks it about 60 times a second and carries its outputs. App thread only.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/core/command.h"
#include "app/core/desk_hand.h"
#include "app/core/dialogue.h"
#include "app/core/guiding.h"
#include "app/core/key_map.h"
#include "app/core/learning_state.h"
#include "app/core/lesson.h"
#include "app/core/mover_play.h"
#include "app/core/placed_things.h"
#include "app/core/questions.h"
#include "app/core/room_names.h"
#include "app/core/rooms_of_world.h"
#include "app/core/route_words.h"
#include "app/core/side_file.h"
#include "app/core/simplified_words.h"
#include "app/core/soundscape.h"
#include "app/core/surroundings.h"
#include "app/core/view.h"
#include "app/core/walker.h"
#include "app/core/walking.h"
#include "app/core/ways.h"
#include "app/core/words.h"
#include "app/core/workspace_scale.h"
#include "app/core/world_shelf.h"
#include "audio-cues/plan/cue_planner.h"
#include "haptic/compile/compile_haptic.h"
#include "haptic/compile/simplify_scene.h"
#include "haptic/servo/servo_tick.h"
#include "settings/settings.h"

namespace handrail {

// What the hand has: none, or a device of which the workspace size, force and stiffness count.
struct HandFacts {
    bool present = false;
    bool simulated = false;
    DeviceSpec spec{};
    std::string serial = {};  // empty: it has none
};

// What a stick or a puck wants of the body: shares of walking speed and of the turning rate, -1 to 1; 0 at rest.
struct Steering {
    double ahead = 0.0, right = 0.0, turn_right = 0.0;
    bool operator==(const Steering&) const = default;
};

class AppCore {
public:
    AppCore(const Settings& settings, const HandFacts& hand);

    // Puts the body at the base (or first) start of the scene and says where one is.
    void enter_world(std::shared_ptr<const Scene> scene, double now_s);
    // The same, at a place and heading of the caller's choice.
    void enter_world_at(std::shared_ptr<const Scene> scene, const Vec3& feet_m, double heading_rad, double now_s);

    // What the person added to the world that is entered next, and where it is kept; without it additions are forgotten with the world.
    void use_side_file(SideFile file) { side_file_next_ = std::move(file); }

    // Puts the body somewhere else in this world; the workspace jumps with it.
    void place(const Vec3& feet_m, double heading_rad, double now_s);
    // Sets a thing down, takes it away or sends it elsewhere while everything goes on: touched, it neither knocks nor leaks. Each fails with a
    // sentence and changes nothing: see worlds/scene/models.h; too many things at once; a speed that is not above zero. Walking meets a thing where it is.
    Result<void> add_thing(const std::string& name, std::shared_ptr<const Scene> model, const Placement& at, const std::string& material, double now_s);
    Result<void> remove_thing(const std::string& name, double now_s);
    Result<void> send_thing(const std::string& name, const Placement& to, double speed_m_per_s);
    // Where the thing of that name is now; none of that name: nothing.
    std::optional<Placement> thing_at(const std::string& name) const;

    // Another device, or none, in place of the one there was; the settings are those of outside, as in change_settings.
    void set_hand(const HandFacts& hand, const Settings& settings, double now_s);
    // A device that could be used has been plugged in: says so, and the force key takes it the next time. offer_taken() is true once.
    void offer_hand(const std::string& spoken_name, double now_s);
    bool offer_taken() { return std::exchange(offer_taken_, false); }

    // New settings from outside; the world stays. Force ramps in again where the workspace changes.
    void change_settings(const Settings& settings, double now_s);

    void press(Command command, double now_s);
    void release(Command command);
    // Lists and typed answers (dialogue.h). A key by name, characters, a line of a terminal: each is offered here first, and is a command only where nothing
    // took it. A key that stops force, sound or speech is never taken.
    bool take_key(std::string_view key, double now_s);
    bool take_text(std::string_view utf8, double now_s);
    bool take_line(std::string_view line, double now_s);
    // A screen reader's action on an item of the open list.
    bool take_act(const ItemAct& act, double now_s);
    void open_list(ListSpec list, double now_s);
    void ask_text(TextSpec question, double now_s);
    const Dialogue& dialogue() const { return dialogue_; }
    // How often the stop key was pressed, from whoever sees it before the app does (ServoSwitches::stops): told before the keys of each frame. The
    // servo has stopped already; this makes the rest follow.
    void know_stops(std::uint32_t stops, double now_s);
    // Sticks act until told otherwise or the keyboard is lost, beside the keys. What is not finite counts as rest.
    void steer(const Steering& steering);
    // The window lost or regained the keyboard: nothing stays held and force fades away while it is lost.
    void set_focus(bool focused);
    // Moves the simulated hand's target, device frame; clamped to its reach.
    void move_hand(const Vec3& by_device_m);
    // A sentence from outside (problems while loading, device news).
    void say(std::string text, SpeechClass speech_class, double now_s);

    // A second device in the left hand, or none: its own ball and ceiling in the same workspace, with the scale of the first. What one hand does to the
    // workspace the other goes along with.
    void set_left_hand(const HandFacts& hand, double now_s);

    // now_s never goes back; steps over 0.1 s are cut to 0.1 s of walking.
    void tick(double now_s, const ToolState& tool, const ToolState& left_tool = {});

    // What others take after each tick.
    std::shared_ptr<const Scene> scene() const { return scene_; }
    std::shared_ptr<const HapticScene> haptic_scene() const { return haptic_scene_; }
    // Rises when another world was entered; scene() may be another one without that, when something was added, moved or removed.
    int worlds_entered() const { return worlds_entered_; }
    // Of the only or right hand, and of the left one.
    WorkspacePose pose() const { return pose_beside(shift_of(left_tool_)); }
    WorkspacePose left_pose() const { return pose_beside(shift_of(tool_)); }
    const BodyFrame& bodies() const { return things_.frame(); }
    const ServoTuning& tuning() const { return tuning_; }
    const GuidancePath& guidance() const { return guiding_.path; }  // of the only or right hand
    const Guiding& guiding() const { return guiding_; }
    ServoTuning left_tuning() const;
    bool two_hands() const { return hand_.present && left_hand_.present; }
    const Vec3& hand_target_m() const { return hand_target_m_; }  // device frame
    Listener listener() const;
    // The desk: what is on it, what of it the hand can touch (null without a hand), and in the device where the ball touches a control of the page that lies
    // there. The hand is at it: the world waits.
    const Desk& desk() const { return desk_; }
    std::shared_ptr<const HapticScene> desk_scene() const { return panel_.haptic; }
    std::optional<Vec3> desk_place_m(std::string_view control) const;
    bool at_desk() const { return tool_.desk.open; }
    // The one way to change a control of the desk, by its number among desk().controls(); each returns what is to be said. At the desk itself and in its list
    // they are called likewise.
    std::string step_control(std::size_t control, int by) { return after_desk_change(desk_.step(control, by)); }
    std::string put_control(std::size_t control, int position) { return after_desk_change(desk_.put(control, position)); }
    std::string put_control_number(std::size_t control, double number) { return after_desk_change(desk_.put_number(control, number)); }
    std::string press_control(std::size_t control) { return after_desk_change(desk_.press(control)); }
    // A live change of one setting: in force at once, and told by take_setting_changes. Fails as SettingsStore::set does.
    Result<void> change_setting(std::string_view key, const std::string& value, double now_s);
    std::vector<CueRequest> take_cues() { return std::exchange(cues_, {}); }
    // Settings the person changed by a command, to be stored and saved: key and value.
    std::vector<std::pair<std::string, std::string>> take_setting_changes() { return std::exchange(setting_changes_, {}); }
    const Settings& settings() const { return settings_; }
    ViewState view(const ToolState& tool, const std::string& last_spoken) const;
    const KeyMap& keys() const { return keys_; }
    // Where best times are kept; until told, they last as long as the session.
    void keep_records_in(const std::filesystem::path& folder) { records_folder_ = folder; }
    // Files of languages of the person's own; until this is called there are the bundled ones.
    void find_languages_in(const std::filesystem::path& folder) { languages_folder_ = folder; }
    // Nothing is on its way any more: no steps pending, no turn unfinished, nothing held.
    bool idle() const;
    // The set-up by voice was asked for; once for each time.
    bool take_calibration_request() { return std::exchange(calibration_asked_, false); }
    // Asked for by the first minutes: headphones and the hand only. The owner tells when it is over, or left.
    bool take_first_set_up() { return std::exchange(first_set_up_, false); }
    void know_set_up_over() { set_up_over_ = true; }

    // The first minutes, before a world is entered or in one. who_speaks: "speech-dispatcher"; owner_sets_up: the owner runs the set-up by voice when
    // take_calibration_request says so, else that part is left out.
    void begin_first_minutes(const std::string& who_speaks, bool owner_sets_up, double now_s);
    // Nobody will answer them any more, or they are not wanted: the world greets as it does otherwise.
    void leave_lesson(double now_s);
    bool greeting_waits() const;
    // The simulated hand is there for want of a real one: lessons speak of walking.
    void set_keys_alone(bool alone) { keys_alone_ = alone; }

    // What the chooser of worlds offers, and the world that was chosen, for the owner to read and enter.
    void set_worlds(WorldShelf shelf);
    std::optional<std::filesystem::path> take_world_request() { return std::exchange(world_wanted_, std::nullopt); }
    bool wants_to_leave() const { return wants_to_leave_; }
    const Vec3& feet_m() const { return walker_->state().feet_m; }
    bool standing() const { return walker_->state().on_ground; }
    double heading_rad() const { return heading_rad_; }
    // Free space across the way, at the height of the waist; 0 where a side is open.
    double passage_width_m() const;

    // Rooms and ways of worlds entered from now on are found on a thread beside everything else; without this when they are first asked for.
    void find_rooms_beside() { rooms_beside_ = true; }

    // The answer to "where am I", also used on entering.
    std::string where_am_i() const;

private:
    void lay_device_overrides();
    const DeviceProfile* profile_of(const HandFacts& hand) const;  // of the hand's device; null where it has none
    void retune();
    double rounding_m() const;
    bool adapt_touch(double now_s);
    void compile(std::uint32_t world);
    void act(Command command, double now_s);
    void walk(double now_s, double dt_s);
    void turn(double now_s, double dt_s);
    void move_hand_by_keys(double dt_s);
    void notice_volumes(double now_s);
    void tone_of_walls(double now_s);
    enum class PoseChange { Walked, Moved, Placed };
    void publish_pose(double now_s, PoseChange change);
    Vec3 shift_of(const ToolState& tool) const { return tool.workspace_jump == pose_.jump ? tool.workspace_shift_m : Vec3(0.0); }
    // How the hands themselves have moved the workspace since the pose's last jump.
    Vec3 shift_by_hand_m() const { return shift_of(tool_) + shift_of(left_tool_); }
    WorkspacePose pose_beside(const Vec3& others_shift_m) const;
    double ceiling_n(const HandFacts& hand) const;
    // What is too small to feel: app_core_simplify.cpp.
    Simplification plan_touch();
    Vec3 out_of_solids_m(const Vec3& hand_m) const;
    Vec3 out_of_solids_m(const Vec3& right_m, const Vec3& left_m) const;
    Vec3 hands_out_of_solids_m(const Vec3& origin_m) const;
    void notice_openings(double now_s);
    std::string simplified_news();
    void list_simplified(double now_s);
    std::string touched_words(const ToolState& tool);
    Vec3 workspace_origin_m() const;
    double workspace_heading_rad() const;
    template <class Change>
    void change_under_hand(Change change, double now_s);
    void zoom(NamedScale scale, double now_s);
    void turn_workspace(double by_deg, double now_s);
    void push_workspace(double now_s);
    void notice_workspace(double now_s);
    void let_go_of_world() { tuning_.workspace.grab_key = false; }
    std::string workspace_words() const;
    double scale() const;
    double farthest_m() const;
    void play(SoundKind kind, double now_s);
    void cue(CueRequest request) { cues_.push_back(std::move(request)); }
    void answer(std::string text, double now_s);
    // The desk: app_core_desk.cpp.
    void furnish_desk();
    std::string desk_value(std::string_view key) const;
    const Mark* desk_mark() const;  // the one its list is at; null: none
    std::string beacon_of_desk();
    void rescale(const Settings& changed, double now_s);
    void feel_otherwise(const Settings& changed, double now_s);
    void lay_desk(std::size_t page);
    bool refused_at_desk(Command command, double now_s);
    void leave_desk(double now_s);
    void tick_desk(double now_s);
    void hear_of_desk(const DeskNews& news, double now_s);
    void open_desk_list(double now_s);
    std::vector<ListItem> desk_items() const;
    std::string after_desk_change(std::string words);
    // Lists: app_core_dialogue.cpp.
    bool reply(const DialogueReply& reply, double now_s);
    void quiet(double now_s);
    // The menu: app_core_menu.cpp.
    void open_menu(double now_s);
    void open_topics(bool to_rebind, double now_s);
    void open_commands(std::vector<Command> commands, bool to_rebind, double now_s);
    void open_rebinding(Command command, double now_s);
    void take_new_key(const std::string& key, double now_s);
    void change_keys(const std::vector<std::pair<Command, std::string>>& changes);
    void toggle_input_help(double now_s);
    bool take_key_apart(const std::string& key, double now_s);
    bool take_line_apart(std::string_view line, double now_s);
    std::string change_setting(std::string_view key, const std::string& value);
    void open_setting_topics(double now_s);
    void open_settings(std::string_view topic, double now_s);
    void want_world(const std::filesystem::path& file);
    void open_worlds(double now_s);
    void open_languages(double now_s);
    void open_folder(const std::filesystem::path& typed, double now_s);
    void open_sounds(double now_s);
    // Lessons and the first minutes: app_core_lessons.cpp.
    bool in_first_minutes() const;
    void begin_lesson(const Lesson& lesson, std::size_t at, double now_s);
    void tell_lesson(const LessonReply& reply, double now_s);
    void say_lesson(double now_s);
    void run_lesson(double now_s);
    bool lesson_takes(Command command, double now_s);
    void keep_welcome(int step, bool done);
    void choose_what_next(double now_s);
    void hunt_in_the_house();
    void open_lessons(double now_s);
    void toggle_forces(double now_s);
    std::string why_no_force_yet() const;
    void notice_faults(double now_s);
    void describe_touched(double now_s);
    void go_home(double now_s);
    void bring_out(double now_s);
    // Moving by ear: app_core_walking.cpp.
    bool act_walking(Command command, double now_s);
    void notice_walk_key(Command command, double now_s);
    void confirm_edge(double now_s);
    bool start_trail(TrailSide side, double now_s);
    bool led() const;
    std::optional<Vec3> lead_walk(double now_s, double dt_s);
    std::optional<Vec3> retrace_wish(double now_s, double dt_s);
    void tell_trail(const TrailEvent& event, double now_s);
    void square_up(double now_s);
    void leap(int by, double now_s);
    void keep_place_for_undo();
    std::string where_words(double distance_m, double bearing_rad) const;
    bool held_at_edge(const WalkerState& before, double now_s);
    bool tell_place_once(const Vec3& place_m, bool drop, double now_s);
    void notice_ground(const Vec3& before_m, const WalkResult& walked, double now_s);
    void tell_ahead(double now_s);
    void beat_ahead(double now_s);
    static void mark_base_door(Scene& scene, const Vec3& feet_m);
    CueRequest sound_at(SoundKind kind, const Vec3& place_m, double now_s) const;
    // Learning a place, and the hunt: app_core_learning.cpp.
    bool act_learning(Command command, double now_s);
    void enter_learning(double now_s);
    void note_learning(double now_s);
    void corner_of_hand(double now_s);
    const Learnt& learnt_of(std::uint32_t room);
    bool in_known_room(double now_s);
    void spend_time();
    std::string no_room_words() const;
    std::string share_words(const Progress& progress) const;
    void list_learnt_rooms(double now_s);
    void learn_place(double now_s);
    std::string progress_words(double now_s);
    void tell_unexplored(double now_s);
    void guide_learning(double now_s);
    void hunt_key(double now_s);
    std::string hunt_words() const;
    void seek_clock(double now_s);
    // Rooms and ways: app_core_rooms.cpp.
    void begin_rooms(std::shared_ptr<const Scene> scene);
    bool have_rooms(double now_s);
    std::string room_words(double now_s);
    void notice_room(double now_s, bool quietly);
    void draw_rooms();
    std::string passage_name(PassageKind kind, FeatureId feature, double rise_m) const;
    std::string passage_now(PassageKind kind, FeatureId feature, double rise_m) const;
    void tell_exits(bool unvisited_only, double now_s);
    void list_routes(double now_s);
    void way_to_room(std::uint32_t room, double now_s);
    void lay_given_names(double now_s);
    void ask_room_name(double now_s);
    void name_room(std::uint32_t room, const std::string& typed, double now_s);
    void follow_way(const Vec3& goal_m, const std::string& name, const std::string& first, double now_s);
    void follow_route(Route route, const std::string& name, const std::string& first, double now_s);
    std::vector<RouteNode> nodes_to(const Route& route, const std::string& goal) const;
    bool rooms_known();
    void know_leaves();
    struct Leg {
        Route route;
        Vec3 to_m{0.0};
        double along_m = 0.0;  // of the route
    };
    std::optional<Leg> next_leg(Route route) const;
    void tell_way_on(double now_s);
    void follow_on(double now_s);
    void renew_followed();
    // Ways that were kept: app_core_ways.cpp.
    void enter_ways(double now_s);
    FoundWay found_way(const SavedWay& way);
    std::string way_faults(const FoundWay& found) const;
    void tell_unfit_ways(double now_s);
    void save_ways(double now_s);
    void rename_room_in_ways(const std::string& before, const std::string& name);
    Stop stop_at_place(const Vec3& place_m, const std::string& otherwise);
    Stop stop_in_room(std::uint32_t room);
    Stop stop_at_goal(const Goal& goal, const Vec3& from_m);
    void note_planned(Stop stop, const Vec3& from_m);
    void open_keep_way(double now_s);
    bool way_name_taken(const std::string& name, std::size_t except) const;
    void ask_way_name(const std::vector<Stop>& stops, double now_s);
    std::optional<std::string> free_way_name(const std::string& typed, std::size_t except, double now_s);
    void open_ways(double now_s);
    void open_way(std::size_t which, double now_s);
    void add_ways_to_go(ListSpec& list, std::vector<std::function<void()>>& acts, const std::string& name, const std::vector<Stop>& stops);
    void open_way_backwards(std::size_t which, double now_s);
    void open_add_stop(std::size_t which, double now_s);
    void add_stop(std::size_t which, Stop stop, double now_s);
    void take_over_way(std::size_t which, double now_s);
    void ask_new_way_name(std::size_t which, double now_s);
    void delete_way(std::size_t which, double now_s);
    void tell_way(const std::string& name, const std::vector<Stop>& stops, double now_s);
    void begin_way(const std::vector<Stop>& stops, bool by_hand, double now_s);
    Goal goal_of(const Stop& stop) const;
    void go_on_way(const std::string& first, double now_s);
    Route way_on(const Vec3& from_m);
    bool runs_to(const std::string& goal) const;
    void pass_stops();
    bool next_stop(const std::string& words, double now_s);
    // Doors, lifts, buttons and teleporters: app_core_movers.cpp.
    void use(double now_s);
    void play_movers(double now_s, double dt_s);
    void meet_switch(FeatureId volume, double now_s);
    int mover_of(FeatureId feature) const;
    bool usable(std::size_t mover) const;
    bool locked(std::uint32_t mover) const;
    bool shut(std::uint32_t mover) const;
    std::optional<FeatureId> button_of(std::uint32_t mover) const;
    std::string lock_words(FeatureId door) const;
    void press_mover(std::uint32_t mover, bool back_again, double now_s);
    void change_world(Scene scene, double now_s);
    void feel_scene(double now_s);
    void rebuild_body_world();
    Scene world_now() const;
    // Marks, landmarks, beacon and being led: app_core_guide.cpp.
    std::vector<Error> take_additions();
    void tell_additions(const std::vector<Error>& mark_faults, double now_s);
    void tick_guiding(double now_s);
    void act_guiding(Command command, double now_s);
    void save_additions(double now_s);
    void drop_mark(bool by_button, double now_s);
    void rename_mark(const std::string& name, const std::string& typed, double now_s);
    void delete_mark(std::size_t which, double now_s);
    std::vector<ListItem> mark_items() const;
    void open_delete_marks(double now_s);
    void open_marks(double now_s);
    void open_find(double now_s);
    void open_tools(const Goal& goal, double now_s);
    void set_beacon(const Goal& goal, double now_s);
    void beacon_here(double now_s);
    void mute_beacon(double now_s);
    void seek_warmer(const Goal& goal, double now_s);
    void start_beacon(const Goal& goal);
    void play_beacon(double now_s);
    void play_warmer(double now_s);
    void plan_sought(AlongWay& along, const Sought& sought, bool hand, double now_s);
    bool keep_way(AlongWay& along, const Sought& sought, bool hand, double now_s);
    bool straight_before(const SoughtWay& way, const Sought& sought, bool hand) const;
    bool body_gets_to(const Sought& sought) const;
    std::string sought_words(AlongWay& along, const Sought& sought, bool hand, double now_s);
    std::optional<Vec3> beacon_turning(double now_s);
    bool hand_seeks() const { return hand_.present && tool_.ticks > 0; }
    // Being led: app_core_lead.cpp.
    struct HandLead {
        std::vector<Vec3> points_m;  // from the hand to the thing; none: `problem` says why
        std::string problem;
        bool reaches = true;
        double short_of_m = 0.0;
        std::vector<std::string> passes;  // doors and stairs, in order
    };
    void take_me(double now_s);
    bool hand_may_be_led() const;
    HandLead hand_lead(const Goal& goal, std::size_t most_points);
    std::string why_no_way() const;
    void lead_to(const Goal& goal, const std::string& first, double now_s);
    void lead_by_ear(const Goal& goal, const std::string& first, double now_s);
    std::string shut_door_words(std::uint32_t mover) const;
    void tell_shut_doors(double now_s);
    void tell_shut_door(FeatureId feature, double now_s);
    void tell_shut_doors_ahead(const SoughtWay& way, double now_s);
    bool hand_at_goal() const;
    void notice_left_way(double now_s);
    void watch_way(double now_s);
    void renew_way();
    void lay_grooves(double now_s);
    void know_way(std::vector<Vec3> soles_m);
    Vec3 carry_workspace();
    void cross_lines(const Goal& goal, double now_s);
    bool lines_wished() const;
    void lay_lines(double now_s);
    void watch_lines(double now_s);
    void toggle_lines(double now_s);
    void announce(GuidancePath path, std::string words, double now_s);
    void end_guidance();
    bool force_may_guide() const;
    void follow_guidance(double now_s);
    void notice_marks(double now_s);
    Vec3 finding_place_m() const;  // of the hand, or of the body where there is none
    std::string where_words(const Aabb& box) const;
    std::vector<Goal> goals() const;
    void play_at(SoundKind kind, const Vec3& place_m, double now_s);
    // Questions: app_core_questions.cpp.
    Telling telling() const;
    Asker asker() const;
    std::string state_of(const Sight& sight) const;
    std::string tell_sight(const Sight& sight) const;
    std::string tell_sights(std::span<const Sight> sights) const;
    std::string around_me() const;
    std::string ahead_of_me() const;
    void look_round(int by, double now_s);
    std::string heading_words() const;
    std::string coordinates() const;
    std::string scale_bar() const;
    std::string help_text() const;
    std::string entering_text() const;
    std::string name_of(FeatureId feature) const;
    DistanceWords distances() const { return {settings_.speech.distances_in_steps, settings_.walk.step_length_m, settings_.speech.rounded}; }
    bool held(Command command) const { return held_[static_cast<std::size_t>(command)]; }

    Settings settings_;
    HandFacts hand_, left_hand_;
    KeyMap keys_;
    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<const HapticScene> haptic_scene_;
    double compiled_rounding_m_ = 0.0;  // of edges in it
    Simplification touch_plan_, compiled_plan_;   // of the scale, and of haptic_scene_; they differ while the hand is at the desk
    OpenPortals planned_portals_;                 // that touch_plan_ was told of
    bool openings_awaited_ = false;               // the plan would know more if the rooms were found
    std::string simplified_told_;
    int worlds_entered_ = 0;
    PlacedThings things_;
    MoverPlay movers_;
    bool movers_arrived_ = false;
    bool rooms_beside_ = false, rooms_told_ = false;
    std::unique_ptr<RoomsOfWorld> rooms_;
    std::uint32_t room_ = kNothing;    // the last one the body was in
    std::vector<bool> visited_rooms_;  // since this world was entered
    std::vector<RoomNameGiven> room_names_;
    std::shared_ptr<const std::vector<DrawnRoom>> drawn_rooms_;  // for the plan; made while it is shown
    std::string drawn_language_;
    std::shared_ptr<const Scene> leaves_of_;    // the world as it was when ways were told where leaves stand
    std::shared_ptr<const Scene> followed_in_;  // likewise when the way that is followed was planned
    RouteFollower follower_;
    std::string follow_name_;
    std::vector<SavedWay> ways_;
    std::vector<Stop> planned_stops_;   // where the person has wanted to go, one after the other
    std::optional<Vec3> way_begins_m_;  // where the person said that a way begins
    std::optional<WayRun> run_;         // a kept way that is gone along now
    std::vector<FeatureId> used_switches_;  // that act only once
    std::vector<int> thing_of_mover_;       // place among things_, -1: part of the building
    FeatureId ground_ = kNoFeature;         // what the body stands on
    std::unique_ptr<BodyWorld> body_world_;
    std::unique_ptr<Walker> walker_;
    Soundscape soundscape_;
    SoundDictionary dictionary_;
    Dialogue dialogue_;
    SideFile side_file_;
    std::optional<SideFile> side_file_next_;
    Guiding guiding_;
    bool input_help_ = false;
    struct Rebinding {
        Command command;
        bool one_more = false;
    };
    std::optional<Rebinding> rebinding_;
    WorldShelf shelf_;
    std::optional<std::filesystem::path> world_wanted_;
    std::optional<LessonRun> lesson_;
    std::vector<Command> did_;       // since the last tick, for the lesson
    std::vector<FeatureId> bumped_;  // likewise
    struct SaidLater {
        double due_s = 0.0;
        std::string text;
    };
    bool hunt_awaits_ = false;  // a hunt begins in the world that is entered next
    std::vector<SaidLater> said_later_;
    enum class AfterLesson { Nothing, Choose, Lessons } after_lesson_ = AfterLesson::Nothing;
    std::string who_speaks_;
    bool owner_sets_up_ = false, set_up_over_ = true, first_set_up_ = false, keys_alone_ = false;
    LookRound look_round_;
    Vec3 home_feet_m_{0.0};
    double home_heading_rad_ = 0.0;

    double heading_rad_ = 0.0;       // where the body faces now
    double heading_goal_rad_ = 0.0;  // where the last turn key leads; reached at a bounded rate, so that the hand is not thrown
    double tilt_rad_ = 0.0;
    double pending_way_m_ = 0.0;  // of taps, positive ahead; walked even when the key is up again
    double since_footstep_m_ = 0.0;
    bool blocked_ = false;  // a bump was told and the body has not got away since
    std::vector<bool> held_;
    Walking walking_;
    LearningState learning_;
    std::optional<ClockHunt> hunt_;
    std::uint64_t hunts_ = 0;
    double best_hunt_s_ = -1.0;             // where no folder keeps it
    std::filesystem::path records_folder_;  // empty: nothing is kept
    std::filesystem::path languages_folder_;
    Steering steering_;
    bool stick_turns_ = false, free_keys_told_ = false;
    double last_turn_repeat_s_ = 0.0;
    std::optional<NamedScale> named_scale_;  // none: the scale of the settings
    Vec3 anchor_feet_m_{0.0};                // where the workspace stays while it does not follow the body
    // Of the workspace, world metres, on top of which the servo lays its own since the last jump: brought out of something, scrolled, zoomed under the hand;
    // until one is put elsewhere.
    Vec3 hand_shift_m_{0.0};
    Vec3 push_tap_{0.0};  // the workspace, by a tap of a key: which way and until when
    double push_until_s_ = -1.0;
    WorkspaceMotion motion_told_ = WorkspaceMotion::Still;
    bool limit_told_ = false;
    WorkspacePose pose_;
    ServoTuning tuning_;
    Vec3 hand_target_m_{0.0};
    std::vector<CueRequest> cues_;
    std::vector<std::pair<std::string, std::string>> setting_changes_;
    std::vector<FeatureId> inside_;         // volumes the body is in
    std::vector<FeatureId> told_triggers_;  // each trigger speaks once
    std::vector<Vec3> path_m_;
    ToolState tool_, left_tool_;
    double last_tick_s_ = -1.0;
    double leave_asked_s_ = -1e9;
    double stopped_s_ = -1e9;
    double breaks_told_ = 0.0;
    double contact_before_s_ = 0.0;  // with devices used earlier
    bool offered_ = false, offer_taken_ = false;
    double tone_loudness_ = 0.0;
    FeatureId described_ = kNoFeature, left_described_ = kNoFeature;  // what "what is this" last told of
    bool fault_lasted_ = false;
    bool plan_view_ = false;
    bool wants_to_leave_ = false;
    bool calibration_asked_ = false;
    std::uint32_t stops_known_ = 0;
    Desk desk_;
    DeskPanel panel_;
    DeskHand desk_hand_;
    bool desk_told_ = false;                  // that the hand is at it
    std::vector<std::filesystem::path> desk_worlds_;  // that its list of worlds offers
    std::size_t desk_world_ = 0, desk_mark_ = 0;      // where its lists are
    std::optional<std::string> scale_waits_;  // chosen at the desk, for when the hand is back
};

}  // namespace handrail
