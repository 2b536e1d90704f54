// Manages the person's marks in the present world: the person can set, rename, delete and choose them. The class also
// plays a sound if the hand or the walker comes near a mark, a landmark or a clue. marks.h defines how marks are
// stored. Lengths are in world metres, unless a name says otherwise. Use this class on the app thread only.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/wayfinding/stops.h"

namespace handrail::core {

class MarkList : SessionPart {
public:
    // `marks` are the marks of the present world. The session state stores them, so that every feature can read them.
    MarkList(const SessionContext& context, std::vector<Mark>& marks) : SessionPart(context), marks_(marks) {}

    // Reads the marks from the side file. announce_faults() later announces the errors.
    void enter_world();
    void announce_faults(double now_s);
    // Reads the marks again. Call it when another session has changed the marks in the side file.
    void take_again();
    // Carries out the commands DropMark, DeleteMark and Marks. Returns false for other commands.
    bool act(Command command, double now_s);
    // Sets a mark if the person has pressed the button on the device.
    void tick_button(double now_s);
    // Plays a sound if the hand or the walker comes near a mark, landmark or clue. Also announces the name of a mark.
    void tick(double now_s);

    // A row that comes before the marks in their list.
    struct Row {
        ListItem item;
        std::function<void(double now_s)> chosen;
        // Changes the value of an adjustable row. Returns the new value in words.
        std::function<std::string(int by)> adjusted{};
    };
    // The session sets these functions. `rows_above` returns the present rows above the marks. `on_find` is called when
    // the person wants to find the chosen mark.
    std::function<std::vector<Row>()> rows_above;
    std::function<void(const Goal& mark, double now_s)> on_find;

private:
    void list_landmarks();
    void read(std::vector<Error>& faults);
    bool save(double now_s);
    void save_and_answer(const std::string& words, double now_s);
    void drop(bool by_button, double now_s);
    void rename(const std::string& name, const std::string& typed, double now_s);
    void remove(std::size_t which, double now_s);
    std::vector<ListItem> items() const;
    void open_delete(double now_s);
    void open(double now_s);

    std::vector<Mark>& marks_;
    std::vector<Error> faults_;  // errors that have not been announced
    // The places that the hand and the walker are near, so that each mark or landmark is announced once.
    std::vector<bool> near_;                // for each mark, in the order of the marks
    std::vector<FeatureId> landmarks_;      // landmarks and clues of the scene `listed_of_`
    std::weak_ptr<const Scene> listed_of_;  // a weak pointer, so that the scene can be destroyed
    std::vector<FeatureId> landmarks_near_;
    FeatureId touched_ = kNoFeature;
    bool first_look_ = true;  // true: what is near is not announced, because a world has just been entered
    // Buttons of the device one tick earlier. They are not reset when another world is entered, because the device is
    // the same.
    std::uint32_t buttons_ = 0;
};

}  // namespace handrail::core
