// Gives a confined handrail-reader process the files that it needs. The process cannot open files, so it requests each
// one by name over a socket. The program opens the file if it belongs to the world, and passes the descriptor to the
// process. Private to this folder, except for tests.
#pragma once

#include <filesystem>
#include <string>

#include "worlds/readers/reader.h"

namespace handrail::importing {

// handrail-reader calls these two functions. They wait for the program's answer. `name` is relative to the world's
// file.
Result<OpenFile> request_world(int socket);
Result<OpenFile> request_next_to(int socket, const std::string& name);

// The program calls this function to answer one waiting request. Returns false if no more requests will come.
bool answer_request(int socket, const std::filesystem::path& world);

}  // namespace handrail::importing
