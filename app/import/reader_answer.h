// What read_apart and the process it starts agree on. Private to this folder.
#pragma once

#include "app/import/reader_process.h"
#include "worlds/stored/archive.h"
#include "worlds/stored/stored_scene.h"

namespace handrail {

inline constexpr int kAnswerFd = 3, kTellFd = 4;
inline constexpr int kReaderWords = 11;  // with the program's own name
inline constexpr int kWrongUse = 2, kNoMemory = 3, kNoRoom = 4, kCutMeanwhile = 5;
inline constexpr std::size_t kMostHandedOver_bytes = std::size_t{1} << 30;

// Before the bytes of the scene, which follow where it was read.
struct ReaderAnswer {
    bool read = false;
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
    auto& [name, sum] = v;
    a(name, sum);
}
template <class A, Is<ReaderAnswer> T>
void fields(A& a, T& v) {
    auto& [read, error, beside] = v;
    a(read, error, beside);
}

}  // namespace handrail
