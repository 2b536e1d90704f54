// Measures the cost of formatting a message in the person's language, and of starting to use a language. Run it by
// hand: build/release/bin/phrase_cost.
#include <benchmark/benchmark.h>

#include <toml++/toml.h>

#include "worlds/base/bundled_languages.h"
#include "worlds/base/language.h"

namespace handrail {
namespace {

void plain_text(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(phrase("learning.all_explored"));
}
BENCHMARK(plain_text);

void text_with_words(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(phrase("desk.going_to", {{"world", "house"}}));
}
BENCHMARK(text_with_words);

void text_with_numbers(benchmark::State& state) {
    std::int64_t percent = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(phrase("learning.share", {{"walls", ++percent % 100}, {"floor", 17}}));
}
BENCHMARK(text_with_numbers);

void text_with_plural(benchmark::State& state) {
    std::int64_t seconds = 0;
    for (auto _ : state) benchmark::DoNotOptimize(phrase("learning.seconds", {{"seconds", ++seconds % 60}}));
}
BENCHMARK(text_with_plural);

// Reads each bundled language, as the program does before its first message in that language.
void read_bundled(benchmark::State& state) {
    const BundledLanguage& source = kBundledLanguages[static_cast<std::size_t>(state.range(0))];
    const std::string content(source.content);
    state.SetLabel(std::string(source.code));
    for (auto _ : state) benchmark::DoNotOptimize(toml::parse(content));
}
BENCHMARK(read_bundled)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);

void language_of_the_environment(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(language_of_environment("/nonexistent"));
}
BENCHMARK(language_of_the_environment);

}  // namespace
}  // namespace handrail

BENCHMARK_MAIN();
