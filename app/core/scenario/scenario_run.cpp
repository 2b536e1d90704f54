#include "app/core/scenario/scenario_run.h"

#include <algorithm>
#include <cmath>

#include "app/core/session/headless_session.h"
#include "haptic/servo/workspace_map.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/scene/models.h"

namespace handrail::core {
namespace {

// How long a key that a scenario presses by name stays down. Typing a text takes the same time.
constexpr double kTap_s = 0.1;
// Size of a jump in the device's position. It is more than a hand can move in one tick, so the servo must recognise it
// as a fault.
constexpr double kJumpTrouble_m = 0.05;

// An action that has begun or will begin.
struct Running {
    const ScenarioAction* action = nullptr;
    double start_s = 0.0, end_s = 0.0;
    bool started = false, ended = false;
};

class Player {
public:
    Player(const Scenario& scenario, HeadlessSession& session, settings::SettingsStore& settings,
           const WorldReader& read, std::vector<int>* undone)
        : scenario_(scenario), session_(session), settings_(settings), read_(read), undone_(undone) {
        for (const ScenarioAction& action : scenario.actions) runs_.push_back({&action, 0.0, 0.0, false, false});
    }

    // Starts and ends the actions that are due.
    Result<void> step() {
        const double now = session_.now_s();
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            Running& run = runs_[i];
            if (run.started && !run.ended && now >= run.end_s - 1e-9) {
                run.ended = true;
                end(*run.action);
            }
            if (run.started) continue;
            const bool due = run.action->at_s
                                 ? now >= *run.action->at_s - 1e-9
                                 : i == 0 || (run.action->meanwhile ? runs_[i - 1].started : runs_[i - 1].ended);
            if (!due) continue;
            run.started = true;
            run.start_s = now;
            const auto duration = begin(*run.action);
            if (!duration && !undone_) return tl::unexpected(duration.error());
            if (!duration) undone_->push_back(run.action->line);
            run.end_s = now + duration.value_or(0.0);
            // An action without duration ends at once, so that its key is released before the next action begins.
            if (run.end_s <= now) {
                run.ended = true;
                if (duration) end(*run.action);
            }
        }
        return {};
    }
    bool done() const {
        return std::all_of(runs_.begin(), runs_.end(), [](const Running& run) { return run.ended; });
    }
    void note_times(SessionLog& log) const {
        for (const Running& run : runs_)
            if (!run.action->name.empty()) log.action_times[run.action->name] = {run.start_s, run.end_s};
    }

private:
    // Converts a place in the world to a place in the device frame, for the present workspace.
    Vec3 in_device(const Vec3& world_m, bool left) {
        const servo::WorkspacePose pose = left ? session_.app().hand(1).pose : session_.app().hand().pose;
        const servo::ToolState& tool = session_.tool(left);
        const Vec3 origin_m = pose.origin_m + (tool.workspace_jump == pose.jump ? tool.workspace_shift_m : Vec3(0.0));
        const servo::WorkspaceFrame frame = servo::frame_of(origin_m, pose.heading_rad);
        return frame.turn_to_device(world_m - origin_m) / session_.app().hand().tuning.touch.world_m_per_hand_m;
    }
    Vec3 hand_now(bool left) {
        session_.hand(left).state.refresh();
        return session_.hand(left).state.read().position_m;
    }
    // Sends a command to a hand. The buttons keep their state during all other movements of the hand.
    void command_hand(device::HandCommand command, bool left) {
        command.buttons = buttons_[left];
        hand_command_[left] = command;
        session_.hand(left).command.publish(command);
    }

    // Begins an action, and returns its duration in seconds.
    Result<double> begin(const ScenarioAction& action) {
        const double now = session_.now_s();
        const bool left = action.left;
        if (const auto* tap = std::get_if<TapCommand>(&action.step)) {
            session_.press(tap->command, tap->times);
            return tap->for_s;
        }
        if (const auto* hold = std::get_if<HoldCommand>(&action.step)) {
            session_.press(hold->command);
            return hold->for_s;
        }
        if (const auto* key = std::get_if<TapKey>(&action.step)) {
            if (!session_.tap_key(key->key)) return here(phrase("scenario.no_key", {{"key", key->key}}), action);
            return kTap_s;
        }
        if (const auto* typed = std::get_if<TypeText>(&action.step)) {
            for (const std::string& character : characters_of(typed->text))
                if (!session_.app().apply(TextTyped{character}, now))
                    return here(phrase("scenario.nothing_open", {{"text", typed->text}}), action);
            return kTap_s;
        }
        if (const auto* typed = std::get_if<TypeLine>(&action.step)) {
            if (!session_.app().apply(LineTyped{typed->line}, now))
                return here(phrase("scenario.nothing_open", {{"text", typed->line}}), action);
        }
        if (const auto* wait = std::get_if<Wait>(&action.step)) return wait->for_s;
        if (const auto* move = std::get_if<MoveHand>(&action.step)) {
            const Vec3 from = hand_now(left);
            const Vec3 to = move->relative ? from + in_device(move->to_m, left) - in_device(Vec3(0.0), left)
                                           : in_device(move->to_m, left);
            device::HandCommand command;
            command.mode = device::HandMode::Move;
            command.target_m = to;
            command.speed_m_per_s = move->speed_m_per_s;
            command_hand(command, left);
            return glm::length(to - from) / move->speed_m_per_s;
        }
        if (const auto* move = std::get_if<MoveInDevice>(&action.step)) {
            device::HandCommand command;
            command.mode = device::HandMode::Move;
            command.target_m = move->to_m;
            if (!move->control.empty()) {
                const auto place = session_.app().desk_visit().place_m(move->control);
                if (!place) return here(phrase("scenario.no_control", {{"control", move->control}}), action);
                command.target_m = *place + Vec3(move->to_m.x, -move->to_m.y, move->to_m.z);
            }
            command.speed_m_per_s = move->speed_m_per_s;
            command_hand(command, left);
            return glm::length(command.target_m - hand_now(left)) / move->speed_m_per_s;
        }
        if (const auto* push = std::get_if<PushHand>(&action.step)) {
            device::HandCommand command;
            command.mode = device::HandMode::Push;
            command.push_n = push->force_n;
            command_hand(command, left);
            return push->for_s;
        }
        if (const auto* rest = std::get_if<RestHand>(&action.step)) {
            device::HandCommand command;
            command.mode = device::HandMode::Rest;
            command.target_m = in_device(rest->at_m, left);
            command_hand(command, left);
            return rest->for_s;
        }
        if (const auto* trouble = std::get_if<ScenarioTrouble>(&action.step)) {
            const int samples = static_cast<int>(std::lround(trouble->for_s * 1e3));
            device::DeviceTrouble device;
            if (trouble->kind == "nan") device.not_a_number_samples = samples;
            if (trouble->kind == "jump") device.jump_samples = samples, device.jump_m = Vec3(kJumpTrouble_m, 0.0, 0.0);
            if (trouble->kind == "freeze") device.silent_samples = samples;
            if (trouble->kind == "unplug") device.unplugged = true;
            device.hot = trouble->kind == "hot";
            device.failed = trouble->kind == "error";
            if (trouble->kind == "late") session_.slow_servo(2);
            session_.hand(left).trouble.publish(device);
            return trouble->for_s;
        }
        if (const auto* add = std::get_if<AddThing>(&action.step)) {
            const auto model = add->model.empty() ? box_model(add->box_m) : read_model(add->model);
            if (!model) return here(model.error(), action);
            if (const auto added = session_.app().add_thing(add->name, *model, add->at, add->material, now); !added)
                return here(added.error(), action);
        }
        if (const auto* remove = std::get_if<RemoveThing>(&action.step))
            if (const auto removed = session_.app().remove_thing(remove->name, now); !removed)
                return here(removed.error(), action);
        if (const auto* send = std::get_if<SendThing>(&action.step)) {
            const auto at = session_.app().thing_at(send->name);
            Placement to = at.value_or(Placement{});
            to = {send->to_m.value_or(to.position_m), send->rotation.value_or(to.rotation),
                  send->scale.value_or(to.scale)};
            if (const auto sent = session_.app().send_thing(send->name, to, send->speed_m_per_s); !sent)
                return here(sent.error(), action);
            const double way = glm::length(to.position_m - at->position_m);
            return way > 0.0 ? way / send->speed_m_per_s : 1.0;
        }
        if (const auto* button = std::get_if<DeviceButton>(&action.step)) {
            buttons_[left] = button->down ? 1U : 0U;
            command_hand(hand_command_[left], left);
        }
        if (const auto* focus = std::get_if<KeyboardFocus>(&action.step)) session_.set_focus(focus->here);
        if (const auto* place = std::get_if<PlaceWalker>(&action.step))
            session_.app().apply(Placed{place->feet_m, place->heading_rad}, now);
        if (const auto* change = std::get_if<ChangeSetting>(&action.step)) {
            if (const auto set = settings_.set(change->key, change->value, settings::SettingSource::Live); !set)
                return here(set.error().message, action);
            session_.change_settings(settings_.values());
        }
        return 0.0;
    }

    tl::unexpected<Error> here(std::string why, const ScenarioAction& action) const {
        return fail(std::move(why), scenario_.file.filename().string(), action.line);
    }
    tl::unexpected<Error> here(const Error& why, const ScenarioAction& action) const {
        return here(why.file.empty() ? why.message : why.sentence(), action);
    }
    Result<std::shared_ptr<const Scene>> read_model(const std::filesystem::path& file) {
        auto& known = models_[file.string()];
        if (known) return known;
        auto scene = read_.scene({.file = file});
        if (!scene) return tl::unexpected(scene.error());
        return known = std::make_shared<const Scene>(std::move(*scene));
    }

    void end(const ScenarioAction& action) {
        if (const auto* tap = std::get_if<TapCommand>(&action.step))
            session_.app().apply(CommandUp{tap->command}, session_.now_s());
        if (const auto* hold = std::get_if<HoldCommand>(&action.step))
            session_.app().apply(CommandUp{hold->command}, session_.now_s());
        if (std::get_if<PushHand>(&action.step)) {
            device::HandCommand still;
            still.mode = device::HandMode::Move;
            still.target_m = hand_now(action.left);
            command_hand(still, action.left);
        }
        if (const auto* trouble = std::get_if<ScenarioTrouble>(&action.step)) {
            if (trouble->kind == "late") session_.slow_servo(1);
            session_.hand(action.left).trouble.publish(device::DeviceTrouble{});
        }
    }

    const Scenario& scenario_;
    HeadlessSession& session_;
    settings::SettingsStore& settings_;
    const WorldReader& read_;
    std::vector<int>* undone_;
    // Each array has a value for the only or right hand, then a value for the left hand.
    std::array<std::uint32_t, 2> buttons_{};
    std::array<device::HandCommand, 2> hand_command_{HeadlessSession::still_hand(), HeadlessSession::still_hand()};
    std::map<std::string, std::shared_ptr<const Scene>> models_;
    std::vector<Running> runs_;
};

constexpr double kLongestRun_s = 3600.0;

// While this object exists, announcements name the keys or words of a person who uses the program in this way.
class SpokenTo {
public:
    explicit SpokenTo(ActsBy who) : before_(spoken_to()) { speak_to(who); }
    ~SpokenTo() { speak_to(before_); }
    SpokenTo(const SpokenTo&) = delete;
    SpokenTo& operator=(const SpokenTo&) = delete;

private:
    ActsBy before_;
};

LoggedTick logged(HeadlessSession& session, std::size_t hand) {
    const servo::ToolState& tool = session.tool(hand);
    LoggedTick tick;
    tick.time_s = session.now_s();
    tick.force_n = tool.force_n;
    tick.hip_m = tool.hip_m;
    tick.proxy_m = tool.proxy_m;
    tick.radius_m = tool.proxy_radius_m;
    tick.scale = session.app().hand().tuning.touch.world_m_per_hand_m;
    tick.contact = tool.touches();
    tick.touched = tool.touched();
    tick.feet_m = session.app().feet_m();
    tick.heading_rad = session.app().heading_rad();
    return tick;
}

}  // namespace

Result<SessionLog> run_scenario(const Scenario& scenario, const std::shared_ptr<const Scene>& scene,
                                cues::AudioSink& audio, cues::SpeechSink& speech, const WorldReader& read,
                                const std::function<void(HeadlessSession&)>& each_ms, std::vector<int>* undone,
                                RoomsKept* rooms_kept) {
    const std::string file = scenario.file.filename().string();
    settings::SettingsStore settings;
    if (const auto faults = settings.load_file(settings::settings_next_to(scenario.world.file),
                                               settings::SettingSource::World, read.toml);
        !faults.empty())
        return fail(faults.front().sentence(), file);
    for (const auto& [key, value] : scenario.settings)
        if (const auto set = settings.set(key, value, settings::SettingSource::CommandLine); !set)
            return fail(set.error().message, file);
    // The language is English by default, so that a scenario has the same result everywhere.
    const std::string& language = settings.values().speech.language;
    if (const auto spoken = speak_language(language == "auto" ? "en" : language); !spoken)
        return fail(spoken.error().message, file);
    const SpokenTo spoken_to_them(scenario.acts_by);
    std::array<HandFacts, 2> facts;
    for (std::size_t which = 0; which < facts.size(); ++which) {
        const std::string& device = which == 0 ? scenario.device : scenario.left_device;
        if (device == "none") continue;
        const device::DeviceSpec* spec = device::find_device_spec(device);
        if (!spec)
            return fail(phrase("scenario.no_device",
                               {{"device", device}, {"nearest", nearest_name(device, device::device_names())}}),
                        file);
        facts[which].present = facts[which].simulated = true;
        facts[which].spec = *spec;
    }
    HeadlessSession session(settings.values(), facts[0], audio, speech, {.rooms_kept = rooms_kept});
    if (facts[1].present) session.give_left_hand(facts[1]);
    if (scenario.has_start)
        session.app().apply(WorldEntered{make_ready_at(scene, scenario.start_feet_m, scenario.start_heading_rad)}, 0.0);
    else session.app().apply(WorldEntered{make_ready(scene)}, 0.0);

    SessionLog log;
    Player player(scenario, session, settings, read, undone);
    double last_action_s = 0.0;
    session.app().apply(WorldsKnown{{scenario.world.file.parent_path(), {}}}, 0.0);
    while (session.now_s() < kLongestRun_s) {
        // In virtual time, reading a world takes no time. If the world cannot be read, the session announces that and
        // stays in the old world.
        if (const auto wanted = session.app().requests().take_world()) {
            if (auto other = read.scene(*wanted)) {
                settings.load_file(settings::settings_next_to(wanted->file), settings::SettingSource::World, read.toml);
                session.change_settings(settings.values());
                session.app().apply(WorldEntered{make_ready(std::make_shared<const Scene>(std::move(*other)))},
                                    session.now_s());
            } else
                session.app().apply(Announcement{other.error().sentence(), cues::SpeechClass::Answer}, session.now_s());
        }
        if (const auto stepped = player.step(); !stepped) return tl::unexpected(stepped.error());
        if (!player.done()) last_action_s = session.now_s();
        else if (session.now_s() >= last_action_s + scenario.tail_s) break;
        if (each_ms) each_ms(session);
        session.advance();
        log.ticks.push_back(logged(session, 0));
        if (facts[1].present) log.left_ticks.push_back(logged(session, 1));
    }
    player.note_times(log);
    log.scene = session.app().scene();
    log.end_s = session.now_s();
    return log;
}

}  // namespace handrail::core
