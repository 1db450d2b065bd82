// NIfTI-1 read and made byte by byte, by the format's definition alone: what the code under test is compared
// with.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/frames.h"

namespace macula::formats::test {

struct NiftiBytes {
    std::string bytes;  // the whole file, unpacked

    template <class T>
    T get(std::size_t offset) const {
        T value{};
        if (offset + sizeof(T) <= bytes.size())
            bytes.copy(reinterpret_cast<char*>(&value), sizeof(T), offset);
        return value;
    }
    template <class T>
    void set(std::size_t offset, T value) {
        bytes.replace(offset, sizeof(T), reinterpret_cast<const char*>(&value), sizeof(T));
    }

    glm::ivec3 size() const;
    std::int16_t datatype() const { return get<std::int16_t>(70); }
    std::int16_t qformCode() const { return get<std::int16_t>(252); }
    std::int16_t sformCode() const { return get<std::int16_t>(254); }
    // To patient LPS mm; the file has RAS.
    glm::dmat4 sform() const;
    glm::dmat4 qform() const;
    double value(int i, int j, int k) const;  // with slope and intercept
};

NiftiBytes readNiftiBytes(const std::filesystem::path& path);  // unpacks .gz
void writeBytes(const std::filesystem::path& path, const std::string& bytes);
std::string gzipped(const std::string& bytes);

// A little-endian file of 3 x 4 x 5 voxels of that type, all 0, with an axial sform of 1 x 2 x 3 mm.
NiftiBytes makeNifti(std::int16_t datatype, int bytesPerVoxel);

}  // namespace macula::formats::test
