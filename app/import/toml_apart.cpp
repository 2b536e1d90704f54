#include "app/import/toml_apart.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <deque>
#include <mutex>

#include "app/import/reader_answer.h"
#include "worlds/base/descriptor.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/cache/sha256.h"

namespace handrail::importing {
namespace {

constexpr std::size_t kLongestFault_bytes = 300;
// Bytes of an answer for each byte of the text, and the limit for the shortest texts. A TOML value needs at most 27
// bytes in an answer, and at least 2 in a text.
constexpr std::size_t kAnswerPerText = 16, kShortestAnswer_bytes = 4096;

bool is_sound(const settings::TomlMoment& moment) {
    using std::chrono::day, std::chrono::month, std::chrono::year;
    settings::TomlMoment stated;  // a copy in which the fields that the moment does not state are 0, as they must be
    if (moment.has_date) stated.year = moment.year, stated.month = moment.month, stated.day = moment.day;
    if (moment.has_time) {
        stated.hour = moment.hour, stated.minute = moment.minute, stated.second = moment.second;
        stated.nanosecond = moment.nanosecond;
    }
    if (moment.has_offset) stated.offset_minutes = moment.offset_minutes;
    stated.has_date = moment.has_date, stated.has_time = moment.has_time, stated.has_offset = moment.has_offset;
    if (moment != stated) return false;
    const bool is_day = (year(moment.year) / month(moment.month) / day(moment.day)).ok() && moment.year <= 9999;
    return (moment.has_date || moment.has_time) && (!moment.has_date || is_day) &&
           (!moment.has_offset || (moment.has_date && moment.has_time)) && moment.hour <= 23 && moment.minute <= 59 &&
           moment.second <= 59 && moment.nanosecond <= 999'999'999 && std::abs(moment.offset_minutes) < 24 * 60;
}

// Returns true if toml_of could have made this value.
bool is_sound(const settings::TomlValue& value) {
    if (value.line < 0 || value.column < 0) return false;
    if (const std::string* text = value.text()) return is_utf8(*text);
    if (const auto* moment = std::get_if<settings::TomlMoment>(&value.value)) return is_sound(*moment);
    if (const settings::TomlValue::Array* list = value.array())
        return std::all_of(list->begin(), list->end(), [](const settings::TomlValue& one) { return is_sound(one); });
    if (const settings::TomlValue::Table* table = value.table()) {
        const auto in_order = [](const settings::TomlMember& a, const settings::TomlMember& b) {
            return !(a.key < b.key);
        };
        return std::adjacent_find(table->begin(), table->end(), in_order) == table->end() &&
               std::all_of(table->begin(), table->end(),
                           [](const settings::TomlMember& one) { return is_utf8(one.key) && is_sound(one.value); });
    }
    return true;
}

Result<settings::TomlValue> failed() { return fail(phrase("import.toml_failed")); }

bool put(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t got = ::write(file, bytes.data(), bytes.size());
        if (got <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(got));
    }
    return ::lseek(file, 0, SEEK_SET) == 0;
}

Result<settings::TomlValue> parsed_apart(const std::string& text, const std::filesystem::path& program,
                                         ReaderLimits limits) {
    if (text.size() > kLargestToml_bytes)
        return fail(phrase("files.too_large", {{"megabytes", kLargestToml_bytes >> 20}}));
    const Descriptor file(::memfd_create("handrail-toml", MFD_CLOEXEC));
    if (file.get() < 0 || !put(file.get(), text)) return failed();
    limits.answer_bytes = kAnswerPerText * text.size() + kShortestAnswer_bytes;
    const Result<ReadApart> read = read_apart({}, {}, program, limits, {file.get(), kTomlText});
    return read ? toml_in_answer(read->scene) : failed();
}

}  // namespace

Result<settings::TomlValue> toml_in_answer(std::string_view bytes) {
    stored::Unpacker unpack(bytes);
    TomlAnswer answer;
    unpack(answer);
    if (!unpack.good() || !unpack.rest().empty()) return failed();
    if (answer.fault.line > 0)
        return fail(one_line(answer.fault.message.substr(0, kLongestFault_bytes)), {}, answer.fault.line,
                    std::max(0, answer.fault.column));
    if (!answer.values.table() || answer.values.in_line || !is_sound(answer.values)) return failed();
    return std::move(answer.values);
}

struct TomlApart::Known {
    struct One {
        std::string sha256;
        std::size_t bytes;
        Result<settings::TomlValue> result;
    };

    std::optional<Result<settings::TomlValue>> find(const std::string& sha256) {
        const std::lock_guard lock(mutex);
        for (const One& one : all)
            if (one.sha256 == sha256) return one.result;
        return std::nullopt;
    }
    void keep(One one) {
        const std::lock_guard lock(mutex);
        bytes += one.bytes;
        all.push_back(std::move(one));
        while (all.size() > 1 && (all.size() > kMostKnown || bytes > kMostKnown_bytes)) {
            bytes -= all.front().bytes;
            all.pop_front();
        }
    }

    std::mutex mutex;
    std::deque<One> all;  // cached texts with their results; the oldest is the first
    std::size_t bytes = 0;
};

TomlApart::TomlApart(std::filesystem::path program, ReaderLimits limits)
    : program_(std::move(program)), limits_(limits), known_(std::make_shared<Known>()) {}

Result<settings::TomlValue> TomlApart::operator()(const std::string& text) const {
    const std::string sha256 = cache::sha256_of(text);
    if (auto known = known_->find(sha256)) return std::move(*known);
    Result<settings::TomlValue> result = parsed_apart(text, program_, limits_);
    known_->keep({sha256, text.size(), result});
    return result;
}

}  // namespace handrail::importing
