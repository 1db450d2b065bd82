// A slider of a second volume in the 3D picture. On Qt's platform without a screen.
#include <gtest/gtest.h>

#include <QTest>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viewer/offscreen.h"
#include "viewer/second/second_volume_loader.h"
#include "viewer/segmentation/segmentation_keeper.h"
#include "viewer/slice_volume.h"
#include "viewer/volume/shown_additions.h"

namespace macula::viewer {
namespace {

study::OpenedStudy studyOf(std::shared_ptr<const Volume> volume, std::string digest, std::string date) {
    study::OpenedStudy study;
    study.volume = std::move(volume);
    study.seriesDigest = std::move(digest);
    study.identity.patientName = "Doe^Jane";
    study.identity.patientId = "17";
    study.identity.birthDate = "19700101";
    study.identity.studyDate = std::move(date);
    return study;
}

// Of floats: in 16 bits each is a copy, so that two conversions are told apart.
std::shared_ptr<const Volume> floats() {
    VolumeOptions options = test::sliceVolumeOptions();
    options.unitsFromStored = {};
    std::vector<float> values(test::sliceVolume()->voxelCount());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 0.37f * float(i % 1000);
    auto made = Volume::createFloat(std::move(options), std::move(values));
    EXPECT_TRUE(made.ok());
    return std::make_shared<const Volume>(*std::move(made));
}

class SecondDragTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        session_.emplace(scene::Catalogue{});
        secondVolume_.emplace(*session_);
        session_->show(studyOf(test::sliceVolume(), "current", "20240301"), {});
        secondVolume_->offer(studyOf(floats(), "prior", "20220301"));
        secondVolume_->cancel();
        session_->change("Link", [](scene::StudyState& next) {
            next.secondVolume->link = scene::SecondVolumeLink::registered;
            next.secondVolume->secondFromStudy = glm::dmat4(1.0);
        });
        segments_.emplace(*session_);
        shown_.emplace(*session_, *segments_);
        shown_->setSecond(secondVolume_->second());
        QObject::connect(&*shown_, &ShownAdditions::changed, &*shown_, [this] {
            seen_.push_back(shown_->additions() ? shown_->additions()->second : std::nullopt);
        });
    }
    void TearDown() override {
        shown_.reset();
        segments_.reset();
        secondVolume_.reset();
        session_.reset();
        OffscreenTest::TearDown();
    }
    void drag(std::initializer_list<double> opacities) {
        for (const double opacity : opacities)
            session_->drag("Opacity", [&](scene::StudyState& next) {
                next.secondVolume->in3d = true;
                next.secondVolume->opacity = opacity;
            });
    }
    bool atRest() {
        return waitUntil([this] { return shown_->isAtRest(); });
    }
    static double opacityOf(const std::optional<DrawnSecondVolume>& second) {
        return second ? second->function->opacity.back().opacity : -1.0;
    }

    std::optional<StudyEditor> session_;
    std::optional<SecondVolumeLoader> secondVolume_;
    std::optional<SegmentationKeeper> segments_;
    std::optional<ShownAdditions> shown_;
    std::vector<std::optional<DrawnSecondVolume>> seen_;
};

// It asks faster than the volume is prepared: what was begun is shown, and then the newest, of one copy.
TEST_F(SecondDragTest, IsFollowedAndEndsAtTheNewestOfOneVolume) {
    drag({1.0, 0.8, 0.6, 0.4, 0.2});
    ASSERT_TRUE(atRest());
    ASSERT_EQ(seen_.size(), 2u);
    EXPECT_NEAR(opacityOf(seen_[1]), 0.2 * opacityOf(seen_[0]), 1e-9);
    ASSERT_TRUE(seen_[0] && seen_[1]);
    EXPECT_EQ(seen_[0]->volume, seen_[1]->volume);
}

// With a preset of its own in 3D, its sliders over slices are of slices alone.
TEST_F(SecondDragTest, WithAPresetOverSlicesNothingOfItChangesIn3d) {
    TransferFunction preset;
    preset.name = "preset";
    preset.colour = {{0.0, {1.0, 1.0, 1.0}}};
    preset.opacity = {{0.0, 0.0}, {300.0, 0.5}};
    session_->change("Preset", [&](scene::StudyState& next) {
        next.secondVolume->preset = std::make_shared<const TransferFunction>(preset);
    });
    drag({1.0});
    ASSERT_TRUE(atRest());
    ASSERT_EQ(seen_.size(), 1u);
    const auto before = shown_->additions();
    drag({0.8, 0.3});
    session_->change("Window", [](scene::StudyState& next) {
        next.secondVolume->window =
            DisplayWindow{.center = 1.0, .width = 2.0, .explanation = {}, .function = {}};
        next.secondVolume->colours = slices::ColourTable::grey;
        next.secondVolume->boundMm = 0.5;
    });
    ASSERT_TRUE(atRest());
    EXPECT_EQ(seen_.size(), 1u);
    EXPECT_EQ(shown_->additions(), before);
    session_->change("Place", [](scene::StudyState& next) { next.secondVolume->secondFromStudy[3].x = 3.0; });
    ASSERT_TRUE(atRest());
    EXPECT_EQ(seen_.size(), 2u);
}

TEST_F(SecondDragTest, WhatIsTakenAwayMeanwhileNeverComes) {
    drag({1.0, 0.5});
    session_->change("In 3D too", [](scene::StudyState& next) { next.secondVolume->in3d = false; });
    ASSERT_TRUE(atRest());
    EXPECT_EQ(shown_->additions(), nullptr);
    drag({0.7});
    shown_->setSecond(nullptr);
    ASSERT_TRUE(atRest());
    QTest::qWait(50);  // what was begun ends meanwhile
    EXPECT_TRUE(seen_.empty());
    EXPECT_EQ(shown_->additions(), nullptr);
}

}  // namespace
}  // namespace macula::viewer
