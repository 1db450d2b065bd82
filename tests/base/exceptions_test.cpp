#include "base/exceptions.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

namespace macula {
namespace {

TEST(Exceptions, OnlyLackOfMemoryIsCalledSo) {
    const Error memory = errorOf(std::bad_alloc(), Text("read this folder"), "/where");
    EXPECT_EQ(memory.code, ErrorCode::outOfMemory);
    EXPECT_EQ(memory.message, "There is not enough memory to read this folder.");
    EXPECT_EQ(memory.where, "/where");
    EXPECT_EQ(errorOf(std::bad_array_new_length(), Text("read this folder")).code, ErrorCode::outOfMemory);

    const std::system_error threads(std::make_error_code(std::errc::resource_unavailable_try_again));
    EXPECT_EQ(errorOf(threads, Text("read this folder")).code, ErrorCode::outOfMemory);
    EXPECT_NE(errorOf(threads, Text("read this folder")).message.english().find("threads"),
              std::string::npos);

    const std::filesystem::filesystem_error disk("SECRET^NAME", std::make_error_code(std::errc::io_error));
    const Error ofDisk = errorOf(disk, Text("read this folder"));
    EXPECT_EQ(ofDisk.code, ErrorCode::inputNotUsable);
    EXPECT_EQ(ofDisk.message, "The system gave an error when the program was to read this folder.");
    for (const auto& thrown : {std::runtime_error("SECRET^NAME"), std::runtime_error("memory")}) {
        const Error error = errorOf(thrown, Text("read this folder"));
        EXPECT_EQ(error.code, ErrorCode::inputNotUsable);
        EXPECT_EQ(error.message.english().find("memory"), std::string::npos) << error.message;
        EXPECT_EQ(error.message.english().find("SECRET"), std::string::npos) << error.message;
        EXPECT_FALSE(error.hint.empty());
    }
    EXPECT_EQ(errorOf(std::length_error("vector"), Text("read this folder")).code, ErrorCode::inputNotUsable);
}

}  // namespace
}  // namespace macula
