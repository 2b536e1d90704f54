// Tests the user's cache folder, in which the program keeps its own results.
#include "worlds/cache/cache.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <ctime>
#include <functional>
#include <vector>

#include "tests/support/environment.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "worlds/cache/sha256.h"

namespace handrail {
namespace cache_test {

namespace fs = std::filesystem;
using test::TemporaryFolder;

// Returns the content of the entry `name`; empty if the entry is missing or its checks fail.
std::optional<std::string> taken(const Cache& cache, const std::string& name) {
    const Descriptor file = cache.open(name);
    return file.get() < 0 ? std::nullopt : kept_content(file.get(), name);
}

mode_t mode_of(const fs::path& path) {
    struct stat of {};
    EXPECT_EQ(::lstat(path.c_str(), &of), 0) << path;
    return of.st_mode & 07777;
}

void used_ago(const fs::path& file, int seconds) {
    const timespec then{::time(nullptr) - seconds, 0};
    const timespec times[2]{then, then};
    ASSERT_EQ(::utimensat(AT_FDCWD, file.c_str(), times, 0), 0);
}

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
    return names;
}

// Runs `work` in a separate process as a user other than root. Returns the exit status of that process.
int as_nobody(const std::function<bool()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) ::_exit(3);
        ::_exit(work() ? 0 : 1);
    }
    int status = -1;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// Test vectors of FIPS 180-2, appendix B.
TEST(Sha256, matches_the_standard_test_vectors) {
    EXPECT_EQ(sha256_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    Sha256 million;
    for (int i = 0; i < 1000; ++i) million.add(std::string(1000, 'a'));
    EXPECT_EQ(million.hex(), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, distinguishes_inputs_by_the_lengths_of_their_parts) {
    const auto of = [](std::string_view a, std::string_view b) {
        Sha256 sum;
        sum.add_counted(a);
        sum.add_counted(b);
        return sum.hex();
    };
    EXPECT_EQ(of("ab", "c"), of("ab", "c"));
    EXPECT_NE(of("ab", "c"), of("a", "bc"));
}

TEST(Cache, returns_what_it_stored_and_only_its_owner_can_read_it) {
    const TemporaryFolder home;
    const Cache cache(home.path() / "new" / ".cache" / "handrail");
    EXPECT_FALSE(taken(cache, "one"));
    const std::string content("with\0zero", 9);
    cache.keep("one", content);
    cache.keep("two", "");
    EXPECT_EQ(taken(cache, "one"), content);
    EXPECT_EQ(taken(cache, "two"), "");
    EXPECT_FALSE(taken(cache, "three"));
    EXPECT_EQ(mode_of(home.path() / "new/.cache/handrail"), 0700U);
    EXPECT_EQ(mode_of(home.path() / "new/.cache"), 0700U);
    EXPECT_EQ(mode_of(home.path() / "new/.cache/handrail/one"), 0600U);
    EXPECT_THAT(names_in(home.path() / "new/.cache/handrail"), testing::UnorderedElementsAre("one", "two"));
}

TEST(Cache, rejects_entries_that_are_changed_cut_or_renamed) {
    const TemporaryFolder folder;
    const fs::path in = folder.path() / "handrail";
    const Cache cache(in);
    cache.keep("one", "some content");
    cache.keep("two", "other content");
    const std::string whole = test::content_of(in / "one");
    const auto put = [&](const std::string& bytes) { std::ofstream(in / "one", std::ios::binary) << bytes; };
    for (std::size_t at = 0; at < whole.size(); ++at) {
        put(whole.substr(0, at));
        EXPECT_FALSE(taken(cache, "one")) << "cut at " << at;
        std::string other = whole;
        other[at] = static_cast<char>(other[at] ^ 0x10);
        put(other);
        EXPECT_FALSE(taken(cache, "one")) << "changed at " << at;
    }
    put(whole + "x");
    EXPECT_FALSE(taken(cache, "one"));
    put(test::content_of(in / "two"));
    EXPECT_FALSE(taken(cache, "one")) << "whole, but kept under another name";
    put(whole);
    EXPECT_EQ(taken(cache, "one"), "some content");
}

TEST(Cache, removes_the_least_recently_used_entry) {
    const TemporaryFolder folder;
    const fs::path in = folder.path() / "handrail";
    const Cache cache(in, 1000);  // limit of the whole cache in bytes; each entry below takes 264
    const std::string content(200, 'x');
    int ago = 300;
    for (const char* name : {"a", "b", "c"}) {
        cache.keep(name, content);
        used_ago(in / name, ago -= 10);
    }
    EXPECT_EQ(names_in(in).size(), 3U);
    EXPECT_TRUE(taken(cache, "a")) << "the oldest, and now the one used last";
    cache.keep("d", content);
    EXPECT_THAT(names_in(in), testing::UnorderedElementsAre("a", "c", "d"));
    cache.keep("e", std::string(700, 'x'));
    EXPECT_THAT(names_in(in), testing::UnorderedElementsAre("e"));
    cache.keep("f", std::string(1000, 'x'));
    EXPECT_THAT(names_in(in), testing::UnorderedElementsAre("e")) << "f is larger than all may be";
}

TEST(Cache, survives_deletion_of_its_folder_during_use) {
    const TemporaryFolder folder;
    const fs::path in = folder.path() / "handrail";
    const Cache cache(in);
    cache.keep("one", "content");
    const Descriptor open = cache.open("one");
    ASSERT_GE(open.get(), 0);
    fs::remove_all(in);
    EXPECT_EQ(kept_content(open.get(), "one"), "content") << "what is open stays";
    EXPECT_FALSE(taken(cache, "one"));
    cache.keep("one", "again");
    EXPECT_EQ(taken(cache, "one"), "again");
    EXPECT_EQ(mode_of(in), 0700U);
}

TEST(Cache, refuses_a_folder_that_others_can_write_to_and_makes_a_readable_one_private) {
    const TemporaryFolder folder;
    const fs::path in = folder.path() / "handrail";
    const Cache cache(in);
    cache.keep("one", "content");
    ASSERT_EQ(::chmod(in.c_str(), 0755), 0);
    EXPECT_EQ(taken(cache, "one"), "content");
    EXPECT_EQ(mode_of(in), 0700U);
    for (const mode_t others : {0770U, 0707U, 0777U}) {
        ASSERT_EQ(::chmod(in.c_str(), others), 0);
        EXPECT_FALSE(taken(cache, "one"));
        cache.keep("two", "content");
        EXPECT_FALSE(fs::exists(in / "two"));
        EXPECT_EQ(mode_of(in), others) << "left as it is";
    }
    ASSERT_EQ(::chmod(in.c_str(), 0700), 0);
    ASSERT_EQ(::chmod((in / "one").c_str(), 0622), 0);
    EXPECT_FALSE(taken(cache, "one")) << "others may have written it";
}

TEST(Cache, uses_nothing_that_another_user_owns) {
    if (::geteuid() != 0) GTEST_SKIP() << "only root can give files away";
    const TemporaryFolder folder;
    const fs::path in = folder.path() / "handrail";
    const Cache cache(in);
    cache.keep("one", "content");
    ASSERT_EQ(::chown((in / "one").c_str(), 65534, 65534), 0);
    EXPECT_FALSE(taken(cache, "one"));
    ASSERT_EQ(::chown((in / "one").c_str(), 0, 0), 0);
    ASSERT_EQ(::chown(in.c_str(), 65534, 65534), 0);
    EXPECT_FALSE(taken(cache, "one"));
    cache.keep("two", "content");
    EXPECT_FALSE(fs::exists(in / "two"));
}

TEST(Cache, follows_no_symbolic_link_and_opens_no_pipe) {
    const TemporaryFolder folder;
    const fs::path in = folder.path() / "handrail", diary = folder.write("diary", "mine");
    const Cache cache(in);
    cache.keep("one", "content");
    fs::rename(in / "one", folder.path() / "one");
    fs::create_symlink(folder.path() / "one", in / "one");
    EXPECT_FALSE(taken(cache, "one"));
    fs::remove(in / "one");
    fs::create_symlink(diary, in / "one");
    cache.keep("one", "content");
    EXPECT_EQ(test::content_of(diary), "mine");
    fs::remove(in / "one");
    ASSERT_EQ(::mkfifo((in / "one").c_str(), 0600), 0);
    EXPECT_FALSE(taken(cache, "one"));
    cache.keep("one", "content");
    EXPECT_TRUE(fs::is_fifo(in / "one"));
}

TEST(Cache, that_is_not_writable_stores_nothing_and_fails_nothing) {
    const TemporaryFolder folder;
    ASSERT_EQ(::chmod(folder.path().c_str(), 0555), 0);
    EXPECT_EQ(as_nobody([&] {
                  const Cache cache(folder.path() / ".cache" / "handrail");
                  cache.keep("one", "content");
                  return !taken(cache, "one");
              }),
              0);
    EXPECT_TRUE(fs::is_empty(folder.path()));
    const Cache nowhere({}), no_folder("/dev/null/handrail");
    for (const Cache* cache : {&nowhere, &no_folder}) {
        cache->keep("one", "content");
        EXPECT_FALSE(taken(*cache, "one"));
    }
    EXPECT_FALSE(nowhere);
}

// Two processes write and remove the same files at once. The limit of the cache leaves room for two files only. Neither
// process may ever read half a file.
TEST(Cache, serves_two_processes_at_once) {
    const TemporaryFolder folder;
    const fs::path in = folder.path() / "handrail";
    const auto work = [&](char mine) {
        const Cache cache(in, 250'000);
        for (int round = 0; round < 150; ++round) {
            const std::string name(1, static_cast<char>('a' + round % 4));
            if (const Descriptor file = cache.open(name); file.get() >= 0) {
                const std::optional<std::string> content = kept_content(file.get(), name);
                if (!content || content->size() != 100'000 ||
                    content->find_first_not_of(content->front()) != content->npos)
                    return false;
            }
            cache.keep(name, std::string(100'000, mine));
        }
        return true;
    };
    const pid_t other = ::fork();
    if (other == 0) ::_exit(work('y') ? 0 : 1);
    EXPECT_TRUE(work('x'));
    int status = -1;
    ASSERT_EQ(::waitpid(other, &status, 0), other);
    EXPECT_EQ(status, 0);
    std::uintmax_t all = 0;
    for (const fs::directory_entry& file : fs::directory_iterator(in)) all += file.file_size();
    EXPECT_LE(all, 250'000U);
    EXPECT_GT(all, 0U);
}

TEST(UserCacheFolder, follows_the_base_directory_specification) {
    test::WithEnvironment cache("XDG_CACHE_HOME", "/somewhere"), home("HOME", "/of/me");
    EXPECT_EQ(user_cache_folder(), "/somewhere/handrail");
    cache.put("relative");
    EXPECT_EQ(user_cache_folder(), "/of/me/.cache/handrail");
    cache.put(nullptr);
    EXPECT_EQ(user_cache_folder(), "/of/me/.cache/handrail");
    home.put("");
    EXPECT_EQ(user_cache_folder(), "");
    home.put(nullptr);
    EXPECT_EQ(user_cache_folder(), "");
}

}  // namespace cache_test
}  // namespace handrail
