#include "audio-cues/plan/cue_planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "audio-cues/plan/sound_table.h"
#include "audio-cues/plan/speakable.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail::cues {
namespace {

constexpr double kSayAgain_s = 5.0;  // a text is not spoken again within this time
// Time from a touch until its name is spoken. The second surface of a corner is touched within a few ticks, and the
// first word must come within 120 ms.
constexpr double kSettle_s = 0.040;
constexpr double kChatter_s = 0.050;  // Another contact with the same feature within this time makes no new sound.
// The name of a tapped thing is still spoken if the voice becomes free within this time.
constexpr double kKeepName_s = 0.5;
// Longest time that the name of a bumped thing waits for the voice; longer, because the walker stays at the wall.
constexpr double kKeepBump_s = 2.0;
constexpr double kSlideSilent_s = 0.15;  // time without a slide event after which a slide has ended
// While the hand slides along two surfaces, the second gets the slide sound if the first had no slide event for this
// long. Slide events come every 10 ms.
constexpr double kSlideOwner_s = 0.05;
constexpr double kSlideSlowest_m_per_s = 0.004;  // speed of the hand, in hand metres, below which sliding is inaudible
// Speed of the hand, in hand metres, in a brisk tap, which sounds at full loudness.
constexpr double kFastTouch_m_per_s = 0.3;
constexpr double kDemonstrates_s = 2.5;
constexpr std::uint32_t kDemonstration = 0xffffffffU;  // source number of the loop that a demonstration plays
// Rate of the wall tone's swells, at the limit of the tone's range and at the wall.
constexpr double kSlowestPulse_hz = 1.5, kFastestPulse_hz = 8.0;
// Least loudness of alarms. The settings can make other sounds quieter than kAlarmFloor, but not alarms.
constexpr double kAlarmFloor = 0.2;

double to_decimetre(double length_m) { return std::round(length_m * 10.0) / 10.0; }

// Returns a side, as written in maps, in the language of the program.
std::string spoken_side(const std::string& side) {
    const std::string key = "side." + side;
    return has_phrase(key) ? phrase(key) : side;
}

std::string size_sentence(const Feature& feature) {
    const Vec3 size = feature.bounds_m.max_m - feature.bounds_m.min_m;
    const double x = to_decimetre(size.x), y = to_decimetre(size.y), height = to_decimetre(size.z);
    // A length that rounds to zero is left out of the text. Otherwise a flat rug would be "0 metres high", and a poster
    // would have a depth of 0.
    if (feature.kind == FeatureKind::Floor || feature.kind == FeatureKind::Ceiling || height == 0.0)
        return phrase("touched.flat", {{"width", x}, {"depth", y}});
    if (feature.kind == FeatureKind::Object && std::min(x, y) > 0.0)
        return phrase("touched.object", {{"width", std::max(x, y)}, {"depth", std::min(x, y)}, {"height", height}});
    return phrase("touched.upright", {{"width", std::max(x, y)}, {"height", height}});
}

}  // namespace

std::string describe_feature(const Scene& scene, FeatureId id, int verbosity) {
    const Feature* feature = scene.find(id);
    if (feature == nullptr || verbosity <= 0) return {};
    std::string text = verbosity == 1 ? spoken_name(*feature) : spoken_name(scene, id);
    if (text.empty() || verbosity == 1) return sentence_case(text);
    if (!feature->handle.empty())
        text = phrase("touched.handle", {{"name", text}, {"side", spoken_side(feature->handle)}});
    if (feature->base) text = phrase("touched.base", {{"name", text}});
    if (verbosity >= 3 && !feature->hinge.empty())
        text = phrase("touched.hinge", {{"name", text}, {"side", spoken_side(feature->hinge)}});
    if (verbosity >= 4) text += ". " + size_sentence(*feature);
    if (verbosity >= 3 && !feature->message.empty())
        text += (text.back() == '.' ? " " : ". ") + spoken_message(*feature);
    return sentence_case(text);
}

CuePlanner::CuePlanner(settings::Settings settings) : settings_(std::move(settings)) { hands_[1].number = 1; }

void CuePlanner::set_settings(const settings::Settings& settings) { settings_ = settings; }

void CuePlanner::enter_world(std::shared_ptr<const Scene> scene) {
    scene_ = std::move(scene);
    for (Hand& hand : hands_) {
        hand.touched.clear();
        hand.recent.clear();
    }
    order_.forget_names();
}

void CuePlanner::follow_edit(std::shared_ptr<const Scene> scene) {
    contract_pre(scene != nullptr);
    scene_ = std::move(scene);
}

void CuePlanner::tick(const CueInputs& inputs, AudioSink& audio, SpeechSink& speech) {
    contract_pre(std::isfinite(inputs.now_s));
    listener_ = inputs.listener;
    // 1. Passes the time to the sinks before any cue, so that the cues of this tick start at this time.
    audio.set_listener(inputs.listener);
    audio.set_speaking(speech.speaking());
    audio.tick(inputs.now_s);
    speech.tick(inputs.now_s);
    if (const auto news = audio.news()) alarm(*news, inputs.now_s, false);
    if (const auto news = speech.news()) alarm(*news, inputs.now_s, false);
    // 2. Handles the contact events, then the app's requests.
    for (const servo::ContactEvent& event : inputs.contacts) on_contact(event, audio);
    for (const CueRequest& request : inputs.requests) on_request(request, inputs.now_s, audio, speech);
    // 3. Ends the loops whose cause has ended.
    for (Hand& hand : hands_)
        if (hand.sliding && inputs.now_s - hand.slide_s > kSlideSilent_s) stop_slide(hand, audio);
    if (wall_tone_on_ && !settings_.sound.wall_tone) {
        audio.set_loop({.kind = SoundKind::WallTone, .loudness = 0.0});
        wall_tone_on_ = false;
    }
    keep_world_sounds(audio);
    // 4. Chooses and speaks waiting lines, only one at a time.
    speak_waiting(inputs.now_s, speech);
    demonstrate(inputs.now_s, audio, speech);
    // 5. Writes sounds as text, after any spoken text about the same thing.
    for (const SoundCue& cue : sounds_as_text_)
        if (std::string text = sound_words_.describe(cue, inputs.listener, inputs.now_s); !text.empty())
            speech.write({.text = std::move(text), .speech_class = SpeechClass::Ambient});
    sounds_as_text_.clear();
}

void CuePlanner::flush(double now_s, SpeechSink& speech) {
    order_.silence(now_s);
    write_unspoken(now_s, speech);
}

SoundClass CuePlanner::sound_of(MaterialId material) const {
    return scene_ && !scene_->materials.empty() ? scene_->material(material).sound : SoundClass::Generic;
}

double CuePlanner::volume_of(SoundKind kind) const {
    const SoundInfo& row = info(kind);
    const settings::Settings::Sound& sound = settings_.sound;
    if (row.on != nullptr && !(sound.*row.on)) return 0.0;
    const double volume = sound.volume * (sound.*row.volume);
    return kind == SoundKind::Alarm ? std::max(volume, kAlarmFloor) : volume;
}

// Notes a sound for the text sinks. A sound that is switched off is not written either; a sound whose volume is low is.
void CuePlanner::add_as_text(const SoundCue& cue) {
    const SoundInfo& row = info(cue.kind);
    if (!settings_.sound.as_text || (row.on != nullptr && !(settings_.sound.*row.on))) return;
    if (cue.loudness > 0.0) sounds_as_text_.push_back(cue);
    else sound_words_.forget(cue.kind, cue.source);
}

void CuePlanner::play(SoundCue cue, AudioSink& audio) {
    add_as_text(cue);
    cue.loudness = std::clamp(cue.loudness, 0.0, 1.0) * volume_of(cue.kind);
    if (cue.kind == SoundKind::Alarm) cue.loudness = std::max(cue.loudness, kAlarmFloor);
    if (cue.loudness > 0.0) audio.play(cue);
}

bool CuePlanner::is_touched(const Hand& hand, FeatureId feature) {
    return std::find(hand.touched.begin(), hand.touched.end(), feature) != hand.touched.end();
}

void CuePlanner::stop_slide(Hand& hand, AudioSink& audio) {
    if (hand.sliding) audio.set_loop({.kind = SoundKind::Slide, .loudness = 0.0, .source = hand.number});
    hand.sliding = false;
}

// Marks the feature as touched and requests its name.
void CuePlanner::touch(Hand& hand, const servo::ContactEvent& event) {
    if (event.feature && !is_touched(hand, event.feature)) hand.touched.push_back(event.feature);
    name_touched(hand.number, {event.feature, event.time_s, kSettle_s, kKeepName_s, event.position_m});
}

// Updates the loops of the world's sounds. They follow the app's requests, the volume settings and a stop key.
void CuePlanner::keep_world_sounds(AudioSink& audio) {
    for (const SoundCue& requested : world_sounds_) {
        SoundCue cue = requested;
        add_as_text(hushed_ ? SoundCue{.kind = cue.kind, .loudness = 0.0, .source = cue.source} : cue);
        cue.loudness = hushed_ ? 0.0 : cue.loudness * volume_of(cue.kind);
        audio.set_loop(cue);
    }
    std::erase_if(world_sounds_, [](const SoundCue& cue) { return cue.loudness <= 0.0; });
}

std::string CuePlanner::whose(std::size_t hand, std::string text) const {
    if (!two_hands_) return text;
    return hand == 0 ? phrase("voice.right_hand", {{"text", text}}) : phrase("voice.left_hand", {{"text", text}});
}

void CuePlanner::name_touched(std::size_t hand, const Naming& naming) {
    if (!scene_) return;
    std::string text = describe_feature(*scene_, naming.feature, settings_.speech.verbosity);
    if (text.empty()) return;
    if (naming.by_hand) text = whose(hand, std::move(text));
    // The first touch determines the time of the announcement, the last one the name. With a new time for each touch, a
    // hand that trembles between two surfaces would postpone the name for ever.
    const double due_s = naming.time_s + naming.settle_s;
    const auto& waits = order_.name_of(hand);
    submit({.utterance = {.text = std::move(text),
                          .speech_class = SpeechClass::Contact,
                          .right_rad = side_of(naming.at_m)},
            .requested_s = naming.time_s,
            .due_s = waits ? std::min(waits->due_s, due_s) : due_s,
            .expires_s = due_s + naming.keep_s,
            .touched = naming.feature,
            .hand = static_cast<std::uint8_t>(hand)});
}

std::optional<double> CuePlanner::side_of(const Vec3& place_m) const {
    if (!settings_.speech.from_places) return std::nullopt;
    const Vec3 way = place_m - listener_.ears_m;
    if (way.x * way.x + way.y * way.y < 1e-6) return std::nullopt;
    return std::remainder(std::atan2(way.x, way.y) - listener_.heading_rad, 2.0 * kPi);
}

void CuePlanner::on_contact(const servo::ContactEvent& event, AudioSink& audio) {
    Hand& hand = hands_[event.hand];
    switch (event.kind) {
        case servo::ContactEventKind::Begin: {
            hushed_ = false;
            std::erase_if(hand.recent, [&](const RecentContact& r) { return event.time_s - r.time_s >= kChatter_s; });
            const bool chatter = std::any_of(hand.recent.begin(), hand.recent.end(),
                                             [&](const RecentContact& r) { return r.feature == event.feature; });
            if (!chatter) {
                hand.recent.push_back({event.feature, event.time_s});
                // The loudness is proportional to the square root of the speed, so that a slow touch of 1 cm/s is
                // audible over the sounds of the room.
                const double force_of_blow =
                    std::sqrt(std::min(1.0, std::max(0.0, event.speed_m_per_s) / kFastTouch_m_per_s));
                play({.kind = SoundKind::Contact,
                      .material = sound_of(event.material),
                      .position_m = event.position_m,
                      .loudness = 0.25 + 0.75 * force_of_blow,
                      .event_time_s = event.time_s},
                     audio);
            }
            touch(hand, event);
            return;
        }
        case servo::ContactEventKind::Slide: {
            // If the hand slid onto another feature without leaving the first surface, `event.feature` is not touched
            // yet.
            if (event.feature && !is_touched(hand, event.feature)) touch(hand, event);
            // In a corner the hand slides along two surfaces at once. Only the first one sounds until its slide ends,
            // because the sound would otherwise alternate between the two.
            if (hand.sliding && event.feature != hand.slide_feature && event.time_s - hand.slide_s < kSlideOwner_s)
                return;
            hand.slide_s = event.time_s;
            hand.slide_feature = event.feature;
            if (hushed_ || event.speed_m_per_s < kSlideSlowest_m_per_s) return stop_slide(hand, audio);
            const double pace = std::min(1.0, event.speed_m_per_s / kFastTouch_m_per_s);
            if (volume_of(SoundKind::Slide) == 0.0) return stop_slide(hand, audio);
            hand.sliding = true;
            audio.set_loop({.kind = SoundKind::Slide,
                            .material = sound_of(event.material),
                            .position_m = event.position_m,
                            .loudness = std::sqrt(pace) * volume_of(SoundKind::Slide),
                            .pitch = 0.75 + 0.5 * pace,
                            .event_time_s = event.time_s,
                            .source = hand.number});
            return;
        }
        case servo::ContactEventKind::End:
            std::erase(hand.touched, event.feature);
            if (hand.touched.empty() || hand.slide_feature == event.feature) stop_slide(hand, audio);
            return;
        case servo::ContactEventKind::EnterLiquid:
        case servo::ContactEventKind::LeaveLiquid: {
            const bool entering = event.kind == servo::ContactEventKind::EnterLiquid;
            if (entering) hushed_ = false;
            play({.kind = SoundKind::Splash,
                  .material = SoundClass::Water,
                  .position_m = event.position_m,
                  .loudness = entering ? 1.0 : 0.4,
                  .event_time_s = event.time_s},
                 audio);
            if (entering) touch(hand, event);
            else std::erase(hand.touched, event.feature);
            return;
        }
        case servo::ContactEventKind::FaultRaised:
            stop_slide(hand, audio);
            if (hand_stands_in_) return;
            play({.kind = servo::is_pause(event.fault) ? SoundKind::ForcesOff : SoundKind::Alarm,
                  .event_time_s = event.time_s},
                 audio);
            // A fault that must be confirmed is announced again even if it returns at once, because the person has just
            // requested the force.
            alarm(whose(event.hand, servo::fault_sentence(event.fault)), event.time_s,
                  !servo::passes_by_itself(event.fault), servo::is_lost(event.fault));
            return;
        case servo::ContactEventKind::RimPassed:
            play({.kind = SoundKind::Rim, .event_time_s = event.time_s}, audio);
            return;
        case servo::ContactEventKind::RimLeft:
            play({.kind = SoundKind::RimBack, .event_time_s = event.time_s}, audio);
            return;
        case servo::ContactEventKind::Grabbed:
            play({.kind = SoundKind::Grab, .event_time_s = event.time_s}, audio);
            return;
        case servo::ContactEventKind::LetGo:
            play({.kind = SoundKind::LetGo, .event_time_s = event.time_s}, audio);
            return;
        case servo::ContactEventKind::DeskEntered:
        case servo::ContactEventKind::DeskLeft:
            play({.kind = SoundKind::Click, .event_time_s = event.time_s}, audio);
            return;
        case servo::ContactEventKind::FaultCleared:
            if (!hand_stands_in_) play({.kind = SoundKind::ForcesOn, .event_time_s = event.time_s}, audio);
            return;
    }
}

void CuePlanner::on_request(const CueRequest& request, double now_s, AudioSink& audio, SpeechSink& speech) {
    const double requested_s = request.time_s > 0.0 ? request.time_s : now_s;
    SoundCue cue{.material = request.material,
                 .position_m = request.position_m,
                 .loudness = request.loudness,
                 .event_time_s = requested_s,
                 .muffled_db = request.muffled_db,
                 .source = request.source};
    switch (request.kind) {
        case CueRequestKind::Say:
            submit({.utterance = {.text = request.text,
                                  .speech_class = request.speech_class,
                                  .topic = request.topic,
                                  .right_rad = request.placed ? side_of(request.position_m) : std::nullopt},
                    .requested_s = requested_s,
                    .expires_s = requested_s + kKeepName_s,
                    .repeatable = request.repeatable || request.speech_class == SpeechClass::Warning});
            return;
        case CueRequestKind::Footstep:
            hushed_ = false;
            left_foot_ = !left_foot_;
            cue.kind = SoundKind::Footstep;
            cue.pitch = request.pitch *
                        // Left and right foot get a slightly different pitch, because identical steps sound like a
                        // machine.
                        (left_foot_ ? 0.97 : 1.03);
            play(cue, audio);
            return;
        case CueRequestKind::Bump: {
            hushed_ = false;
            cue.kind = SoundKind::Bump;
            const Feature* feature = scene_ ? scene_->find(request.feature) : nullptr;
            if (cue.material == SoundClass::Generic && feature != nullptr) cue.material = sound_of(feature->material);
            play(cue, audio);
            if (request.text.empty())
                name_touched(0, {request.feature, requested_s, 0.0, kKeepBump_s, request.position_m, false});
            else warn(request, requested_s, now_s, speech);
            return;
        }
        case CueRequestKind::WallTone: {
            cue.kind = SoundKind::WallTone;
            cue.loudness = hushed_ ? 0.0 : std::clamp(request.loudness, 0.0, 1.0) * volume_of(SoundKind::WallTone);
            // The rhythm indicates the distance where loudness and direction cannot, for example through a single
            // loudspeaker.
            cue.pulses_per_s =
                kSlowestPulse_hz + (kFastestPulse_hz - kSlowestPulse_hz) * std::clamp(request.loudness, 0.0, 1.0);
            const bool on = cue.loudness > 0.0;
            add_as_text(cue);
            if (on || wall_tone_on_) audio.set_loop(cue);
            wall_tone_on_ = on;
            return;
        }
        case CueRequestKind::Interrupt:
            end_demonstration(audio);
            press(now_s, speech);
            return;
        case CueRequestKind::StopSpeech:
        case CueRequestKind::SilenceAll:
            end_demonstration(audio);
            speech.stop();
            order_.silence(now_s);
            if (request.kind == CueRequestKind::StopSpeech) return;
            audio.stop_all();
            for (Hand& hand : hands_) hand.sliding = false;
            wall_tone_on_ = false;
            hushed_ = true;
            return;
        case CueRequestKind::Play:
            cue.kind = request.sound;
            cue.pitch = request.pitch;
            play(cue, audio);
            return;
        case CueRequestKind::Demonstrate:
            end_demonstration(audio);
            cue.kind = request.sound;
            cue.source = kDemonstration;
            if (cue.kind == SoundKind::WallTone) cue.pulses_per_s = 0.5 * (kSlowestPulse_hz + kFastestPulse_hz);
            demonstration_ = Demonstration{.cue = cue};
            answer(request.text, requested_s);
            return;
        case CueRequestKind::WorldSound: {
            cue.kind = request.sound;
            cue.loudness = std::clamp(request.loudness, 0.0, 1.0);
            cue.pulses_per_s = request.pulses_per_s;
            const auto same = std::find_if(world_sounds_.begin(), world_sounds_.end(), [&](const SoundCue& known) {
                return known.kind == cue.kind && known.source == cue.source;
            });
            if (same != world_sounds_.end()) *same = cue;
            else world_sounds_.push_back(cue);
            return;
        }
        case CueRequestKind::Repeat: {
            press(now_s, speech);
            submit({.utterance = {.text = spoken_.empty() ? phrase("voice.nothing_said") : spoken_.back().text,
                                  .topic = last_topic_},
                    .requested_s = requested_s,
                    .repeatable = true,
                    .again = true});
            return;
        }
        case CueRequestKind::HistoryBack:
        case CueRequestKind::HistoryForward:
            press(now_s, speech);
            step_history(request.kind == CueRequestKind::HistoryBack, requested_s);
            return;
    }
}

void CuePlanner::submit(SpeechLine line) {
    const SpeechClass speech_class = line.utterance.speech_class;
    const bool always = speech_class == SpeechClass::Alarm || speech_class == SpeechClass::Answer ||
                        line.utterance.topic == SpeechTopic::Steps;
    line.utterance.text = speakable(line.utterance.text);
    if (line.utterance.text.empty() || (!always && settings_.speech.verbosity <= 0)) return;
    order_.add(std::move(line));
}

void CuePlanner::alarm(const std::string& text, double requested_s, bool repeatable, bool cuts) {
    submit({.utterance = {.text = text, .speech_class = SpeechClass::Alarm},
            .requested_s = requested_s,
            .repeatable = repeatable,
            .cuts = cuts});
}

void CuePlanner::answer(std::string text, double requested_s) {
    submit({.utterance = {.text = std::move(text)}, .requested_s = requested_s, .repeatable = true});
}

// Reports a blocked step. If the same text was spoken within kSayAgain_s, it is only written. A reader thus gets an
// answer to each step, and a listener only the thud.
void CuePlanner::warn(const CueRequest& request, double requested_s, double now_s, SpeechSink& speech) {
    if (settings_.speech.verbosity <= 0) return;
    const auto said = said_at_s_.find(speakable(request.text));
    if (said == said_at_s_.end() || now_s - said->second >= kSayAgain_s)
        return submit({.utterance = {.text = request.text,
                                     .speech_class = SpeechClass::Warning,
                                     .right_rad = side_of(request.position_m)},
                       .requested_s = requested_s,
                       .repeatable = true});
    said->second = now_s;
    SpeechLine again{.utterance = {.text = speakable(request.written.empty() ? request.text : request.written),
                                   .speech_class = SpeechClass::Warning},
                     .requested_s = requested_s,
                     .repeatable = true};
    if (keep_line(again, now_s)) speech.write(again.utterance);
}

void CuePlanner::press(double now_s, SpeechSink& speech) {
    // Some lines may have been requested before this key in the same step. If no line is being spoken, the next of them
    // is passed to the sink first: text shows it, and a voice begins it and is cut.
    if (!speech.speaking()) speak_waiting(now_s, speech);
    if (order_.key(now_s, speech.speaking())) speech.stop();
}

void CuePlanner::write_unspoken(double now_s, SpeechSink& speech) {
    for (const SpeechLine& line : order_.take_unspoken())
        if (keep_line(line, now_s)) speech.write(line.utterance);
}

void CuePlanner::speak_waiting(double now_s, SpeechSink& speech) {
    const SpeechOrder::Knows knows{
        .touches = [this](const SpeechLine& name) { return is_touched(hands_.at(name.hand), name.touched); },
        .said =
            [&](const SpeechLine& line) {
                const auto said = said_at_s_.find(line.utterance.text);
                return said != said_at_s_.end() && now_s - said->second < kSayAgain_s;
            }};
    while (const auto line = order_.next(now_s, speech.speaking(), knows)) {
        write_unspoken(now_s, speech);
        say_now(*line, now_s, speech);
    }
    write_unspoken(now_s, speech);
}

// Moves one line back or forward in the list of spoken lines. If a new line has been spoken since the last call, the
// list starts again at the newest line.
void CuePlanner::step_history(bool back, double requested_s) {
    std::vector<const SpokenLine*> lines;  // the newest line is first
    for (auto line = spoken_.rbegin(); line != spoken_.rend() && lines.size() < kMostHistory; ++line)
        if (!line->again) lines.push_back(&*line);
    const std::size_t wanted = back ? back_ + 1 : std::max<std::size_t>(back_, 1) - 1;
    std::string text;
    if (lines.empty()) {
        text = phrase("voice.nothing_said");
    } else if (wanted == 0) {
        text = phrase("voice.newest");
    } else if (wanted > lines.size()) {
        text = phrase("voice.oldest");
    } else {
        back_ = wanted;
        text = phrase("voice.history", {{"text", lines[wanted - 1]->text}, {"number", wanted}, {"all", lines.size()}});
    }
    submit({.utterance = {.text = std::move(text)}, .requested_s = requested_s, .repeatable = true, .again = true});
}

bool CuePlanner::keep_line(const SpeechLine& line, double now_s) {
    std::erase_if(said_at_s_, [&](const auto& said) { return now_s - said.second >= kSayAgain_s; });
    const auto [said, is_new] = said_at_s_.try_emplace(line.utterance.text, now_s);
    if (!is_new && !line.repeatable) return false;
    said->second = now_s;
    if (spoken_.size() == kMaxSpoken) spoken_.erase(spoken_.begin());
    spoken_.push_back({now_s, line.utterance.text, line.utterance.speech_class, line.again});
    if (!line.again) back_ = 0, last_topic_ = line.utterance.topic;
    ++spoken_in_all_;
    return true;
}

void CuePlanner::say_now(const SpeechLine& line, double now_s, SpeechSink& speech) {
    if (!keep_line(line, now_s)) return;
    Utterance utterance = line.utterance;
    utterance.loudness = std::clamp(settings_.sound.volume * settings_.sound.speech_volume, 0.0, 1.0);
    if (utterance.speech_class == SpeechClass::Alarm) utterance.loudness = std::max(utterance.loudness, kAlarmFloor);
    speech.say(utterance);
}

// The name is spoken before the sound plays, so that neither masks the other.
void CuePlanner::demonstrate(double now_s, AudioSink& audio, const SpeechSink& speech) {
    if (!demonstration_) return;
    Demonstration& shown = *demonstration_;
    if (shown.playing) {
        if (now_s >= shown.ends_s) end_demonstration(audio);
        return;
    }
    if (order_.answers_wait() || speech.speaking()) return;
    const SoundInfo& row = info(shown.cue.kind);
    shown.cue.loudness = std::max(kAlarmFloor, settings_.sound.volume * (settings_.sound.*row.volume));
    shown.cue.event_time_s = now_s;
    shown.playing = true;
    shown.ends_s = now_s + kDemonstrates_s;
    const bool loop =
        is_world_sound(shown.cue.kind) || shown.cue.kind == SoundKind::Slide || shown.cue.kind == SoundKind::WallTone;
    if (loop) return audio.set_loop(shown.cue);
    audio.play(shown.cue);
    demonstration_.reset();
}

void CuePlanner::end_demonstration(AudioSink& audio) {
    if (!demonstration_) return;
    SoundCue silent = demonstration_->cue;
    silent.loudness = 0.0;
    if (demonstration_->playing) audio.set_loop(silent);
    demonstration_.reset();
}

}  // namespace handrail::cues
