// Defines the protocol between read_apart and handrail-reader, the process that it starts. Private to this folder.
#pragma once

#include "app/import/reader_process.h"
#include "settings/toml_value.h"
#include "worlds/stored/archive.h"
#include "worlds/stored/stored_scene.h"

// These functions pack types that belong neither to the archive (worlds/stored) nor to this folder. They are in the
// archive's namespace, because the archive finds them there by argument-dependent lookup.
namespace handrail::stored {

template <class A, Is<Error> T>
void fields(A& a, T& v) {
    auto& [file, line, column, message] = v;
    a(file, line, column, message);
}
template <class A, Is<settings::TomlMoment> T>
void fields(A& a, T& v) {
    auto& [has_date, has_time, has_offset, year, month, day, hour, minute, second, nanosecond, offset_minutes] = v;
    a(has_date, has_time, has_offset, year, month, day, hour, minute, second, nanosecond, offset_minutes);
}
template <class A, Is<settings::TomlMember> T>
void fields(A& a, T& v) {
    auto& [key, value] = v;
    a(key, value);
}
template <class A, Is<settings::TomlValue> T>
void fields(A& a, T& v) {
    auto& [value, line, column, in_line] = v;
    if constexpr (A::kReads)
        if (!a.descend(settings::kDeepestToml)) return;
    a(value.plain(), line, column, in_line);
    if constexpr (A::kReads) a.ascend();
}

}  // namespace handrail::stored

namespace handrail::importing {

inline constexpr int kAnswerFd = 3, kProgressFd = 4, kFilesFd = 5, kKeptFd = 6;
inline constexpr int kReaderWords = 12;  // number of arguments, including the program's name
inline constexpr int kWrongUse = 2, kNoMemory = 3, kNoRoom = 4, kCutMeanwhile = 5;
// The program passes this word instead of the names of a world and of a cached file. It means that the text at the
// descriptor kKeptFd is TOML. No cached file has this name.
inline constexpr const char* kTomlText = "toml";
inline constexpr std::size_t kMostHandedOver_bytes = std::size_t{1} << 30;

// The first part of an answer. If `read` is true, the bytes of the scene or of the routes follow.
struct ReaderAnswer {
    bool read = false, kept = false, kept_damaged = false;
    Error error;
    std::vector<NeighbourFile> beside;
};

template <class A, stored::Is<NeighbourFile> T>
void fields(A& a, T& v) {
    auto& [name, sha256] = v;
    a(name, sha256);
}
template <class A, stored::Is<ReaderAnswer> T>
void fields(A& a, T& v) {
    auto& [read, kept, kept_damaged, error, beside] = v;
    a(read, kept, kept_damaged, error, beside);
}

// Follows the ReaderAnswer if the request was kTomlText. If `fault` has a line number, there are no values.
struct TomlAnswer {
    Error fault;
    settings::TomlValue values;
};

template <class A, stored::Is<TomlAnswer> T>
void fields(A& a, T& v) {
    auto& [fault, values] = v;
    a(fault, values);
}

}  // namespace handrail::importing
