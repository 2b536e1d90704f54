// Tests every parser with the inputs that once failed, and with mutations of its seeds. The mutations are deterministic
// and the same on every machine. The endless version is tests/fuzz/libfuzzer (clang).
#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "tests/fuzz/harness.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"

namespace handrail::fuzz {
namespace mutation_fuzz_test {

namespace fs = std::filesystem;

fs::path folder_of(const Harness& harness) { return test::project_root() / "tests/fuzz/inputs" / harness.name; }

struct Input {
    fs::path file;
    std::string bytes;
};
std::vector<Input> inputs_in(const fs::path& folder) {
    std::vector<Input> inputs;
    std::error_code ec;
    for (const auto& entry : fs::directory_iterator(folder, ec))
        inputs.push_back({entry.path(), test::content_of(entry.path())});
    std::sort(inputs.begin(), inputs.end(), [](const Input& a, const Input& b) { return a.file < b.file; });
    return inputs;
}

// Returns the quoted strings of a dictionary in libFuzzer's format, in which \xAB stands for a byte.
std::vector<std::string> words_of(const fs::path& dictionary) {
    std::vector<std::string> words;
    std::ifstream file(dictionary);
    for (std::string line; std::getline(file, line);) {
        if (line.size() < 2 || line.front() != '"') continue;
        std::string word;
        for (std::size_t i = 1; i + 1 < line.size(); ++i) {
            if (line[i] == '\\') {
                word += static_cast<char>(std::stoi(line.substr(i + 2, 2), nullptr, 16));
                i += 3;
            } else {
                word += line[i];
            }
        }
        words.push_back(word);
    }
    return words;
}

std::string mutated(const std::string& seed_text, const std::vector<std::string>& words, std::mt19937& random) {
    std::string text = seed_text;
    for (std::uint32_t edits = 1 + random() % 6; edits > 0 && !text.empty(); --edits) {
        const std::size_t at = random() % text.size(), length = std::min<std::size_t>(random() % 40, text.size() - at);
        switch (random() % 6) {
            case 0:
                text[at] = static_cast<char>(random());
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(at, text.substr(random() % text.size(), length));
                break;
            case 3:
                text.insert(at, words[random() % words.size()]);
                break;
            case 4:
                text.resize(at);
                break;
            default:
                std::swap(text[at], text[random() % text.size()]);
        }
    }
    return text;
}

class Parser : public testing::TestWithParam<Harness> {};

TEST_P(Parser, accepts_its_seed_inputs_and_earlier_failures) {
    const std::vector<Input> seeds = inputs_in(folder_of(GetParam()) / "seeds");
    EXPECT_FALSE(seeds.empty());
    for (const auto& inputs : {seeds, inputs_in(folder_of(GetParam()) / "regressions")})
        for (const Input& input : inputs) EXPECT_EQ(GetParam().fault(input.bytes), "") << input.file.string();
}

TEST_P(Parser, accepts_mutated_seed_inputs_or_reports_an_error) {
    const std::vector<Input> seeds = inputs_in(folder_of(GetParam()) / "seeds");
    const std::vector<std::string> words = words_of(folder_of(GetParam()) / "words.dict");
    ASSERT_FALSE(seeds.empty() || words.empty());
    for (int round = 0; round < test::scaled(GetParam().rounds); ++round) {
        std::mt19937 random(static_cast<unsigned>(round));
        const std::string bytes = mutated(seeds[static_cast<std::size_t>(round) % seeds.size()].bytes, words, random);
        const std::string fault = GetParam().fault(bytes);
        ASSERT_EQ(fault, "") << "round " << round << ":\n" << bytes;
    }
}

INSTANTIATE_TEST_SUITE_P(Every, Parser, testing::ValuesIn(harnesses().begin(), harnesses().end()),
                         [](const testing::TestParamInfo<Harness>& row) { return std::string(row.param.name); });

// Without this check, a folder of inputs that has no row would never be used.
TEST(Harnesses, cover_every_folder_of_fuzz_inputs) {
    for (const auto& entry : fs::directory_iterator(test::project_root() / "tests/fuzz/inputs")) {
        const std::string name = entry.path().filename().string();
        EXPECT_TRUE(std::any_of(harnesses().begin(), harnesses().end(), [&](const Harness& harness) {
            return harness.name == name;
        })) << name;
    }
}

}  // namespace mutation_fuzz_test
}  // namespace handrail::fuzz
