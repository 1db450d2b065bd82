// Reads the numbers after the header of a PLY file, one by one.
#pragma once

#include <array>
#include <cstdint>
#include <istream>
#include <string_view>

#include "pipeline/splat/files/ply_header.h"

namespace macula::splat {

class PlyValues {
  public:
    // The stream is at the start of the data, of which there are `bytes` bytes, and must outlive this.
    PlyValues(std::istream& stream, PlyFormat format, std::uint64_t bytes)
        : stream_(*stream.rdbuf()), format_(format), left_(bytes) {}

    // Whether the remaining bytes suffice for all elements that the header announces.
    bool canHold(const PlyElement& element) const;

    // False at the end of the data, and for text that is not a number. Numbers of ascii files beyond the
    // range of double become infinite.
    bool next(PlyType type, double& value);
    bool skip(const PlyProperty& property);
    bool skip(const PlyElement& element);

  private:
    bool nextText(double& value);
    bool skipBytes(std::uint64_t count);

    std::streambuf& stream_;
    PlyFormat format_;
    std::uint64_t left_;
};

// Infinite for a value beyond the range of float32.
float toFloat(double value);

}  // namespace macula::splat
