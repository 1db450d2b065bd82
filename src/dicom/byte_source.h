// Forward reading of a file, as it is or inflated.
#pragma once

#include <zlib.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>

namespace macula::dicom {

class ByteSource {
  public:
    explicit ByteSource(const std::filesystem::path& file);
    ~ByteSource();
    ByteSource(const ByteSource&) = delete;
    ByteSource& operator=(const ByteSource&) = delete;

    // False at the end: nothing is then to be read any more.
    bool read(std::span<unsigned char> bytes);
    bool peek(std::span<unsigned char> bytes);  // at most 64
    bool skip(std::uint64_t count);

    // From here on what the raw deflate stream (RFC 1951; PS3.5 A.5) holds. Positions go on from where it
    // begins.
    void beginInflating();
    bool inflating() const { return stream_ != nullptr; }

    std::uint64_t position() const { return position_; }
    std::uint64_t fileBytes() const { return fileBytes_; }

  private:
    bool refill();  // appends to what is buffered; false when there is no more
    std::size_t readFile(unsigned char* target, std::size_t count);

    std::ifstream file_;
    std::uint64_t fileBytes_ = 0;
    std::uint64_t position_ = 0;
    std::array<unsigned char, 16384> buffer_{};
    std::size_t begin_ = 0;
    std::size_t end_ = 0;

    std::array<unsigned char, 16384> compressed_{};
    std::unique_ptr<z_stream> stream_;
};

}  // namespace macula::dicom
