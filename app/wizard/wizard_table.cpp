// Defines the table of the set-up: the parts with the names under which people request them, and the questions of each
// part. The state machine in wizard.cpp calls the functions in a question's row. Each function is defined in the file
// of its part.
#include "app/wizard/wizard.h"

#include <algorithm>
#include <array>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::wizard {
namespace {

constexpr std::array kParts{
    WizardPartInfo{WizardPart::Headphones, "headphones", false},
    WizardPartInfo{WizardPart::Find, "find", false},
    WizardPartInfo{WizardPart::Home, "home", true},
    WizardPartInfo{WizardPart::Hand, "hand", true},
    WizardPartInfo{WizardPart::Gentlest, "gentlest", true},
    WizardPartInfo{WizardPart::Strongest, "strongest", true},
    WizardPartInfo{WizardPart::Reach, "reach", true},
    WizardPartInfo{WizardPart::Step, "step", false},
};

}  // namespace

std::span<const WizardPartInfo> wizard_parts() { return kParts; }

Result<std::vector<WizardPart>> parse_wizard_parts(std::string_view words) {
    std::vector<std::string> known;
    for (const WizardPartInfo& part : kParts) known.emplace_back(part.word);
    std::vector<bool> chosen(kParts.size(), words.empty());
    while (!words.empty()) {
        const std::size_t comma = std::min(words.find(','), words.size());
        const std::string word = lower_ascii(words.substr(0, comma));
        words.remove_prefix(std::min(comma + 1, words.size()));
        const auto row = std::find(known.begin(), known.end(), word);
        if (row == known.end())
            return fail(phrase("wizard.no_part", {{"word", word}, {"nearest", nearest_name(word, known)}}));
        chosen[static_cast<std::size_t>(row - known.begin())] = true;
    }
    std::vector<WizardPart> parts;
    for (const WizardPartInfo& part : kParts)
        if (chosen[static_cast<std::size_t>(part.part)]) parts.push_back(part.part);
    return parts;
}

const Wizard::Row& Wizard::row(Step step) {
    using W = Wizard;
    // The rows are in the order of Step, which is the order of the questions.
    static constexpr std::array kRows{
        Row{WizardPart::Headphones, &W::begin_bell, &W::bell_left_question, nullptr, &W::adjust_bell_left,
            &W::hear_bell, nullptr},
        Row{WizardPart::Headphones, &W::begin_bell, &W::bell_right_question, nullptr, &W::adjust_bell_right,
            &W::hear_bell, nullptr},
        Row{WizardPart::Find, &W::begin_search, &W::search_question, &W::repeat_question, nullptr, &W::watch_search,
            nullptr},
        Row{WizardPart::Home, nullptr, &W::pull_question, &W::accept_homing, nullptr, nullptr, &W::watch_homing},
        Row{WizardPart::Home, nullptr, &W::push_question, &W::accept_homing, nullptr, nullptr, &W::watch_homing},
        Row{WizardPart::Hand, nullptr, &W::hand_question, &W::accept_hand, &W::adjust_hand, nullptr, &W::watch_aside},
        Row{WizardPart::Gentlest, &W::begin_press, &W::press_question, &W::accept_press, nullptr, nullptr,
            &W::watch_press},
        Row{WizardPart::Strongest, &W::begin_wall, &W::wall_question, &W::keep_ceiling, &W::adjust_wall, nullptr,
            &W::watch_wall},
        Row{WizardPart::Reach, &W::begin_sweep, &W::sweep_question, &W::keep_reach, nullptr, nullptr, &W::watch_sweep},
        Row{WizardPart::Reach, &W::begin_scale, &W::scale_question, &W::keep_scale, &W::adjust_scale, nullptr, nullptr},
        Row{WizardPart::Reach, nullptr, &W::beyond_question, &W::keep_beyond, &W::adjust_beyond, nullptr, nullptr},
        Row{WizardPart::Step, nullptr, &W::step_length_question, &W::keep_step_length, &W::adjust_step_length, nullptr,
            nullptr},
        // The row of the step Done, which has no question.
        Row{WizardPart::Step, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr},
    };
    static_assert(kRows.size() == static_cast<std::size_t>(Step::Done) + 1);
    return kRows[static_cast<std::size_t>(step)];
}

const WizardPartInfo& Wizard::part_of(Step step) { return kParts[static_cast<std::size_t>(row(step).part)]; }

// Returns the questions of these parts, in the order of Step, and Done at the end.
std::vector<Wizard::Step> Wizard::plan_of(std::span<const WizardPart> parts) {
    const auto wanted = [&](WizardPart part) { return std::find(parts.begin(), parts.end(), part) != parts.end(); };
    const bool device = std::any_of(parts.begin(), parts.end(), [](WizardPart part) {
        return kParts[static_cast<std::size_t>(part)].needs_device;
    });
    std::vector<Step> plan;
    for (int i = 0; i < static_cast<int>(Step::Done); ++i) {
        const WizardPart part = row(static_cast<Step>(i)).part;
        // If any part needs a device, the plan also includes the questions of Find and Home. The wizard skips homing if
        // the device does not need it.
        if (wanted(part) || (device && (part == WizardPart::Find || part == WizardPart::Home)))
            plan.push_back(static_cast<Step>(i));
    }
    plan.push_back(Step::Done);
    return plan;
}

}  // namespace handrail::wizard
