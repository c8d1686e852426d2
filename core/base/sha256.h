// SHA-256 of bytes: ties a result to the file it was computed from.
#pragma once

#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;

namespace straightedge {

/// 64 lower-case hex digits (FIPS 180-4). Any thread.
std::string sha256Hex(std::string_view bytes);

/// The same of bytes that come in pieces. One thread.
class Sha256 {
public:
  Sha256();
  void add(std::string_view bytes);
  std::string hex(); ///< of all that was added; nothing can be added any more

private:
  struct Free {
    void operator()(evp_md_ctx_st* context) const;
  };
  std::unique_ptr<evp_md_ctx_st, Free> m_context;
};

} // namespace straightedge
