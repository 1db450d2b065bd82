// Pictures that are kept come back bit for bit, or not at all.
#include "pipeline/hybrid/views/picture_cache.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cstring>
#include <fstream>
#include <limits>

#include "base/atomic_file.h"
#include "base/sha256.h"

namespace macula::hybrid {
namespace {

namespace fs = std::filesystem;

class Cache : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / fmt::format("macula-cache-{}", getpid());
        fs::remove_all(folder_);
        ASSERT_TRUE(cache().prepare().ok());
    }
    void TearDown() override { fs::remove_all(folder_); }

    PictureCache cache() const { return PictureCache(folder_); }
    fs::path file(const std::string& key) const { return folder_ / (key + ".rgba"); }

    fs::path folder_;
};

const std::string kKey = sha256Hex("a picture");

KeptPicture picture(float first = 0.25f) {
    KeptPicture kept{.sizePx = {5, 3}, .rgba = std::vector<glm::vec4>(15)};
    kept.rgba[0].x = first;
    for (std::size_t i = 1; i < 15; ++i) kept.rgba[i] = glm::vec4(float(i) * 0.1f, 1e-40f, -0.0f, 1.0f);
    return kept;
}

bool same(const KeptPicture& a, const KeptPicture& b) {
    return a.sizePx == b.sizePx && a.rgba.size() == b.rgba.size() &&
           std::memcmp(a.rgba.data(), b.rgba.data(), a.rgba.size() * sizeof(glm::vec4)) == 0;
}

TEST_F(Cache, GivesBackWhatWasKept) {
    EXPECT_FALSE(cache().find(kKey));
    // Pixels that begin with what looks like blanks to who reads the lines before them.
    const auto blank = std::bit_cast<float>(0x0a200920u);
    for (const float first : {0.25f, blank, std::numeric_limits<float>::infinity()}) {
        ASSERT_TRUE(cache().keep(kKey, picture(first)).ok());
        const auto found = cache().find(kKey);
        ASSERT_TRUE(found);
        EXPECT_TRUE(same(*found, picture(first)));
    }
    EXPECT_FALSE(cache().find(sha256Hex("another")));
    // One file, whose name is the key.
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename());
    EXPECT_EQ(names, std::vector<std::string>{kKey + ".rgba"});
}

TEST_F(Cache, WhatIsDamagedIsNotThere) {
    ASSERT_TRUE(cache().keep(kKey, picture()).ok());
    const std::string whole = *readText(file(kKey));
    for (std::size_t place = 0; place < whole.size(); ++place) {
        std::string changed = whole;
        changed[place] = char(changed[place] ^ 1);
        ASSERT_TRUE(writeTextAtomically(file(kKey), changed).ok());
        EXPECT_FALSE(cache().find(kKey)) << "byte " << place;
    }
    for (const std::size_t bytes : {std::size_t{0}, std::size_t{20}, whole.size() / 2, whole.size() - 1}) {
        ASSERT_TRUE(writeTextAtomically(file(kKey), whole.substr(0, bytes)).ok());
        EXPECT_FALSE(cache().find(kKey)) << bytes << " bytes";
    }
    ASSERT_TRUE(writeTextAtomically(file(kKey), whole + "x").ok());
    EXPECT_FALSE(cache().find(kKey));
    ASSERT_TRUE(
        writeTextAtomically(file(kKey), fmt::format("macula picture 2\n{}\n999999 999999\n{}\n", kKey, kKey))
            .ok());
    EXPECT_FALSE(cache().find(kKey));
    ASSERT_TRUE(writeTextAtomically(file(kKey), whole).ok());
    EXPECT_TRUE(cache().find(kKey));
}

// A file under another's name is that of another scene.
TEST_F(Cache, AFileThatWasRenamedIsNotThere) {
    ASSERT_TRUE(cache().keep(kKey, picture()).ok());
    const std::string other = sha256Hex("another");
    fs::copy_file(file(kKey), file(other));
    EXPECT_FALSE(cache().find(other));
}

TEST_F(Cache, WithoutAFolderNothingIsKept) {
    const PictureCache none{fs::path()};
    EXPECT_TRUE(none.prepare().ok());
    EXPECT_TRUE(none.keep(kKey, picture()).ok());
    EXPECT_FALSE(none.find(kKey));
}

TEST_F(Cache, AFolderThatCannotBeMadeIsAnError) {
    ASSERT_TRUE(writeTextAtomically(folder_ / "file", "").ok());
    const auto prepared = PictureCache(folder_ / "file" / "folder").prepare();
    ASSERT_FALSE(prepared.ok());
    EXPECT_EQ(prepared.error().code, ErrorCode::outputNotWritable);
    EXPECT_FALSE(PictureCache(folder_ / "gone").keep(kKey, picture()).ok());
}

}  // namespace
}  // namespace macula::hybrid
