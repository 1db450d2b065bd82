// A folder for pictures that are kept, which is gone with the test.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "pipeline/hybrid/views/traced_scene.h"
#include "pipeline/hybrid/views/view_cache.h"

namespace macula::hybrid {

struct KeptFolder {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() /
        fmt::format("macula-{}-{}", ::testing::UnitTest::GetInstance()->current_test_info()->name(),
                    getpid());
    const PictureCache cache{path};
    const ViewCache kept;

    explicit KeptFolder(const TracedScene& scene) : kept(scene, cache) { EXPECT_TRUE(cache.prepare().ok()); }
    ~KeptFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    KeptFolder(const KeptFolder&) = delete;
    KeptFolder& operator=(const KeptFolder&) = delete;
};

}  // namespace macula::hybrid
