// Gives a confined reader the files that it needs. It cannot open files, so it requests each by name over a socket. The
// program opens the file if it belongs to the world, and passes the descriptor. Private to this folder, except for
// tests.
#pragma once

#include <filesystem>
#include <string>

#include "worlds/readers/reader.h"

namespace handrail::importing {

// Called by the reader; waits for the program. The name is relative to the world's file.
Result<OpenFile> request_world(int socket);
Result<OpenFile> request_beside(int socket, const std::string& name);

// Called by the program: answers one waiting request. Returns false if no more will come.
bool answer_request(int socket, const std::filesystem::path& world);

}  // namespace handrail::importing
