// Tests that the length of a route is the sum of the legs that the person hears.
#include <regex>

#include "tests/support/every.h"
#include "tests/support/names.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/unit/core/app_session.h"

namespace handrail {
namespace sums_test {

// Steps, and the stairs of each flight where a leg ends.
struct Sum {
    int steps = 0, stairs = 0;
    bool operator==(const Sum&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Sum& sum) { return out << sum.steps << " and " << sum.stairs; }

// Returns what the legs add up to, as a person adds them up.
Sum of_legs(const std::vector<std::string>& legs) {
    static const std::regex flight("^[^.]*\\. ([0-9]+) stairs? (?:up|down), (?:just ahead|in ([0-9]+) steps?)"),
        steps("^[^.]*\\. ([0-9]+) steps?");
    Sum sum;
    for (const std::string& leg : legs) {
        std::smatch found;
        if (std::regex_search(leg, found, flight)) {
            sum.stairs += std::stoi(found[1]);
            if (found[2].matched) sum.steps += std::stoi(found[2]);
        } else if (std::regex_search(leg, found, steps)) {
            sum.steps += std::stoi(found[1]);
        }
    }
    return sum;
}

// Returns the length in an overview such as "To Kitchen. 13 steps and 17 stairs in all, through Hall." Returns no value
// if it is not exact.
std::optional<Sum> announced(const std::string& overview) {
    static const std::regex all("(?:^|\\. )([0-9]+) steps?(?: and ([0-9]+) stairs?)? in all");
    std::smatch found;
    if (!std::regex_search(overview, found, all)) return std::nullopt;
    return Sum{std::stoi(found[1]), found[2].matched ? std::stoi(found[2]) : 0};
}

// Goes by routes of the list. `every` is the stride between the tried entries. Returns the number of routes with an
// exact length.
int compare(const std::shared_ptr<const Scene>& world, std::size_t every) {
    test::AppSession person;
    person.app.apply(WorldEntered{make_ready(world)}, person.now);
    person.run(0.1);
    person.request(Command::Exits);
    person.run(1.0);
    int exact = 0;
    for (std::size_t i = 0;; i += every) {
        person.request(Command::Routes);
        const auto items = person.app.dialogue().view().items;
        if (i >= items.size()) break;
        person.said.clear();
        person.line(items[i].name);
        person.run(0.1);
        std::optional<Sum> length;
        for (const std::string& text : person.said)
            if (!length) length = announced(text);
        const std::vector<std::string> legs = person.app.guide().take_legs();
        if (!length || legs.empty()) continue;
        ++exact;
        EXPECT_EQ(*length, of_legs(legs)) << items[i].name << ": " << person.news();
    }
    return exact;
}

TEST(Sums, of_the_legs_are_the_length_that_is_announced_first) {
    EXPECT_GT(compare(test::our_world("house.map"), 2), 3);
    if (test::kSanitizerScale < 1.0) return;  // The others take minutes then.
    EXPECT_GT(compare(test::our_world("school.map"), 9), 0);
    if (const auto file = test::real_world("duplex-apartment.ifc")) {
        EXPECT_GT(compare(test::world_in(*file), 9), 0);
    }
}

}  // namespace sums_test
}  // namespace handrail
