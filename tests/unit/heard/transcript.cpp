#include "tests/unit/heard/transcript.h"
#include "tests/support/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace handrail::test {
namespace {

constexpr double kHz = 48000.0;
// The search first uses 4 kHz over 0.1 s, then 16 kHz around the place that it found. The voice begins each line at
// once, so a later match would be another line with the same text.
constexpr std::size_t kCoarse = 12, kFine = 3;
constexpr double kSearched_s = 0.1, kBeginning_s = 0.6, kPiece_s = 0.25;
constexpr double kAlike = 0.5;  // least correlation of a piece with the mix; the mix includes the sounds
// If the mix has less energy than this fraction of the line's energy, the mix is treated as silent there.
constexpr double kSilence = 1e-3;
constexpr double kQuiet_db = -30.0;  // a piece that is this much quieter than the loudest piece is a pause
// Share of the pieces that must be heard. A sound may cover the others, and in a short line one piece.
constexpr double kShareInFull = 0.9;

// Adds both ears and every `step` samples to one sample.
std::vector<float> thinned(std::span<const float> both, std::size_t step) {
    std::vector<float> out(both.size() / 2 / step);
    for (std::size_t i = 0; i < out.size(); ++i) {
        float sum = 0.0F;
        for (std::size_t k = 2 * i * step; k < 2 * (i + 1) * step; ++k) sum += both[k];
        out[i] = sum;
    }
    return out;
}

double energy(std::span<const float> samples) {
    double sum = 0.0;
    for (const float s : samples) sum += static_cast<double>(s) * static_cast<double>(s);
    return sum;
}

// Returns the correlation of two signals from -1 to 1; 0 if one of them is silent.
double likeness(std::span<const float> a, std::span<const float> b) {
    double product = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) product += static_cast<double>(a[i]) * static_cast<double>(b[i]);
    const double both = energy(a) * energy(b);
    return both > 1e-12 ? product / std::sqrt(both) : 0.0;
}

// Searches for the beginning of `line` in `mix`, between the places `from` and `until`.
struct Found {
    std::size_t at = 0;
    double likeness = -1.0;
};
Found find_in(std::span<const float> mix, std::span<const float> line, std::size_t from, std::size_t until) {
    Found best;
    if (line.empty() || from + line.size() > mix.size()) return best;
    until = std::min(until, mix.size() - line.size());
    const double of_line = energy(line);
    double of_mix = energy(mix.subspan(from, line.size()));  // energy of the mix under the line
    for (std::size_t at = from; at < until; ++at) {
        // Adds up eight separate sums, because the compiler may not split one sum to vectorise it.
        std::array<float, 8> sums{};
        for (std::size_t i = 0; i + sums.size() <= line.size(); i += sums.size())
            for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += line[i + k] * mix[at + i + k];
        float product = 0.0F;
        for (const float sum : sums) product += sum;
        // If the mix is silent here, the correlation would be only rounding errors.
        const double here =
            of_mix > kSilence * of_line ? static_cast<double>(product) / std::sqrt(of_line * of_mix) : -1.0;
        if (here > best.likeness) best = {at, here};
        const auto first = static_cast<double>(mix[at]), next = static_cast<double>(mix[at + line.size()]);
        of_mix = std::max(0.0, of_mix + next * next - first * first);
    }
    return best;
}

std::size_t samples_in(double seconds, std::size_t step) {
    return static_cast<std::size_t>(seconds * kHz / static_cast<double>(step));
}

void compare(Transcribed& row, std::span<const float> mix, std::span<const float> line, std::size_t at) {
    const std::size_t piece = samples_in(kPiece_s, kFine);
    std::vector<double> energies;
    for (std::size_t i = 0; i + piece <= line.size(); i += piece) energies.push_back(energy(line.subspan(i, piece)));
    if (energies.empty()) return;
    const double least = *std::max_element(energies.begin(), energies.end()) * std::pow(10.0, 0.1 * kQuiet_db);
    int pieces = 0, heard = 0;
    bool last = false;
    for (std::size_t i = 0; i < energies.size(); ++i) {
        if (energies[i] < least || at + (i + 1) * piece > mix.size()) continue;
        last = likeness(line.subspan(i * piece, piece), mix.subspan(at + i * piece, piece)) >= kAlike;
        ++pieces;
        heard += last ? 1 : 0;
    }
    row.share = pieces > 0 ? static_cast<double>(heard) / pieces : 0.0;
    row.in_full = last && (row.share >= kShareInFull || pieces - heard <= 1);
}

}  // namespace

std::vector<Transcribed> transcribe(const Sounding& sounding) {
    const std::vector<float> coarse = thinned(sounding.mix(), kCoarse), fine = thinned(sounding.mix(), kFine);
    std::vector<Transcribed> rows;
    for (const PrintedLine& line : sounding.lines()) {
        Transcribed row{.text = line.utterance.text,
                        .speech_class = line.utterance.speech_class,
                        .topic = line.utterance.topic,
                        .voiced = line.voiced,
                        .stopped = line.stopped,
                        .printed_s = static_cast<double>(line.begin_frame) / kHz};
        if (line.voiced) {
            const std::vector<float> alone = Sounding::alone(line);
            const std::vector<float> roughly = thinned(alone, kCoarse), exactly = thinned(alone, kFine);
            const std::size_t beginning = std::min(roughly.size(), samples_in(kBeginning_s, kCoarse));
            const std::size_t from = line.begin_frame / kCoarse;
            const Found near =
                find_in(coarse, std::span(roughly).first(beginning), from, from + samples_in(kSearched_s, kCoarse));
            if (near.likeness >= kAlike) {
                const std::size_t about = near.at * kCoarse / kFine, margin = 2 * kCoarse / kFine;
                const std::size_t first = std::min(exactly.size(), samples_in(kBeginning_s, kFine));
                const Found found =
                    find_in(fine, std::span(exactly).first(first), about - std::min(about, margin), about + margin);
                row.heard_s = static_cast<double>(found.at * kFine) / kHz;
                compare(row, fine, exactly, found.at);
            }
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<Spoken> spoken(const std::vector<Transcribed>& lines) {
    std::vector<Spoken> heard;
    for (const Transcribed& line : lines) heard.push_back({line.printed_s, line.text, line.in_full, line.topic});
    return heard;
}

HeardBeacon heard_beacon(const Sounding& sounding) {
    constexpr double kBeat_s = 0.06, kLatency_s = 0.05;
    const std::vector<float> fine = thinned(sounding.mix(), kFine);
    SoundAlone alone;
    HeardBeacon all;
    for (const PlayedSound& sound : sounding.sounds()) {
        const std::size_t begin = sound.begin_frame, end = begin + samples_in(kBeat_s + kLatency_s, 1);
        if (!is_beacon(sound.cue.kind) || !sounding.voice_silent(begin, end)) continue;
        const std::vector<float> beat = thinned(alone.render(sound), kFine);
        const auto loud = std::find_if(beat.begin(), beat.end(), [](float s) { return std::abs(s) > 1e-4F; });
        const std::span<const float> from_start =
            std::span(beat).subspan(static_cast<std::size_t>(loud - beat.begin()));
        const Found found = find_in(fine, from_start.first(std::min(from_start.size(), samples_in(kBeat_s, kFine))),
                                    begin / kFine, begin / kFine + samples_in(kLatency_s, kFine));
        ++all.played;
        all.heard += found.likeness >= kAlike ? 1 : 0;
    }
    return all;
}

Judged judge(const std::vector<Transcribed>& lines) {
    Judged all;
    // For each topic: the latest important text, and whether the person heard it in full at least once.
    struct Run {
        std::string text;
        bool heard = false;
    };
    std::map<SpeechTopic, Run> runs;
    const auto end = [&](const Run& run) {
        if (run.text.empty()) return;
        ++all.matter;
        if (!run.heard) all.missing.push_back(run.text);
    };
    for (const Transcribed& line : lines) {
        if (!line.matters()) continue;
        Run& run = runs[line.topic];
        if (run.text != line.text) {
            // A line that begins with the text of the previous one replaces it: "Kitchen. You are there." replaces
            // "Kitchen".
            if (!line.text.starts_with(run.text)) end(run);
            run = {.text = line.text};
        }
        run.heard = run.heard || line.in_full;
    }
    for (const auto& [topic, run] : runs) end(run);
    return all;
}

std::string text_of(const std::vector<Transcribed>& lines) {
    std::string text;
    for (const Transcribed& line : lines)
        text += fmt::format("{:7.2f} s  {:>9}  {:3.0f} %  {} {}{}\n", line.printed_s,
                            line.heard_s ? fmt::format("{:7.2f} s", *line.heard_s) : "not heard", 100.0 * line.share,
                            line.matters() ? "*" : " ",
                            !line.voiced   ? "written: "
                            : line.stopped ? "cut by a key: "
                                           : "",
                            line.text);
    return text;
}

}  // namespace handrail::test
