#include "core/base/sha256.h"

#include <openssl/evp.h>

#include <array>
#include <cassert>
#include <cstddef>

namespace straightedge {

std::string sha256Hex(std::string_view bytes) {
  // Fetched once: OpenSSL 3 looks the algorithm up under a lock on every implicit fetch.
  static const EVP_MD* const algorithm = EVP_MD_fetch(nullptr, "SHA256", nullptr);
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  [[maybe_unused]] const int done = EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, algorithm, nullptr);
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
