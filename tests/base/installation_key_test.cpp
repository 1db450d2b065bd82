// The secret of an installation: made once, for its owner alone, and the same ever after.
#include "base/installation_key.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "base/sha256.h"

namespace macula {
namespace {

namespace fs = std::filesystem;

class InstallationKeys : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(::testing::TempDir()) / ("macula-key-" + std::to_string(getpid()));
        fs::remove_all(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path file() const { return folder_ / "macula" / "installation.key"; }
    std::string text() const {
        std::ifstream stream(file(), std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    Result<InstallationKey> key() const { return InstallationKey::ofUser(folder_ / "macula"); }

    fs::path folder_;
};

TEST_F(InstallationKeys, AreMadeOnceForTheirOwnerAlone) {
    EXPECT_FALSE(InstallationKey::find(folder_ / "macula")) << "looking makes none";
    EXPECT_FALSE(fs::exists(folder_));
    const auto made = key();
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(text().size(), 32u);
    EXPECT_EQ(fs::status(file()).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(fs::status(folder_ / "macula").permissions(), fs::perms::owner_all);
    const std::string before = text();
    EXPECT_EQ(key()->digestOf("1.2.3"), made->digestOf("1.2.3"));
    EXPECT_EQ(InstallationKey::find(folder_ / "macula")->digestOf("1.2.3"), made->digestOf("1.2.3"));
    EXPECT_EQ(text(), before);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "macula"), {}), 1) << "no draft is left";
}

TEST_F(InstallationKeys, DifferSoThatNobodyCanTryIdentifiersOut) {
    const std::string mine = key()->digestOf("1.2.3");
    EXPECT_NE(mine, sha256Hex("1.2.3"));
    EXPECT_NE(mine, key()->digestOf("1.2.4"));
    fs::remove_all(folder_);
    EXPECT_NE(key()->digestOf("1.2.3"), mine) << "another installation";
}

TEST_F(InstallationKeys, DigestAsTheStandardSays) {
    // RFC 4231, test cases 1 and 2: HMAC-SHA256.
    std::array<std::byte, 20> first;
    first.fill(std::byte{0x0b});
    EXPECT_EQ(hmacSha256Hex(first, "Hi There"),
              "b0344c61d8db38535ca8afceaf0bf12b881dc200c9833da726e9376c2e32cff7");
    constexpr std::string_view kJefe = "Jefe";
    EXPECT_EQ(hmacSha256Hex(std::as_bytes(std::span(kJefe)), "what do ya want for nothing?"),
              "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843");
    fs::create_directories(folder_ / "macula");
    std::ofstream(file(), std::ios::binary) << std::string(20, '\x0b') + std::string(12, '\0');
    // HMAC pads keys with zeros.
    EXPECT_EQ(key()->digestOf("Hi There"),
              "b0344c61d8db38535ca8afceaf0bf12b881dc200c9833da726e9376c2e32cff7");
    EXPECT_EQ(fs::status(file()).permissions(), fs::perms::owner_read | fs::perms::owner_write)
        << "others could read it before";
}

// A digest that is made with half a key, or with none, is no secret.
TEST_F(InstallationKeys, ThatAreDamagedAreNotUsedOrReplaced) {
    fs::create_directories(folder_ / "macula");
    std::ofstream(file(), std::ios::binary) << "short";
    const auto read = key();
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable);
    EXPECT_FALSE(InstallationKey::find(folder_ / "macula"));
    EXPECT_EQ(text(), "short");
    fs::remove(file());
    fs::create_symlink("/dev/zero", file());
    EXPECT_FALSE(key());
}

TEST_F(InstallationKeys, OfProgramsThatBeginAtOnceAreOne) {
    constexpr int kPrograms = 8;
    for (int i = 0; i < kPrograms; ++i) {
        if (fork() == 0) {
            const auto made = key();
            if (made) std::ofstream(folder_.string() + "." + std::to_string(i)) << made->digestOf("1.2.3");
            _exit(made ? 0 : 1);
        }
    }
    int failed = 0;
    for (int i = 0; i < kPrograms; ++i) {
        int status = 0;
        wait(&status);
        failed += status != 0 ? 1 : 0;
    }
    EXPECT_EQ(failed, 0);
    std::set<std::string> digests;
    for (int i = 0; i < kPrograms; ++i) {
        const fs::path told = folder_.string() + "." + std::to_string(i);
        std::string digest;
        std::ifstream(told) >> digest;
        digests.insert(digest);
        fs::remove(told);
    }
    EXPECT_EQ(digests, std::set<std::string>{key()->digestOf("1.2.3")});
}

TEST(Sha256Parts, MakeOneDigest) {
    Sha256 hash;
    for (const std::string_view part : {"a", "", "bc"}) hash.add(std::as_bytes(std::span(part)));
    // FIPS 180-4: "abc".
    EXPECT_EQ(hash.hex(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(Sha256().hex(), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace
}  // namespace macula
