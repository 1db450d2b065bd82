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

// deflate packs at most 1 : 1032 (RFC 1951: 258 bytes in 2 bits).
inline constexpr std::uint64_t kMostDeflated = 1032;

// The comment is Latin-1, without zeros. No time and no name is written: the same data give the same bytes.
// Fails with outOfMemory. `data` is below 4 GiB.
Result<std::vector<std::byte>> gzip(std::span<const std::byte> data, const std::string& comment);

// Unpacks by and by, so that the caller decides how much may come out.
class Gunzip {
  public:
    // The bytes, below 4 GiB, must outlive this.
    explicit Gunzip(std::span<const std::byte> packed);
    ~Gunzip();
    Gunzip(const Gunzip&) = delete;
    Gunzip& operator=(const Gunzip&) = delete;

    // Exactly so many bytes; false when there are fewer or they are damaged.
    bool read(std::span<std::byte> out);

    // What is left, when it is no more than `most` bytes and ends well: its checksum agrees. Else nothing.
    std::optional<std::vector<std::byte>> rest(std::size_t most);

    // The comment of the header, once something was read. Longer ones than 4 KiB are cut off.
    std::string headerComment() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace macula::splat
