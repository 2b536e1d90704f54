// The part of Session that passes commands to the features, with a table of the features that carry out each command.
// Use it on the app thread only.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/core/context/spotlight.h"
#include "app/core/menu/understood_list.h"
#include "app/core/session/session.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail::core {

struct Session::Carriers {
    // A function that passes a command to a feature. It returns false if the feature cannot use the command in its
    // present state.
    using Carrier = bool (*)(Session& session, Command command, double now_s, int times);
    struct Row {
        Command command;
        std::array<Carrier, 2> games;  // functions that are tried first, for a game or a held thing
        std::array<Carrier, 2> carriers;
    };

    static bool labyrinth(Session& s, Command c, double now_s, int times) { return s.labyrinth_.act(c, now_s, times); }
    static bool bodies(Session& s, Command c, double now_s, int times) { return s.bodies_.act(c, now_s, times); }
    static bool walking(Session& s, Command c, double now_s, int times) { return s.walk_.walking.act(c, now_s, times); }
    static bool cane(Session& s, Command c, double now_s, int) { return s.walk_.cane.act(c, now_s); }
    static bool spotlight(Session& s, Command, double now_s, int) {
        turn_spotlight_on(s.state_.context, now_s);
        return true;
    }
    static bool workspace(Session& s, Command c, double now_s, int) { return s.hand_.workspace.act(c, now_s); }
    static bool forces(Session& s, Command c, double now_s, int) { return s.hand_.forces.act(c, now_s); }
    static bool place(Session& s, Command c, double now_s, int) { return s.learn_.place.act(c, now_s); }
    static bool hunt(Session& s, Command c, double now_s, int) { return s.learn_.hunt.act(c, now_s); }
    static bool queries(Session& s, Command c, double now_s, int) { return s.where_.queries.act(c, now_s); }
    static bool far(Session& s, Command c, double now_s, int) { return s.where_.far.act(c, now_s); }
    static bool rooms(Session& s, Command c, double now_s, int) { return s.where_.rooms.act(c, now_s); }
    static bool climbs(Session& s, Command c, double now_s, int) { return s.where_.climbs.act(c, now_s); }
    static bool doors(Session& s, Command c, double now_s, int) { return s.movers_.doors.act(c, now_s); }
    static bool marks(Session& s, Command c, double now_s, int) { return s.places_.marks.act(c, now_s); }
    static bool labels(Session& s, Command c, double now_s, int) { return s.places_.labels.act(c, now_s); }
    static bool quiz(Session& s, Command c, double now_s, int) { return s.places_.quiz.act(c, now_s); }
    static bool groups(Session& s, Command c, double now_s, int) { return s.places_.groups.act(c, now_s); }
    static bool ways(Session& s, Command c, double now_s, int) { return s.places_.ways.act(c, now_s); }
    static bool guide(Session& s, Command c, double now_s, int) { return s.guide_.act(c, now_s); }
    static bool menu(Session& s, Command c, double now_s, int) { return s.menu_.act(c, now_s); }
    static bool lessons(Session& s, Command c, double now_s, int) { return s.lesson_session_.act(c, now_s); }
    static bool exercise(Session& s, Command c, double now_s, int) { return s.learn_.teaching.exercise.act(c, now_s); }
    static bool itself(Session& s, Command c, double now_s, int) { return s.act_itself(c, now_s); }

    // The rows are in the order of the enum Command.
    static constexpr std::array kRows{
        Row{Command::Forward, {bodies, labyrinth}, {walking}},
        Row{Command::Back, {bodies, labyrinth}, {walking}},
        Row{Command::TurnLeft, {bodies, labyrinth}, {walking}},
        Row{Command::TurnRight, {bodies, labyrinth}, {walking}},
        Row{Command::SideLeft, {}, {walking}},
        Row{Command::SideRight, {}, {walking}},
        Row{Command::TiltUp, {bodies}, {walking}},
        Row{Command::TiltDown, {bodies}, {walking}},
        Row{Command::ToggleForces, {}, {forces}},
        Row{Command::SwitchFrame, {}, {workspace}},
        Row{Command::ScaleBuilding, {}, {workspace}},
        Row{Command::ScaleFloor, {}, {workspace}},
        Row{Command::ScaleRoom, {}, {workspace}},
        Row{Command::ScaleDetail, {}, {workspace}},
        Row{Command::WorkspaceForward, {}, {workspace}},
        Row{Command::WorkspaceBack, {}, {workspace}},
        Row{Command::WorkspaceLeft, {}, {workspace}},
        Row{Command::WorkspaceRight, {}, {workspace}},
        Row{Command::WorkspaceUp, {}, {workspace}},
        Row{Command::WorkspaceDown, {}, {workspace}},
        Row{Command::WorkspaceTurnLeft, {bodies}, {workspace}},
        Row{Command::WorkspaceTurnRight, {bodies}, {workspace}},
        Row{Command::WorkspaceCentre, {}, {workspace}},
        Row{Command::Grab, {}, {workspace}},
        Row{Command::WhereAmI, {}, {queries}},
        Row{Command::Heading, {}, {queries}},
        Row{Command::AroundMe, {}, {queries}},
        Row{Command::AheadOfMe, {}, {queries}},
        Row{Command::Spotlight, {}, {spotlight}},
        Row{Command::Lost, {}, {far}},
        Row{Command::Describe, {}, {far}},
        Row{Command::Overview, {labyrinth}, {far}},
        Row{Command::Storeys, {}, {guide}},
        Row{Command::AboveBelow, {}, {far}},
        Row{Command::Places, {}, {guide}},
        Row{Command::LookNext, {}, {queries}},
        Row{Command::LookBefore, {}, {queries}},
        Row{Command::ScaleBar, {}, {queries}},
        Row{Command::Simplified, {}, {itself}},
        Row{Command::Understood, {}, {itself}},
        Row{Command::Faults, {}, {itself}},
        Row{Command::Coordinates, {}, {queries}},
        Row{Command::WhatIsThis, {}, {queries}},
        Row{Command::Repeat, {}, {itself}},
        Row{Command::HistoryBack, {}, {itself}},
        Row{Command::HistoryForward, {}, {itself}},
        Row{Command::StopSpeech, {}, {itself}},
        Row{Command::StopEverything, {}, {itself}},
        Row{Command::Home, {}, {walking}},
        Row{Command::BringOut, {}, {itself}},
        Row{Command::LastPlace, {}, {itself}},
        Row{Command::Use, {bodies}, {climbs, doors}},
        Row{Command::PutBack, {labyrinth, bodies}, {}},
        Row{Command::DropMark, {}, {marks}},
        Row{Command::DeleteMark, {}, {marks}},
        Row{Command::Marks, {}, {marks}},
        Row{Command::SetBeacon, {}, {guide}},
        Row{Command::MuteBeacon, {}, {guide}},
        Row{Command::TakeMe, {}, {guide}},
        Row{Command::Find, {}, {guide}},
        Row{Command::CrossLines, {}, {guide}},
        Row{Command::Exits, {}, {rooms}},
        Row{Command::UnvisitedExits, {}, {rooms}},
        Row{Command::Routes, {}, {guide}},
        Row{Command::RepeatLeg, {}, {guide}},
        Row{Command::NextLeg, {}, {guide}},
        Row{Command::RestOfRoute, {}, {guide}},
        Row{Command::FaceRoute, {}, {guide}},
        Row{Command::NameRoom, {}, {rooms}},
        Row{Command::AskHere, {}, {quiz}},
        Row{Command::Quiz, {}, {quiz}},
        Row{Command::Groups, {}, {groups}},
        Row{Command::Diary, {}, {place}},
        Row{Command::Label, {}, {labels}},
        Row{Command::KeptRoutes, {}, {ways}},
        Row{Command::KeepRoute, {}, {ways}},
        Row{Command::PlanView, {}, {itself}},
        Row{Command::FullScreen, {}, {itself}},
        Row{Command::Menu, {}, {menu}},
        Row{Command::Help, {}, {menu}},
        Row{Command::InputHelp, {}, {menu}},
        Row{Command::Lessons, {}, {lessons}},
        Row{Command::FirstMinutes, {}, {lessons}},
        Row{Command::Task, {}, {exercise}},
        Row{Command::TaskDone, {}, {exercise}},
        Row{Command::Learners, {}, {exercise}},
        Row{Command::Language, {}, {menu}},
        Row{Command::Presets, {}, {menu}},
        Row{Command::Devices, {}, {menu}},
        Row{Command::NextSound, {}, {itself}},
        Row{Command::LastSound, {}, {itself}},
        Row{Command::VerbosityCycle, {}, {itself}},
        Row{Command::TrailLeft, {}, {walking}},
        Row{Command::TrailRight, {}, {walking}},
        Row{Command::TrailOn, {}, {walking}},
        Row{Command::TrailBack, {}, {walking}},
        Row{Command::SquareUp, {}, {walking}},
        Row{Command::LeapNext, {}, {guide, walking}},
        Row{Command::LeapLast, {}, {guide, walking}},
        Row{Command::UndoLeap, {}, {walking}},
        Row{Command::Retrace, {}, {walking}},
        Row{Command::FreeLeft, {}, {walking}},
        Row{Command::FreeRight, {}, {walking}},
        Row{Command::Callouts, {}, {itself}},
        Row{Command::Cane, {}, {cane}},
        Row{Command::CaneTechnique, {}, {cane}},
        Row{Command::CaneLeft, {}, {cane}},
        Row{Command::CaneRight, {}, {cane}},
        Row{Command::Unexplored, {}, {place}},
        Row{Command::ProgressReport, {}, {place}},
        Row{Command::LearnPlace, {}, {place}},
        Row{Command::LearntRooms, {}, {place}},
        Row{Command::Hunt, {}, {hunt}},
        Row{Command::Labyrinth, {labyrinth}, {}},
        Row{Command::Calibrate, {}, {itself}},
        Row{Command::Leave, {}, {itself}},
        Row{Command::HandForward, {}, {workspace}},
        Row{Command::HandBack, {}, {workspace}},
        Row{Command::HandLeft, {}, {workspace}},
        Row{Command::HandRight, {}, {workspace}},
        Row{Command::HandUp, {}, {workspace}},
        Row{Command::HandDown, {}, {workspace}},
        Row{Command::HandCentre, {}, {workspace}},
        Row{Command::Desk, {}, {itself}},
    };
    static constexpr const Row& row_of(Command command) { return kRows.at(static_cast<std::size_t>(command)); }
    static constexpr bool in_order() {
        for (std::size_t i = 0; i < kRows.size(); ++i)
            if (kRows[i].command != static_cast<Command>(i)) return false;
        return true;
    }
};

void Session::carry_out(Command command, double now_s, int times) {
    static_assert(Carriers::in_order());
    if (command == Command::Lost) walk_.walking.halt();
    const Carriers::Row& row = Carriers::row_of(command);
    const auto carried = [&](Carriers::Carrier carrier) { return carrier && carrier(*this, command, now_s, times); };
    if (std::any_of(row.games.begin(), row.games.end(), carried)) return;
    if (row.carriers.front() != Carriers::walking) walk_.walking.notice(command, now_s);
    const bool by_somebody = std::any_of(row.carriers.begin(), row.carriers.end(), carried);
    contract_pre(by_somebody);
}

// Carries out the commands that belong to no single feature. Returns false for all other commands.
bool Session::act_itself(Command command, double now_s) {
    switch (command) {
        case Command::Simplified:
            simplified_list_.open(hand_.touch_view.plan(), hand_.touch_view.portals(), hand_.touch_view.coarser(),
                                  now_s);
            break;
        case Command::Understood:
            open_understood(
                state_.context, [this](const Goal& goal, double then_s) { guide_.open_tools(goal, then_s); }, now_s);
            break;
        case Command::Faults:
            places_.faults.open(now_s);
            break;
        case Command::Repeat:
        case Command::HistoryBack:
        case Command::HistoryForward:
        case Command::StopSpeech: {
            cues::CueRequest request;
            request.kind = command == Command::Repeat           ? cues::CueRequestKind::Repeat
                           : command == Command::HistoryBack    ? cues::CueRequestKind::HistoryBack
                           : command == Command::HistoryForward ? cues::CueRequestKind::HistoryForward
                                                                : cues::CueRequestKind::StopSpeech;
            request.time_s = now_s;
            cue(std::move(request));
            break;
        }
        case Command::StopEverything:
            if (hand_.forces.stop(now_s)) walk_.walking.fall_silent();
            break;
        case Command::BringOut:
            bring_out(now_s);
            break;
        case Command::LastPlace:
            offer_last_place(now_s);
            break;
        case Command::PlanView:
            shown_.pictures = shown_.pictures == Pictures::Both   ? Pictures::Plan
                              : shown_.pictures == Pictures::Plan ? Pictures::FirstPerson
                                                                  : Pictures::Both;
            answer(phrase(shown_.pictures == Pictures::Both   ? "session.both_pictures"
                          : shown_.pictures == Pictures::Plan ? "session.plan"
                                                              : "session.first_person"),
                   now_s);
            break;
        case Command::FullScreen: {
            const bool full = !state_.person.settings.display.full_screen;
            state_.context.set("display.full_screen", full ? "true" : "false", now_s);
            answer(phrase(full ? "session.full_screen" : "session.no_full_screen"), now_s);
            break;
        }
        case Command::NextSound:
            cue(dictionary_.step(1, listener(), now_s));
            break;
        case Command::LastSound:
            cue(dictionary_.step(-1, listener(), now_s));
            break;
        case Command::Callouts:
            state_.context.set("walk.callouts", state_.person.settings.walk.callouts ? "false" : "true", now_s);
            answer(phrase(state_.person.settings.walk.callouts ? "walking.callouts_on" : "walking.callouts_off"),
                   now_s);
            break;
        case Command::VerbosityCycle:
            state_.context.set("speech.verbosity", fmt::format("{}", (state_.person.settings.speech.verbosity + 1) % 5),
                               now_s);
            answer(phrase("session.verbosity", {{"level", state_.person.settings.speech.verbosity}}), now_s);
            break;
        case Command::Calibrate:
            state_.requests.set_up = true;
            break;
        case Command::Desk:
            desk_visit_.open_list(now_s);
            break;
        case Command::Leave:
            if (at_desk()) {
                // A jump of the workspace ends the visit to the desk.
                publish_pose(now_s, PoseChange::Moved);
            } else if (leave_requested_.lately(now_s)) {
                state_.requests.leave = true;
                answer(phrase("session.goodbye"), now_s);
            } else {
                leave_requested_.at_s = now_s;
                answer(phrase("session.leave_again"), now_s);
            }
            break;
        default:
            return false;
    }
    return true;
}

}  // namespace handrail::core
