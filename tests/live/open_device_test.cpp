// Where compiled kernels are kept, and when.
#include "live/device/open_device.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>

namespace macula::live {
namespace {

namespace fs = std::filesystem;

// A variable of the environment, as it was at the end.
class Variable {
  public:
    Variable(const char* name, const char* value) : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before;
        value != nullptr ? setenv(name, value, 1) : unsetenv(name);
    }
    ~Variable() { before_ ? setenv(name_, before_->c_str(), 1) : unsetenv(name_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    const char* name_;
    std::optional<std::string> before_;
};

TEST(KernelsFolder, IsWhereTheDesktopKeepsWhatCanBeMadeAgain) {
    const Variable own("MACULA_KERNELS", nullptr);
    const Variable home("HOME", "/home/somebody");
    {
        const Variable cache("XDG_CACHE_HOME", "/var/cache/somebody");
        EXPECT_EQ(usualKernelsFolder(), "/var/cache/somebody/macula/kernels");
    }
    for (const char* useless : {static_cast<const char*>(nullptr), "", "relative/cache"}) {
        const Variable cache("XDG_CACHE_HOME", useless);
        EXPECT_EQ(usualKernelsFolder(), "/home/somebody/.cache/macula/kernels");
    }
    const Variable cache("XDG_CACHE_HOME", nullptr);
    const Variable odd("HOME", "not/a/home");
    EXPECT_TRUE(usualKernelsFolder().empty());
}

TEST(KernelsFolder, IsTheOneThatIsChosenOrNone) {
    const Variable cache("XDG_CACHE_HOME", "/var/cache/somebody");
    {
        const Variable own("MACULA_KERNELS", "/elsewhere");
        EXPECT_EQ(usualKernelsFolder(), "/elsewhere");
    }
    const Variable none("MACULA_KERNELS", "");
    EXPECT_TRUE(usualKernelsFolder().empty());
}

// A library says nothing, and its devices write no file.
TEST(KernelsFolder, IsOnlyThatOfAProgramThatSaysSo) {
    EXPECT_TRUE(deviceOptions("0").kernelsFolder.empty());
    keepKernelsIn("/kept/here");
    EXPECT_EQ(deviceOptions("0").kernelsFolder, "/kept/here");
    EXPECT_EQ(deviceOptions("0").preferred, "0");
    keepKernelsIn({});
    EXPECT_TRUE(deviceOptions("").kernelsFolder.empty());
}

}  // namespace
}  // namespace macula::live
