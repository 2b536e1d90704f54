#include "app/record/played_bodies.h"

#include <deque>
#include <utility>
#include <vector>

#include "app/record/json_fields.h"
#include "haptic/dynamics/dynamics_loop.h"

namespace handrail::record {
namespace {

// Stores the frames of an engine that one reader (a hand or the session) will read.
class FramesRead {
public:
    void will_read(std::uint64_t number) {
        if (number > 0 && (wanted_.empty() || wanted_.back() < number)) wanted_.push_back(number);
    }
    void offer(const render::DynamicsFrame& frame) {
        while (!wanted_.empty() && wanted_.front() < frame.number) wanted_.pop_front();
        if (wanted_.empty() || wanted_.front() != frame.number) return;
        wanted_.pop_front();
        there_.push_back(frame);
    }
    // Returns the frame with that number; null if it is not available. The pointer is valid until the next call.
    const render::DynamicsFrame* take(std::uint64_t number) {
        while (!there_.empty() && there_.front().number < number) there_.pop_front();
        if (there_.empty() || there_.front().number != number) return nullptr;
        taken_ = there_.front();
        there_.pop_front();
        return &taken_;
    }

private:
    std::deque<std::uint64_t> wanted_;  // the numbers of the frames that the reader will read, in rising order
    std::deque<render::DynamicsFrame> there_;
    render::DynamicsFrame taken_;
};

constexpr std::size_t kSession = 2;  // index of the session in Book::frames, after those of the two hands

}  // namespace

// The data of one engine. The object remains after the engine itself has ended.
struct PlayedBodies::Book {
    std::vector<dynamics::EngineRow> rows;
    std::array<FramesRead, 3> frames;  // frames for the two hands and the session
    std::array<std::shared_ptr<render::HandChannel>, 2> hands;
    std::array<std::uint64_t, 2> published{};  // for each hand: number of the last frame that was published to it
    // Pushes and places of each hand that no step of the engine has read yet.
    std::array<std::deque<render::HandPush>, 2> pushes;
    std::array<std::deque<render::HandPlace>, 2> places;
    Engine* engine = nullptr;  // the engine of this book; null after it has ended
};

class PlayedBodies::Engine : public dynamics::BodyEngine {
public:
    Engine(std::shared_ptr<const render::DynamicsScene> scene, double begin_s, PlayedBodies& all, Book& book,
           std::uint32_t number)
        : all_(all), book_(book), number_(number), dynamics_(std::move(scene)) {
        dynamics_.skip(begin_s);
        book_.engine = this;
        for (auto& hand : book_.hands) {
            hand = std::make_shared<render::HandChannel>();
            hand->engine = number;
        }
    }
    // Compute the remaining rows, because a hand may have read results of later steps before the engine ended.
    ~Engine() override {
        while (!all_.closed_ && next_ < book_.rows.size() && step()) {
        }
        book_.engine = nullptr;
    }

    std::shared_ptr<render::HandChannel> hand(unsigned which) const override { return book_.hands.at(which); }

    bool order(const Order& order) override {
        if (all_.refused_.contains(++all_.orders_)) return false;
        orders_.push_back(order);
        return true;
    }
    void drive(const DrivenPoses& poses) override {
        driven_.push_back(poses);
        ++drives_;
    }
    bool newer_frame_for_app() override {
        const std::uint64_t due = all_.due_.engine == number_ ? all_.due_.engine_frame : 0;
        if (due <= frame_.number || !run_to(due)) return false;
        const render::DynamicsFrame* const read = book_.frames[kSession].take(due);
        if (!read) return fails();
        frame_ = *read;
        return true;
    }
    const render::DynamicsFrame& frame_for_app() const override { return frame_; }
    bool take_event(render::BodyEvent& event) override {
        if (all_.due_.engine != number_ || events_taken_ >= all_.due_.engine_events) return false;
        while (events_.empty())
            if (!step()) return false;
        event = events_.front();
        events_.pop_front();
        ++events_taken_;
        return true;
    }

    bool run_to(std::uint64_t frame) {
        while (now_.number < frame)
            if (!step()) return false;
        return true;
    }

private:
    bool fails() {
        all_.failed_ = true;
        return false;
    }

    bool step() {
        if (all_.failed_ || stepping_ || next_ >= book_.rows.size()) return fails();
        stepping_ = true;
        const dynamics::EngineRow& row = book_.rows[next_];
        const bool all_there = row.step == now_.number + 1 && orders_.size() >= row.orders && drives_ >= row.driven &&
                               row.driven >= driven_taken_ && hand_is_there(0, row) && hand_is_there(1, row);
        stepping_ = false;
        if (!all_there) return fails();
        ++next_;
        make(row);
        return true;
    }

    // Computes ticks of the hand until the hand has made all pushes and places that this step read. Returns false if
    // that is impossible.
    bool hand_is_there(std::size_t which, const dynamics::EngineRow& row) {
        while (book_.pushes[which].size() < row.pushes[which])
            if (!all_.step_hand_(which)) return false;
        const double place_s = row.places_s[which];
        if (place_s == places_s_[which] || place_s <= 0.0) return true;
        std::deque<render::HandPlace>& places = book_.places[which];
        while (places.empty() || places.back().time_s < place_s)
            if (!all_.step_hand_(which)) return false;
        while (places.front().time_s < place_s) places.pop_front();
        return places.front().time_s == place_s;
    }

    // Computes one step. Applies pushes, places and orders in the same order as DynamicsLoop.
    void make(const dynamics::EngineRow& row) {
        if (row.skipped > 0) dynamics_.skip(static_cast<double>(row.skipped) * dynamics::Dynamics::kStep_s);
        for (std::uint32_t i = 0; i < row.orders; ++i) {
            dynamics::carry_out(dynamics_, orders_.front());
            orders_.pop_front();
        }
        if (row.driven != driven_taken_) {
            while (drives_ - driven_.size() + 1 < row.driven) driven_.pop_front();
            if (driven_.front()) dynamics::carry_out(dynamics_, *driven_.front());
            driven_taken_ = row.driven;
        }
        for (unsigned which = 0; which < 2; ++which) {
            if (std::exchange(places_s_[which], row.places_s[which]) != row.places_s[which])
                dynamics_.place_hand(which,
                                     row.places_s[which] > 0.0 ? book_.places[which].front() : render::HandPlace{});
            for (std::uint32_t i = 0; i < row.pushes[which]; ++i) {
                dynamics_.push(which, book_.pushes[which].front());
                book_.pushes[which].pop_front();
            }
        }
        heard_.clear();
        dynamics_.step(now_, heard_);
        for (std::size_t i = 0; i < heard_.size() && i < row.events; ++i) events_.push_back(heard_[i]);
        if (!row.published) return;
        for (FramesRead& frames : book_.frames) frames.offer(now_);
    }

    PlayedBodies& all_;
    Book& book_;
    const std::uint32_t number_;
    dynamics::Dynamics dynamics_;
    std::size_t next_ = 0;  // index of the next row
    bool stepping_ = false;
    // `now_` is the frame of the last step; `frame_` is the frame that the session last read.
    render::DynamicsFrame now_, frame_;
    std::vector<render::BodyEvent> heard_;
    std::deque<render::BodyEvent> events_;
    std::uint64_t events_taken_ = 0;
    std::deque<Order> orders_;
    std::deque<DrivenPoses> driven_;
    std::uint32_t drives_ = 0, driven_taken_ = 0;
    std::array<double, 2> places_s_{};  // EngineRow::places_s of the last step
};

PlayedBodies::PlayedBodies(const Recording& recording, std::function<bool(std::size_t which)> step_hand)
    : recording_(recording), step_hand_(std::move(step_hand)) {
    if (!recorded()) return;
    for (const dynamics::EngineRow& row : recording.bodies) book(row.engine).rows.push_back(row);
    for (std::size_t which = 0; which < 2; ++which)
        for (const servo::HandRow& row : recording.hands[which])
            if (row.bodies.engine > 0) book(row.bodies.engine).frames[which].will_read(row.bodies.frame);
    for (const FrameRow& row : recording.frames)
        if (row.engine > 0) book(row.engine).frames[kSession].will_read(row.engine_frame);
    for (const RecordedLine& line : recording.lines)
        if (line.is == "order_refused") {
            const Json json = Json::parse(line.json, nullptr, false);
            const auto number = json.find("number");
            if (number != json.end() && number->is_number_unsigned()) refused_.insert(number->get<std::uint64_t>());
        }
}

PlayedBodies::~PlayedBodies() = default;

PlayedBodies::Book& PlayedBodies::book(std::uint32_t engine) {
    std::unique_ptr<Book>& book = books_[engine];
    if (!book) book = std::make_unique<Book>();
    return *book;
}

std::unique_ptr<dynamics::BodyEngine> PlayedBodies::make(std::shared_ptr<const render::DynamicsScene> scene,
                                                         double begin_s) {
    ++made_;
    return std::make_unique<Engine>(std::move(scene), begin_s, *this, book(made_), made_);
}

void PlayedBodies::session_reads(const FrameRow& row) { due_ = row; }

bool PlayedBodies::before_tick(std::size_t which, const servo::HandRow& row) {
    if (row.bodies.engine == 0 || !recorded()) return true;
    Book& of = book(row.bodies.engine);
    const std::uint64_t frame = row.bodies.frame;
    if (frame <= of.published[which]) return true;
    if (!of.hands[which] || (of.engine && !of.engine->run_to(frame))) return false;
    const render::DynamicsFrame* const read = of.frames[which].take(frame);
    if (!read) {
        failed_ = true;
        return false;
    }
    of.hands[which]->frame.publish(*read);
    of.published[which] = frame;
    return true;
}

void PlayedBodies::after_tick(std::size_t which, const servo::HandRow& row, servo::HandBodyServo* engine) {
    if (!engine || row.bodies.engine == 0 || !recorded()) return;
    Book& of = book(row.bodies.engine);
    render::HandChannel& channel = engine->channel();
    if (channel.place.refresh() && channel.place.read().present()) of.places[which].push_back(channel.place.read());
    for (render::HandPush push; channel.pushes.pop(push);)
        if (!engine->take_back(row.bodies.refused, push)) of.pushes[which].push_back(push);
}

}  // namespace handrail::record
