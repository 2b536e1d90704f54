#include "app/import/requested_files.h"

#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "app/import/reader_answer.h"
#include "worlds/base/language.h"

namespace handrail::importing {
namespace {

constexpr std::size_t kLongestRequest_bytes = 4096, kLongestAnswer_bytes = 16'384;
// First byte of a request: kWorld requests the world itself, kNextTo a file next to the world, whose name follows.
constexpr char kWorld = 'w', kNextTo = 'b';

// The answer to a request. If `opened` is true, the descriptor of the file is sent with the answer.
struct FileAnswer {
    bool opened = false;
    std::uint64_t size = 0;
    std::string name;
    Error error;
};
template <class A, stored::Is<FileAnswer> T>
void fields(A& a, T& v) {
    auto& [opened, size, name, error] = v;
    a(opened);
    const std::uint64_t packed = stored::archive::count(a, size);
    if constexpr (A::kReads) size = packed;
    a(name, error);
}

// A socket message that can carry one descriptor.
struct Parcel {
    explicit Parcel(std::string& bytes) : part{bytes.data(), bytes.size()} {
        head.msg_iov = &part;
        head.msg_iovlen = 1;
    }
    Parcel(const Parcel&) = delete;
    Parcel& operator=(const Parcel&) = delete;

    void make_room() {
        head.msg_control = room.data();
        head.msg_controllen = room.size();
    }
    void put(int fd) {
        make_room();
        cmsghdr* const note = CMSG_FIRSTHDR(&head);
        note->cmsg_level = SOL_SOCKET;
        note->cmsg_type = SCM_RIGHTS;
        note->cmsg_len = CMSG_LEN(sizeof fd);
        std::memcpy(CMSG_DATA(note), &fd, sizeof fd);
    }
    Descriptor taken() {
        int fd = -1;
        const cmsghdr* const note = CMSG_FIRSTHDR(&head);
        if (note && note->cmsg_level == SOL_SOCKET && note->cmsg_type == SCM_RIGHTS &&
            note->cmsg_len == CMSG_LEN(sizeof fd))
            std::memcpy(&fd, CMSG_DATA(note), sizeof fd);
        return Descriptor(fd);
    }

    iovec part;
    msghdr head{};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> room{};
};

Result<OpenFile> request(int socket, const std::string& message) {
    const auto problem = [&](int error) {
        return fail(phrase("files.cannot_open", {{"reason", reason_of(error)}}), message.substr(1));
    };
    if (message.size() > kLongestRequest_bytes) return problem(ENAMETOOLONG);
    if (::send(socket, message.data(), message.size(), MSG_NOSIGNAL) < 0) return problem(errno);
    std::string bytes(kLongestAnswer_bytes, '\0');
    Parcel parcel(bytes);
    parcel.make_room();
    ssize_t got = -1;
    while ((got = ::recvmsg(socket, &parcel.head, MSG_CMSG_CLOEXEC)) < 0 && errno == EINTR) {
    }
    if (got <= 0) return problem(got < 0 ? errno : EIO);
    Descriptor file = parcel.taken();
    FileAnswer answer;
    stored::Unpacker unpack(std::string_view(bytes).substr(0, static_cast<std::size_t>(got)));
    unpack(answer);
    if (!unpack.good() || answer.opened != (file.get() >= 0)) return problem(EIO);
    if (!answer.opened) return tl::unexpected(answer.error);
    return OpenFile{std::move(file), static_cast<std::size_t>(answer.size), answer.name};
}

Result<OpenFile> requested(std::string_view message, const std::filesystem::path& world) {
    if (message.front() == kWorld) return open_file(world);
    return readers::open_file_next_to(world, std::string(message.substr(1)));
}

}  // namespace

Result<OpenFile> request_world(int socket) { return request(socket, {kWorld}); }

Result<OpenFile> request_next_to(int socket, const std::string& name) { return request(socket, kNextTo + name); }

bool answer_request(int socket, const std::filesystem::path& world) {
    std::array<char, kLongestRequest_bytes> message;
    const ssize_t got = ::recv(socket, message.data(), message.size(), MSG_DONTWAIT);
    if (got < 0) return errno == EINTR || errno == EAGAIN;
    if (got == 0) return false;
    const Result<OpenFile> file = requested({message.data(), static_cast<std::size_t>(got)}, world);
    FileAnswer answer;
    answer.opened = file.has_value();
    if (file) {
        answer.size = file->size;
        answer.name = file->name;
    } else {
        answer.error = file.error();
    }
    stored::Packer pack;
    pack(answer);
    std::string bytes = pack.take();
    Parcel parcel(bytes);
    if (file) parcel.put(file->file.get());
    // This call does not wait. If a reader fills the socket with requests and reads no answers, sending fails, and the
    // reader gets no more answers.
    return ::sendmsg(socket, &parcel.head, MSG_DONTWAIT | MSG_NOSIGNAL) >= 0;
}

}  // namespace handrail::importing
