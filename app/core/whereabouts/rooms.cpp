#include "app/core/whereabouts/rooms.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/whereabouts/drawn_rooms.h"
#include "app/core/whereabouts/exit_words.h"
#include "app/core/whereabouts/storeys.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/navigation/reach.h"

namespace handrail::core {

std::shared_ptr<RoomsOfWorld> Rooms::enter_world(std::shared_ptr<const Scene> scene, RoutesKeeper keeper) {
    const WalkerSize size = walker_size(*scene, context_.settings.walk.body_radius_m);
    std::shared_ptr<RoomsOfWorld> left = std::move(of_world_);
    if (left) left->give_up();  // The previous search is stopped before the next one begins.
    const navigation::WalkerMeasures body =
        navigation::walker_measures(*scene, size.radius_m, size.height_m, size.step_up_m);
    of_world_ = std::make_shared<RoomsOfWorld>(std::move(scene), body, context_.executor, std::move(keeper),
                                               context_.rooms_kept, context_.arrivals);
    leaves_of_.reset();
    patience_.reset();
    looked_for_ = announced_ = false;
    here_ = navigation::kNothing;
    storey_.reset();
    visited_.clear();
    drawing_.reset();
    return left;
}

bool Rooms::act(Command command, double now_s) {
    switch (command) {
        case Command::Exits:
        case Command::UnvisitedExits:
            context_.events.report(HelpRequested{command}, now_s);
            announce_exits(command == Command::UnvisitedExits, now_s);
            return true;
        case Command::NameRoom:
            if (!have(now_s)) return true;
            if (here_ == navigation::kNothing) context_.answer(phrase("rooms.nowhere"), now_s);
            else request_name(here_, {}, now_s);
            return true;
        default:
            return false;
    }
}

void Rooms::tick(double now_s) {
    looked_for_ = looked_for_ || (of_world_ && of_world_->ready());
    if (found()) navigation::say_room_names(graph());
    know_leaves();
    notice(now_s, false);
    announce_that_it_takes_long(now_s);
}

// Announces once that the search for rooms takes long, and later once that the rooms are known. There are no further
// announcements, so that an exploring person is not disturbed.
void Rooms::announce_that_it_takes_long(double now_s) {
    if (!of_world_) return;
    if (looked_for_) {
        if (patience_ && patience_->announced() && found())
            context_.say(phrase("rooms.known_now"), cues::SpeechClass::Ambient, now_s);
        patience_.reset();
        return;
    }
    if (!patience_) patience_.emplace(now_s);
    if (!patience_->announced() && patience_->due(now_s))
        context_.say(phrase("rooms.takes_long"), cues::SpeechClass::Ambient, now_s);
}

bool Rooms::known() {
    const bool known = found();
    if (known) know_leaves();
    return known;
}

// Makes routes avoid the leaves of open doors, in their positions when everything last came to rest.
void Rooms::know_leaves() {
    if (!found() || leaves_of_ == context_.world.scene) return;
    leaves_of_ = context_.world.scene;
    std::vector<navigation::OpenLeaf> leaves;
    for (std::uint32_t i = 0; i < context_.world.movers.size(); ++i) {
        const Mover& mover = context_.world.scene->movers[i];
        if (context_.world.thing_of_mover[i] < 0 ||
            context_.world.scene->features[mover.feature.value].kind != FeatureKind::Door)
            continue;
        // The door is shut in the file, even if it rests open. Skip it while it is at that place.
        if (context_.world.movers.at(i) == mover.at(0.0)) continue;
        const auto thing = static_cast<std::size_t>(context_.world.thing_of_mover[i]);
        const Aabb& own = context_.world.scene->placed[thing].model->bounds_m;
        const Vec3 size = own.size_m();
        // An object lower than it is wide is a bridge or a trapdoor, on which the walker can walk.
        if (size.z < std::min(size.x, size.y)) continue;
        leaves.push_back({own, context_.world.things.at(thing)});
    }
    navigation().know_leaves(leaves);
}

// Returns true if the rooms are known. If they are not, announces the reason.
bool Rooms::have(double now_s) {
    if (!looked_for_) {
        context_.answer(phrase("rooms.not_yet"), now_s);
        refused_ = true;
        return false;
    }
    if (found()) {
        know_leaves();
        notice(now_s, true);
        return true;
    }
    context_.answer(of_world_->problem(), now_s);
    return false;
}

// Determines the present room, and announces it unless `quietly` is true.
void Rooms::notice(double now_s, bool quietly) {
    if (!found()) return;
    navigation::RoomGraph& graph = of_world_->graph();
    if (!announced_) {
        announced_ = true;
        visited_.assign(graph.rooms.size(), false);
        lay_given_names(now_s);
        for (const std::string& sentence : navigation().said())
            context_.say(sentence, cues::SpeechClass::Ambient, now_s);
        if (std::string sentence = navigation::unreachable_words(of_world_->out_of_reach()); !sentence.empty())
            context_.say(std::move(sentence), cues::SpeechClass::Ambient, now_s);
        quietly = true;
    }
    const std::uint32_t now_in = navigation::room_at(graph, navigation().space(), context_.avatar.feet_m());
    if (now_in == navigation::kNothing || now_in == here_) return;
    here_ = now_in;
    visited_[here_] = true;
    context_.events.report(RoomEntered{here_, graph.rooms[here_].name}, now_s);
    const std::string storey = storey_news(!quietly);
    if (!quietly && context_.settings.speech.rooms)
        context_.announce(cues::SpeechTopic::Place, storey + sentence_case(graph.rooms[here_].name), now_s);
}

bool Rooms::announce_here_anew(double now_s) {
    if (!found() || here_ == navigation::kNothing) return false;
    if (!context_.settings.speech.rooms) return true;
    context_.announce(cues::SpeechTopic::Place, sentence_case(graph().rooms[here_].name), now_s, {.anew = true});
    return true;
}

// Returns "House, storey 2 of 2: 5 rooms. " for the first room that the walker enters on another storey. The text is
// empty if `announced` does not permit the announcement.
std::string Rooms::storey_news(bool announced) {
    const std::vector<StoreyOfRooms> storeys = storeys_of(*file_scene(), graph());
    const std::size_t now_on = storey_of_room(storeys, graph(), here_);
    const bool room = now_on < storeys.size() && std::find(storeys[now_on].rooms.begin(), storeys[now_on].rooms.end(),
                                                           here_) != storeys[now_on].rooms.end();
    if (!room || storey_ == now_on) return {};
    const bool first = !storey_;
    if (first || announced) storey_ = now_on;
    return first || !announced ? std::string() : storey_sentence(*file_scene(), storeys, now_on) + " ";
}

const std::shared_ptr<const std::vector<DrawnRoom>>& Rooms::drawing() {
    if (!found()) return drawing_;
    const navigation::RoomGraph& graph = of_world_->graph();
    if (drawing_ && drawn_language_ == graph.language) return drawing_;
    drawn_language_ = graph.language;
    drawing_ = std::make_shared<const std::vector<DrawnRoom>>(
        drawn_rooms(graph, navigation().space(), *file_scene(), *context_.world.solids));
    return drawing_;
}

void Rooms::announce_exits(bool unvisited_only, double now_s) {
    if (!have(now_s)) return;
    if (here_ == navigation::kNothing) return context_.answer(phrase("rooms.nowhere"), now_s);
    const navigation::RoomGraph& graph = of_world_->graph();
    const ListedExits exits =
        listed_exits(context_, graph, here_, [&](std::uint32_t other) { return !unvisited_only || !visited_[other]; });
    const std::string room = sentence_case(graph.rooms[here_].name);
    if (exits.count == 0)
        return context_.answer(phrase(unvisited_only ? "rooms.every_exit_taken" : "rooms.no_exits", {{"room", room}}),
                               now_s);
    context_.answer(
        phrase(unvisited_only ? "rooms.exits_not_taken" : "rooms.exits", {{"room", room}, {"count", exits.count}}) +
            " " + fmt::format("{}", fmt::join(exits.sentences, " ")),
        now_s);
}

// Gives the rooms the names that the person has chosen. Call it once the rooms are known.
void Rooms::lay_given_names(double now_s) {
    navigation::RoomGraph& graph = of_world_->graph();
    std::vector<Error> faults;
    names_ = read_room_names(context_.additions, faults);
    if (!faults.empty())
        context_.say(unreadable_words("room_names.unreadable", faults), cues::SpeechClass::Answer, now_s);
    lay_room_names(graph, navigation().space(), context_.additions, names_);
    if (std::string unfit = unfit_sentence(names_); !unfit.empty())
        context_.say(std::move(unfit), cues::SpeechClass::Answer, now_s);
    if (on_known) on_known(now_s);
}

void Rooms::request_name(std::uint32_t room, std::function<void(double now_s)> then, double now_s) {
    TextSpec question;
    question.question = phrase("room_names.ask", {{"room", sentence_case(graph().rooms[room].name)}});
    question.done = [this, room, then = std::move(then)](const std::string& typed) {
        give_name(room, typed, context_.tick_s);
        if (then) then(context_.tick_s);
    };
    question.left = [this] { context_.answer(phrase("room_names.stays"), context_.tick_s); };
    context_.request_text(std::move(question), now_s);
}

void Rooms::give_name(std::uint32_t room, const std::string& typed, double now_s) {
    const auto name = good_name(typed);
    if (!name) return context_.answer(name.error().message, now_s);
    navigation::RoomGraph& graph = of_world_->graph();
    for (std::uint32_t other = 0; other < graph.rooms.size(); ++other)
        if (other != room && lower_ascii(graph.rooms[other].name) == lower_ascii(*name))
            return context_.answer(phrase("room_names.taken", {{"name", *name}, {"own", graph.rooms[room].name}}),
                                   now_s);
    const std::uint32_t known = name_of_room(graph, navigation().space(), names_, room);
    if (known != navigation::kNothing) names_.erase(names_.begin() + known);
    const std::string before = navigation::known_as(graph.rooms[room]);
    // If the person types the room's own name, the name given earlier is removed.
    graph.rooms[room].given = *name != navigation::own_name(graph.rooms[room]);
    if (graph.rooms[room].given)
        names_.push_back({*name,
                          graph.rooms[room].middle_m,
                          graph.rooms[room].area_m2,
                          context_.additions.world_checksum(),
                          true,
                          {}});
    graph.rooms[room].name = *name;
    drawing_.reset();
    if (on_renamed) on_renamed(before, navigation::known_as(graph.rooms[room]));
    write_room_names(context_.additions, names_);
    context_.keep_and_answer(phrase("room_names.given", {{"name", *name}}), now_s);
}

void Rooms::take_names_again() {
    std::vector<Error> faults;  // errors that are not announced, because they were announced when the world was entered
    names_ = read_room_names(context_.additions, faults);
    drawing_.reset();
    if (!found()) return;  // If the rooms are not known yet, they get the names later, when they are known.
    for (navigation::Room& room : graph().rooms)
        if (std::exchange(room.given, false)) room.name = navigation::own_name(room);
    lay_room_names(graph(), space(), context_.additions, names_);
}

}  // namespace handrail::core
