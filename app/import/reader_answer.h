// What read_apart and the process it starts agree on. Private to this folder.
#pragma once

#include "app/import/reader_process.h"
#include "worlds/stored/archive.h"
#include "worlds/stored/stored_scene.h"

namespace handrail {

inline constexpr int kAnswerFd = 3, kTellFd = 4, kFilesFd = 5, kKeptFd = 6;
inline constexpr int kReaderWords = 12;  // with the program's own name
inline constexpr int kWrongUse = 2, kNoMemory = 3, kNoRoom = 4, kCutMeanwhile = 5;
inline constexpr std::size_t kMostHandedOver_bytes = std::size_t{1} << 30;

// Before the bytes of the scene or of the ways, which follow if `read`.
struct ReaderAnswer {
    bool read = false, kept = false, kept_damaged = false;
    Error error;
    std::vector<BesideFile> beside;
};

template <class A, Is<Error> T>
void fields(A& a, T& v) {
    auto& [file, line, column, message] = v;
    a(file, line, column, message);
}
template <class A, Is<BesideFile> T>
void fields(A& a, T& v) {
    auto& [name, sha256] = v;
    a(name, sha256);
}
template <class A, Is<ReaderAnswer> T>
void fields(A& a, T& v) {
    auto& [read, kept, kept_damaged, error, beside] = v;
    a(read, kept, kept_damaged, error, beside);
}

}  // namespace handrail
