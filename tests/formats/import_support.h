// What the tests of volume files of other makers share.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "formats/volume_file.h"
#include "nifti_bytes.h"
#include "support.h"

namespace macula::formats::test {

using dicom::test::TemporaryFolder;

inline std::shared_ptr<const Volume> import(const std::filesystem::path& path) {
    Progress progress;
    auto volume = readVolumeFile(path, progress);
    if (!volume) {
        ADD_FAILURE() << path << ": " << volume.error().message;
        return nullptr;
    }
    return *volume;
}

inline std::string refusal(const std::filesystem::path& path) {
    Progress progress;
    const auto volume = readVolumeFile(path, progress);
    if (volume.ok()) return "accepted";
    EXPECT_EQ(volume.error().code, ErrorCode::inputNotUsable);
    EXPECT_FALSE(volume.error().hint.empty());
    EXPECT_EQ(volume.error().where, path.string());
    return volume.error().message.english();
}

// The bytes of a number in either order.
template <class T>
std::string bytesOf(T value, bool bigEndian = false) {
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof(T));
    if (bigEndian) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

inline bool anyContains(const std::vector<Text>& sentences, const std::string& words) {
    for (const Text& sentence : sentences) {
        if (sentence.english().find(words) != std::string::npos) return true;
    }
    return false;
}

class Import : public ::testing::Test {
  protected:
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        writeBytes(folder_ / name, bytes);
        return folder_ / name;
    }
    std::string refused(const std::string& name, const std::string& bytes) const {
        return refusal(write(name, bytes));
    }
    // What is said of a file after a change of its header.
    template <class Change>
    std::string refusedNifti(const Change& change) const {
        NiftiBytes file = makeNifti(4, 2);
        change(file);
        return refused("a.nii", file.bytes);
    }

    TemporaryFolder folder_;
};

#define EXPECT_SAYS(sentence, words) EXPECT_NE((sentence).find(words), std::string::npos) << (sentence)

template <class T>
void checkNiftiType(const std::filesystem::path& path, std::int16_t code, T low, T high, VoxelFormat format) {
    NiftiBytes file = makeNifti(code, sizeof(T));
    file.set(352, low);
    file.set(352 + sizeof(T), high);
    writeBytes(path, file.bytes);
    const auto volume = import(path);
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->format(), format) << code;
    EXPECT_EQ(volume->size(), glm::ivec3(3, 4, 5));
    EXPECT_EQ(volume->value(0, 0, 0), double(static_cast<float>(low))) << code;
    EXPECT_EQ(volume->value(1, 0, 0), double(static_cast<float>(high))) << code;
    EXPECT_EQ(volume->value(2, 3, 4), 0.0);
    EXPECT_EQ(volume->worldFromVoxel(), affine({-1, 0, 0}, {0, -2, 0}, {0, 0, 3}, {0, 0, 0}));
}

}  // namespace macula::formats::test
