// Reads a file forwards, as it is or inflated.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "base/progress.h"

namespace macula::dicom {

// Opens the file once, and reads it in few, large steps, because each of them waits on a network drive. Not
// copyable. May throw std::bad_alloc.
//
// Once `cancel` is cancelled, inflating ends as at the end of the file: a few bytes can inflate for seconds.
class ByteSource {
  public:
    explicit ByteSource(const std::filesystem::path& file, CancelToken cancel = {});
    ~ByteSource();
    ByteSource(const ByteSource&) = delete;
    ByteSource& operator=(const ByteSource&) = delete;

    // The errno of opening or reading the file when that failed, otherwise 0.
    int error() const { return error_; }

    // False at the end: the caller then reads no further.
    bool read(std::span<unsigned char> bytes);
    bool peek(std::span<unsigned char> bytes);
    bool skip(std::uint64_t count);
    // Up to `count` of the next bytes, fewer at the end, without moving on. Valid until the next call.
    std::span<const unsigned char> ahead(std::size_t count);

    // From here on inflates the raw deflate stream (RFC 1951; PS3.5 A.5). Positions continue from where the
    // stream begins.
    void beginInflating();
    bool inflating() const { return stream_ != nullptr; }

    std::uint64_t position() const { return position_; }
    std::uint64_t fileBytes() const { return fileBytes_; }
    // Bytes left in the file, as they are stored: not inflated.
    std::uint64_t bytesLeft() const { return position_ < fileBytes_ ? fileBytes_ - position_ : 0; }

  private:
    bool refill(std::size_t wanted);  // appends to the buffer; false at the end
    std::size_t readFile(unsigned char* target, std::size_t count);

    CancelToken cancel_;
    int descriptor_ = -1;
    int error_ = 0;
    std::uint64_t fileBytes_ = 0;
    std::uint64_t position_ = 0;    // position of the next byte to return
    std::uint64_t readOffset_ = 0;  // where the next read from the file begins
    std::size_t step_;              // bytes to read next
    std::vector<unsigned char> buffer_;
    std::size_t begin_ = 0;
    std::size_t end_ = 0;

    std::vector<unsigned char> compressed_;
    std::unique_ptr<z_stream> stream_;
};

}  // namespace macula::dicom
