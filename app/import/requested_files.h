// The files that a confined reader needs. It may open none itself, so it requests each by name over a socket, and the
// program opens it there, if it belongs to the world, and passes the descriptor. Private to this folder, but for tests.
#pragma once

#include <filesystem>
#include <string>

#include "worlds/readers/reader.h"

namespace handrail {

// The reader's end, which waits for the program. The name is relative to the world's own.
Result<OpenFile> request_world(int socket);
Result<OpenFile> request_beside(int socket, const std::string& name);

// The program's end: answers one request that is waiting. False if no more will come.
bool answer_request(int socket, const std::filesystem::path& world);

}  // namespace handrail
