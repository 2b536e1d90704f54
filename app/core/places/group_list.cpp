#include "app/core/places/group_list.h"

#include <memory>
#include <utility>

#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/scene/groups.h"

namespace handrail::core {

void GroupList::enter_world() {
    const std::vector<GroupChange> changes = read_groups(context_.additions, unreadable_);
    if (!changes.empty() && !world_.scene->groups.empty())
        world_.scene = std::make_shared<const Scene>(with_groups(*world_.scene, changes));
}

void GroupList::take_again() {
    const std::shared_ptr<const Scene> before = world_.scene;
    enter_world();
    if (before != world_.scene) on_felt(context_.tick_s);
}

void GroupList::announce_unreadable(double now_s) const {
    if (!unreadable_.empty())
        context_.say(unreadable_words("groups.unreadable", unreadable_), cues::SpeechClass::Answer, now_s);
}

bool GroupList::act(Command command, double now_s) {
    if (command != Command::Groups) return false;
    open(now_s);
    return true;
}

GroupChange GroupList::change_of(const std::string& name) const {
    std::vector<Error> faults;
    for (GroupChange& change : read_groups(context_.additions, faults))
        if (change.name == name) return std::move(change);
    return {name, false, {}};
}

void GroupList::open(double now_s) {
    const std::vector<Group>& groups = world_.scene->groups;
    if (groups.empty()) return context_.answer(phrase("groups.none"), now_s);
    ListSpec list;
    list.title = phrase("groups.title");
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < groups.size(); ++i) {
        list.items.push_back(
            {one_line(groups[i].name), phrase("groups.state", {{"hidden", groups[i].hidden ? "yes" : "no"},
                                                               {"count", solids_in_group(*world_.scene, i)}})});
        names.push_back(groups[i].name);
    }
    list.chosen = [this, names](std::size_t i) { open_one(names[i], context_.tick_s); };
    context_.open_list(std::move(list), now_s);
}

void GroupList::open_one(const std::string& name, double now_s) {
    GroupChange change = change_of(name);
    ListSpec list;
    list.title = one_line(name);
    list.items = {{phrase(change.hidden ? "groups.feel" : "groups.hide"), {}},
                  {phrase("groups.give_material"), spoken_material(change.material)}};
    list.chosen = [this, change](std::size_t i) mutable {
        if (i == 1) return open_materials(change, context_.tick_s);
        change.hidden = !change.hidden;
        put(change, phrase(change.hidden ? "groups.hidden" : "groups.felt", {{"name", one_line(change.name)}}),
            context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

void GroupList::open_materials(GroupChange change, double now_s) {
    ListSpec list;
    list.title = phrase("labels.which_material");
    for (const MaterialSpec& spec : material_library()) list.items.push_back({spoken_material(spec.name), {}});
    list.items.push_back({phrase("groups.own_materials"), {}});
    list.chosen = [this, change](std::size_t i) mutable {
        const bool own = i >= material_library().size();
        change.material = own ? std::string() : std::string(material_library()[i].name);
        const std::string name = one_line(change.name);
        put(change,
            own ? phrase("groups.back", {{"name", name}})
                : phrase("groups.made_of", {{"name", name}, {"material", spoken_material(change.material)}}),
            context_.tick_s);
        // The materials of the file are in the file only, so the owner of the session reads the world again.
        if (own) context_.requests.read_again = true;
    };
    context_.open_list(std::move(list), now_s);
}

void GroupList::put(const GroupChange& change, const std::string& words, double now_s) {
    keep_group(context_.additions, change);
    world_.scene = std::make_shared<const Scene>(with_groups(*world_.scene, {change}));
    on_felt(now_s);
    context_.keep_and_answer(words, now_s);
}

}  // namespace handrail::core
