// Widgets without a display, in this process.
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <cstdlib>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "study/open/opened_study.h"
#include "viewer/wait_until.h"

namespace macula::viewer::test {

// The offscreen platform has no theme of a desktop and no X server.
class OffscreenTest : public testing::Test {
  protected:
    void SetUp() override {
        setenv("QT_QPA_PLATFORM", "offscreen", 1);
        application_.emplace(argc_, argv_);
    }
    void TearDown() override { application_.reset(); }

    static void settle() {
        for (int i = 0; i < 3; ++i) QCoreApplication::processEvents();
    }
    static study::OpenedStudy smallStudy() {
        auto volume = Volume::create({.size = glm::ivec3(8), .unit = Unit::hounsfield, .modality = "CT"},
                                     std::vector<std::uint16_t>(512, 1000));
        return {.volume = std::make_shared<const Volume>(*std::move(volume))};
    }

    int argc_ = 1;
    char name_[5] = "test";
    char* argv_[2] = {name_, nullptr};
    std::optional<QApplication> application_;
};

}  // namespace macula::viewer::test
