// Simulates a person in virtual time, with the simulated hand of a device or with keys only. The class stores what the
// person presses, chooses, feels and hears. Tests use it to run the whole program without a window.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>

#include "app/core/session/headless_session.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"
#include "tests/unit/core/app_session.h"

namespace handrail::test {

class Explorer {
public:
    // If `device` is null, the person has only keys. `before` is called before the world is entered.
    Explorer(std::shared_ptr<const Scene> scene, const char* device, const Settings& settings = {},
             const std::function<void(Session&, WorldEntered&)>& before = {})
        : session_(settings, facts(device), audio_, speech_, with_known_rooms()) {
        WorldEntered world{make_ready(std::move(scene))};
        if (before) before(app(), world);
        app().apply(std::move(world), 0.0);
        run(0.1);
        if (!device) return;
        hold({0.0, 0.0, 0.005});
        hold({0.0, 0.0, 0.0});
        run(1.2);
    }
    static HandFacts facts(const char* device) {
        HandFacts facts;
        facts.present = facts.simulated = device != nullptr;
        if (device) facts.spec = *find_device_spec(device);
        return facts;
    }
    Session& app() { return session_.app(); }
    const ToolState& tool() const { return session_.tool(); }
    double now_s() const { return session_.now_s(); }

    void run(double seconds) {
        for (const double until = now_s() + seconds; now_s() < until - 1e-9;) session_.advance();
    }
    // Waits until the condition is true, checking it every frame. Returns false if it is not true after this time.
    template <class Condition>
    bool wait_for(Condition condition, double seconds) {
        for (const double until = now_s() + seconds; now_s() < until;) {
            if (condition()) return true;
            run(1.0 / 60.0);
        }
        return condition();
    }

    void tap(Command command, double then_s = 0.05) {
        session_.press(command);
        app().apply(CommandUp{command}, now_s());
        run(then_s);
    }
    void key(const std::string& name) {
        EXPECT_TRUE(session_.tap_key(name)) << name;
        run(0.05);
    }
    void line(const std::string& text) {
        EXPECT_TRUE(app().apply(LineTyped{text}, now_s())) << text;
        run(0.05);
    }
    // Chooses a thing in the list of everything with a name, even if the thing is in a group. Leaves the list of tools
    // to find the thing open.
    bool choose(const std::string& name, FeatureId feature) {
        const auto chosen = [&] {
            return app().dialogue().view().title == name && app().guide().goal() &&
                   app().guide().goal()->feature == feature;
        };
        // Several things with the same name share one entry, which opens a list of them.
        for (std::size_t which = 0;; ++which) {
            tap(Command::Find);
            // A long list begins with its kinds.
            if (const std::string all = phrase("kinds.everything"); app().dialogue().has_use_for(all)) line(all);
            const std::vector<ListItem> items = app().dialogue().view().items;
            const auto at = std::find_if(items.begin(), items.end(), [&](const ListItem& i) { return i.name == name; });
            if (at == items.end()) return false;
            line(std::to_string(at - items.begin() + 1));
            if (chosen()) return true;
            if (app().dialogue().view().title == name || which >= app().dialogue().view().items.size()) return false;
            line(std::to_string(which + 1));
            if (chosen()) return true;
            leave_lists();
        }
    }
    bool request(const std::string& name, FeatureId feature, const std::string& way) {
        if (!choose(name, feature)) return false;
        line(way);
        return true;
    }
    void leave_lists() {
        while (app().dialogue().is_open()) key("Escape");
    }

    // Moves the hand to a place in the device frame and keeps it there.
    void hold(const Vec3& at_m, double speed_m_per_s = 0.15) {
        HandCommand command;
        command.mode = HandMode::Move;
        command.target_m = at_m;
        command.speed_m_per_s = speed_m_per_s;
        command.buttons = buttons_;
        at_m_ = at_m;
        session_.hand().command.publish(command);
        run(glm::length(at_m - hand_m()) / speed_m_per_s + 0.01);
    }
    const Vec3& at_m() const { return at_m_; }  // last target of the hand
    void button(bool down) {
        buttons_ = down ? 1U : 0U;
        hold(at_m_);
        run(0.05);
    }
    // Lets the hand move freely, so that only forces move it.
    void push(const Vec3& force_n = Vec3(0.0)) {
        HandCommand command;
        command.mode = HandMode::Push;
        command.push_n = force_n;
        session_.hand().command.publish(command);
    }
    Vec3 hand_m() {
        session_.hand().state.refresh();
        return session_.hand().state.read().position_m;
    }

    std::size_t lines() const { return speech_.lines().size(); }
    const std::string& line_at(std::size_t i) const { return speech_.lines()[i].utterance.text; }
    bool heard(const std::string& words, std::size_t from = 0) const { return find(words, from) < lines(); }
    std::size_t find(const std::string& words, std::size_t from = 0) const {
        while (from < lines() && line_at(from).find(words) == std::string::npos) ++from;
        return from;
    }
    std::string all_heard(std::size_t from = 0) const {
        std::string text;
        for (std::size_t i = from; i < lines(); ++i) text += line_at(i) + "\n";
        return text;
    }
    const std::vector<HeardSound>& sounds() const { return audio_.sounds(); }
    const Listener& ears() const { return audio_.listener(); }

    const DeviceSpec& spec() const { return session_.facts().spec; }

private:
    RecordingAudio audio_;
    RecordingSpeech speech_;
    HeadlessSession session_;
    Vec3 at_m_{0.0};
    std::uint32_t buttons_ = 0;
};

}  // namespace handrail::test
