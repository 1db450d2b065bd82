// gzip (RFC 1952) in memory, with the comment of its header, by zlib.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"

namespace macula::splat {

// deflate shrinks data by a factor of at most 1032 (RFC 1951: 258 bytes in 2 bits).
inline constexpr std::uint64_t kMostDeflated = 1032;

// Packs `data`, below 4 GiB. The comment is Latin-1, without zeros. Writes no time and no name, so that the
// same data give the same bytes. Fails with outOfMemory.
Result<std::vector<std::byte>> gzip(std::span<const std::byte> data, const std::string& comment);

// Unpacks step by step, so that the caller decides how much may come out.
class Gunzip {
  public:
    // The bytes, below 4 GiB, must outlive this.
    explicit Gunzip(std::span<const std::byte> packed);
    ~Gunzip();
    Gunzip(const Gunzip&) = delete;
    Gunzip& operator=(const Gunzip&) = delete;

    // Fills `out`; false when the data end before that or are damaged.
    bool read(std::span<std::byte> out);

    // The remaining bytes, if there are at most `most` and the stream ends with the right checksum; else
    // nothing.
    std::optional<std::vector<std::byte>> rest(std::size_t most);

    // The comment of the header; available after the first read. At most 4 KiB of it.
    std::string headerComment() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace macula::splat
