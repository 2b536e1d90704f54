#include "worlds/cache/sha256.h"

#include <fmt/format.h>
#include <gcrypt.h>

#include <cstdint>
#include <new>

#include "worlds/base/contract.h"

namespace handrail::cache {
namespace {

// Initialises libgcrypt unless another library of the program has done so. Handrail computes only digests with it, so
// no memory has to be locked.
void make_ready_once() {
    static const bool ready = [] {
        if (gcry_control(GCRYCTL_INITIALIZATION_FINISHED_P)) return true;
        (void)gcry_check_version(nullptr);
        gcry_control(GCRYCTL_DISABLE_SECMEM, 0);
        gcry_control(GCRYCTL_INITIALIZATION_FINISHED, 0);
        return true;
    }();
    (void)ready;
}

}  // namespace

struct Sha256::State {
    gcry_md_hd_t handle = nullptr;
    ~State() { gcry_md_close(handle); }
};

Sha256::Sha256() : state_(std::make_unique<State>()) {
    make_ready_once();
    const gcry_error_t error = gcry_md_open(&state_->handle, GCRY_MD_SHA256, 0);
    if (gcry_err_code(error) == GPG_ERR_ENOMEM) throw std::bad_alloc();
    contract_pre(!error);  // cannot fail, because every build of libgcrypt supports SHA-256
}

Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) { gcry_md_write(state_->handle, bytes.data(), bytes.size()); }

void Sha256::add_counted(std::string_view bytes) {
    add(fmt::format("{}\n", bytes.size()));
    add(bytes);
}

std::string Sha256::hex() {
    const std::uint8_t* const sum = gcry_md_read(state_->handle, GCRY_MD_SHA256);
    std::string text;
    for (unsigned i = 0; i < gcry_md_get_algo_dlen(GCRY_MD_SHA256); ++i) text += fmt::format("{:02x}", sum[i]);
    return text;
}

std::string sha256_of(std::string_view bytes) {
    Sha256 sum;
    sum.add(bytes);
    return sum.hex();
}

}  // namespace handrail::cache
