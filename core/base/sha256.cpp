#include "core/base/sha256.h"

#include <openssl/evp.h>

#include <array>
#include <cassert>
#include <cstddef>

namespace straightedge {

std::string sha256Hex(std::string_view bytes) {
  Sha256 sum;
  sum.add(bytes);
  return sum.hex();
}

void Sha256::Free::operator()(evp_md_ctx_st* context) const { EVP_MD_CTX_free(context); }

Sha256::Sha256() : m_context(EVP_MD_CTX_new()) {
  // Fetched once: OpenSSL 3 looks the algorithm up under a lock on every implicit fetch.
  static const EVP_MD* const algorithm = EVP_MD_fetch(nullptr, "SHA256", nullptr);
  [[maybe_unused]] const int done = EVP_DigestInit_ex2(m_context.get(), algorithm, nullptr);
  assert(done == 1);
}

void Sha256::add(std::string_view bytes) {
  [[maybe_unused]] const int done = EVP_DigestUpdate(m_context.get(), bytes.data(), bytes.size());
  assert(done == 1);
}

std::string Sha256::hex() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  [[maybe_unused]] const int done = EVP_DigestFinal_ex(m_context.get(), digest.data(), &length);
  assert(done == 1 && length == 32);
  constexpr std::string_view digits = "0123456789abcdef";
  std::string hex;
  hex.reserve(2 * std::size_t{length});
  for (std::size_t i = 0; i < length; ++i) {
    hex += digits[digest[i] >> 4U];
    hex += digits[digest[i] & 15U];
  }
  return hex;
}

} // namespace straightedge
