// The file in which a world is kept that took long to read: what it was made of, then the Scene as bytes. Private to
// this folder, but for tests.
#pragma once

#include <functional>
#include <optional>

#include "app/import/reader_process.h"

namespace handrail {

// What a kept Scene was made of. Another one means: read anew.
struct KeptFrom {
    std::uint64_t version = 0;  // of the readers
    std::uint64_t size = 0;     // of the file, bytes
    std::uint32_t checksum = 0;
    std::string said;  // options, language and whatever else changes what is read
    std::vector<BesideFile> beside;
    bool operator==(const KeptFrom&) const = default;
};

struct KeptScene {
    KeptFrom from;
    Scene scene;
};

std::string kept_file(const KeptFrom& from, std::string_view scene);
// `still_good` is asked before the Scene is unpacked; nothing where it says no. Fails for bytes that are damaged.
Result<std::optional<Scene>> scene_in(std::string_view file, const std::function<bool(const KeptFrom&)>& still_good);

}  // namespace handrail
