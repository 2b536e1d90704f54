#include "app/core/session/session_input.h"

#include "app/core/session/session.h"
#include "worlds/base/overloaded.h"

namespace handrail::core {

bool Session::apply(SessionInput input, double now_s) {
    for (const InputListener& listener : watched_.inputs)
        if (listener.comes) listener.comes(input, now_s);
    const Arrivals::Turn turn(state_.context.arrivals);
    bool taken = true;
    std::visit(Overloaded{
                   [&](const CommandDown& in) { press(in.command, now_s, in.times); },
                   [&](const CommandUp& in) { release(in.command); },
                   [&](const KeyTapped& in) { taken = take_key(in.key, now_s); },
                   [&](const TextTyped& in) { taken = take_text(in.utf8, now_s); },
                   [&](const LineTyped& in) { taken = take_line(in.line, now_s); },
                   [&](const ListsLeft&) { taken = leave_lists(now_s); },
                   [&](const ItemActed& in) { taken = take_act(in.act, now_s); },
                   [&](const Steered& in) { steer(in.steering); },
                   [&](const FocusChanged& in) { set_focus(in.focused); },
                   [&](const Stopped& in) { know_stops(in.count, now_s); },
                   [&](const HandMoved& in) { move_hand(in.by_m); },
                   [&](const SettingSet& in) { taken = set(in.key, in.value, now_s).has_value(); },
                   [&](const SettingsChanged& in) { change_settings(in.settings, now_s); },
                   [&](const HandChanged& in) {
                       state_.hands.keys_alone = in.for_want_of_one;
                       set_hand(in.hand, in.settings, now_s);
                   },
                   [&](const LeftHandChanged& in) { set_left_hand(in.hand, now_s); },
                   [&](const HandOffered& in) { offer_hand(in.spoken_name, now_s); },
                   [&](WorldEntered& in) {
                       given_.side_file = std::move(in.additions);
                       if (in.settings) take_settings(std::move(*in.settings), now_s);
                       enter_world(std::move(in.world), in.begins_at, now_s);
                   },
                   [&](const Placed& in) { place(in.feet_m, in.heading_rad, now_s); },
                   [&](Announcement& in) { say(std::move(in.text), in.speech_class, now_s); },
                   [&](const LinesOwed& in) { say_anew(in.topics, now_s); },
                   [&](const FirstMinutesBegun& in) {
                       lesson_session_.begin_first_minutes(in.who_speaks, in.owner_sets_up, now_s);
                   },
                   [&](const LessonLeft&) { lesson_session_.leave(now_s); },
                   [&](const SetUpOver&) { lesson_session_.know_set_up_over(); },
                   [&](LastPlaceKnown& in) { given_.last_place = std::move(in.place); },
                   [&](const WentOnAt& in) { go_on_at(in.place, now_s); },
                   [&](CrashReportKnown& in) { menu_.reports().know_crash(std::move(in.lines)); },
                   [&](SettingsFaultsKnown& in) { menu_.reports().know_settings_faults(std::move(in.faults)); },
                   [&](const DevicesFound& in) { menu_.reports().open_devices(in.sentences, now_s); },
                   [&](const TeacherActed& in) { teach(in, now_s); },
                   [&](WorldsKnown& in) {
                       desk_visit_.offer_worlds(in.shelf);
                       menu_.worlds().offer(std::move(in.shelf));
                   },
               },
               input);
    for (const InputListener& listener : watched_.inputs)
        if (!taken && listener.not_taken) listener.not_taken();
    return taken;
}

}  // namespace handrail::core
