// The numbers behind the header of a PLY file, one after another.
#pragma once

#include <array>
#include <cstdint>
#include <istream>
#include <string_view>

#include "pipeline/splat/files/ply_header.h"

namespace macula::splat {

class PlyValues {
  public:
    // The stream stands at the data, of which there are `bytes`. It must outlive this.
    PlyValues(std::istream& stream, PlyFormat format, std::uint64_t bytes)
        : stream_(*stream.rdbuf()), format_(format), left_(bytes) {}

    // Whether the bytes that are left suffice for all elements that the header announces.
    bool canHold(const PlyElement& element) const;

    // False at the end of the data, and for what is no number. Numbers of ascii files that are larger than
    // any double are infinite.
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

// Infinite where a float32 has no such number.
float toFloat(double value);

}  // namespace macula::splat
