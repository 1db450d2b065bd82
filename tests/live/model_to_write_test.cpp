// The model of a window as files.
#include "live/model/model_to_write.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "pipeline/splat/files/model_file.h"
#include "pipeline/splat/model/constant_colour.h"
#include "support.h"

namespace macula::live {
namespace {

ModelToWrite taken() {
    splat::Splats splats;
    splats.setShDegree(1);
    splats.resize(2);
    splats.originMm = {1.0, 2.0, 3.0};
    splats.dc[0] = {0.2f, -0.3f, 0.4f};
    splats.sh[0] = {0.01f, 0.02f, 0.03f};
    ModelToWrite model;
    model.splats = std::make_shared<const splat::Splats>(splats);
    model.gain = 1.25;
    return model;
}

TEST(ModelToWrite, IsAsBrightAsWhatIsTraced) {
    const splat::Splats before = *taken().splats;
    const splat::Splats bright = asBright(before, 1.25);
    for (std::size_t i = 0; i < before.size(); ++i) {
        const glm::vec3 is = splat::colourOfDc(bright.dc[i]);
        EXPECT_LT(glm::length(is - 1.25f * splat::colourOfDc(before.dc[i])), 1e-5f);
    }
    EXPECT_LT(glm::length(bright.sh[0] - 1.25f * before.sh[0]), 1e-6f);
    EXPECT_EQ(bright.position, before.position);
}

TEST(ModelToWrite, EachFormatIsWritten) {
    const dicom::test::TemporaryFolder folder;
    Progress progress;
    for (const char* name : {"a.ply", "a.spz", "a.glb"}) {
        for (const bool displayColours : {false, true}) {
            const auto path = folder.path() / name;
            const auto written = writeModelFile(path, taken(), displayColours, progress);
            ASSERT_TRUE(written.ok()) << name << ": " << written.error().message;
            const auto read = splat::readModel(path);
            ASSERT_TRUE(read.ok()) << name;
            EXPECT_EQ(read->splats.size(), 2u);
            EXPECT_EQ(read->splats.originMm, glm::dvec3(1.0, 2.0, 3.0));
            EXPECT_EQ(read->splats.colourSpace,
                      displayColours ? splat::ColourSpace::display : splat::ColourSpace::linear);
        }
    }
}

TEST(ModelToWrite, WhatCannotBeWrittenIsSaid) {
    const dicom::test::TemporaryFolder folder;
    Progress progress;
    const auto code = [&](const char* name, bool displayColours) {
        const auto written = writeModelFile(folder.path() / name, taken(), displayColours, progress);
        EXPECT_FALSE(written.ok()) << name;
        EXPECT_FALSE(std::filesystem::exists(folder.path() / name));
        return written.ok() ? ErrorCode::cancelled : written.error().code;
    };
    EXPECT_EQ(code("a.obj", false), ErrorCode::usage);
    EXPECT_EQ(code("a.macula", true), ErrorCode::usage);
    EXPECT_EQ(code("a.macula", false), ErrorCode::inputNotUsable) << "nothing was learnt";
    progress.token().cancel();
    EXPECT_EQ(code("a.ply", false), ErrorCode::cancelled);
}

}  // namespace
}  // namespace macula::live
