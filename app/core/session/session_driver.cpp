#include "app/core/session/session_driver.h"

#include "worlds/base/contract.h"

namespace handrail::core {

void SessionDriver::drive(std::size_t which, servo::ServoInbox* servo,
                          std::shared_ptr<device::SimulatedHand> simulated) {
    hands_[which] = {};
    hands_[which].servo = servo;
    hands_[which].simulated = std::move(simulated);
}

void SessionDriver::tick(double now_s, const servo::ToolState& tool, const servo::ToolState& left_tool) {
    if (const cues::SpeechTopics owed = ears_.take_owed(); owed.any()) app_.apply(LinesOwed{owed}, now_s);
    app_.tick(now_s, tool, left_tool);
    if (steps_.ticked) steps_.ticked(now_s, tool, left_tool);
    hand_over();
}

void SessionDriver::hand_over_settings() {
    auto changes = app_.take_setting_changes();
    const bool changed = !changes.empty();
    if (steps_.take_settings ? steps_.take_settings(std::move(changes)) : changed) ears_.set_settings(app_.settings());
}

void SessionDriver::hand_over() {
    hand_over_settings();
    if (steps_.hands_over) steps_.hands_over();
    give_ears();
    give_world(1);
    if (!set_up_) give_world(0);
}

void SessionDriver::give_ears() {
    if (app_.scene() != heard_scene_) {
        heard_scene_ = app_.scene();
        if (std::exchange(heard_world_, app_.world().entered) != app_.world().entered) ears_.enter_world(heard_scene_);
        else ears_.follow_edit(heard_scene_);
    }
    std::vector<cues::CueRequest> cues = app_.take_cues();
    if (steps_.look_at_cues) steps_.look_at_cues(cues);
    for (cues::CueRequest& cue : cues) ears_.post(std::move(cue));
    if (app_.scene()) ears_.set_listener(app_.listener());
}

void SessionDriver::give_world(std::size_t which) {
    Hand& hand = hands_[which];
    if (!hand.servo || !app_.scene()) return;
    HandOutput out = app_.hand(which);
    if (app_.haptic_scene() != hand.scene) hand.servo->set_scene(hand.scene = app_.haptic_scene(), out.engine);
    if (which == 0 && app_.desk_visit().scene() != hand.desk)
        hand.servo->set_desk(hand.desk = app_.desk_visit().scene());
    if (which == 0) out.tuning.confirm += confirms_;
    hand.servo->set_tuning(out.tuning);
    hand.servo->set_pose(out.pose);
    if (std::exchange(hand.bodies, app_.bodies().number()) != app_.bodies().number())
        hand.servo->set_bodies(app_.bodies());
    if (out.guidance && std::exchange(hand.guidance, out.guidance->number) != out.guidance->number)
        hand.servo->set_guidance(*out.guidance);
    if (!hand.simulated) return;
    device::HandCommand command;
    command.target_m = out.target_m;
    hand.simulated->command.publish(command);
}

void SessionDriver::begin_set_up() {
    set_up_ = true;
    hands_[0].scene.reset();
    if (hands_[0].servo && std::exchange(hands_[0].guidance, 0) != 0) hands_[0].servo->set_guidance({});
}

void SessionDriver::feel_set_up(const SetUpTouch& touch) {
    contract_pre(set_up_);
    Hand& hand = hands_[0];
    if (!hand.servo) return;
    if (touch.scene != hand.scene) hand.servo->set_scene(hand.scene = touch.scene, nullptr);
    servo::ServoTuning tuning = touch.tuning;
    tuning.confirm += app_.hand().tuning.confirm + confirms_;
    hand.servo->set_tuning(tuning);
    hand.servo->set_pose(touch.pose);
    if (hand.simulated) hand.simulated->command.publish(touch.simulated);
}

void SessionDriver::end_set_up(std::uint32_t confirms) {
    set_up_ = false;
    confirms_ += confirms;
    hands_[0].scene.reset();
    hands_[0].bodies = 0;
}

}  // namespace handrail::core
