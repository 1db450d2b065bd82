// What a pane of slices says of values: where no image was taken, and of PET.
#include "viewer/slice_view_fixture.h"
#include "viewer/slices/slice_view.h"

namespace macula::viewer {
namespace {

using slices::Orientation;

TEST_F(SliceViewTest, WhatIsPointedAtAndWhatNobodyTookIsSaid) {
    VolumeOptions options = test::sliceVolumeOptions();
    options.provenance.interpolatedSlices = {{.first = 10, .last = 10}};
    showStudy(std::move(options));
    const auto view = pane(Orientation::axial);
    EXPECT_EQ(view->notes(), QStringList{"Interpolated: no image was taken here"});
    session_->change("Cross-hair",
                     [](scene::StudyState& next) { next.slices.crosshairMm = test::kBlockCentreMm; });
    ASSERT_TRUE(settled(*view));
    EXPECT_TRUE(view->notes().isEmpty());
    move(*view, placeOf(*view, test::kBlockCentreMm), Qt::NoButton);
    EXPECT_TRUE(view->probedText().startsWith("1000 HU at (7, 6, 16), R 1"))
        << view->probedText().toStdString();
    move(*view, {200, 5}, Qt::NoButton);
    EXPECT_TRUE(view->probedText().startsWith("Outside")) << view->probedText().toStdString();
    session_->change("Slab", [](scene::StudyState& next) {
        next.slices.slab = {.thicknessMm = 10.0, .projection = slices::Projection::maximum};
    });
    ASSERT_TRUE(settled(*view));
    EXPECT_EQ(view->notes(), QStringList{"MIP 10 mm"});
    EXPECT_TRUE(view->probedText().startsWith("Middle of the slab"));
}

// Slices 10 to 12, that is from 1 mm below to 5 mm above the middle.
TEST_F(SliceViewTest, PlanesAcrossMarkWhereNoImageWasTaken) {
    VolumeOptions options = test::sliceVolumeOptions();
    options.provenance.interpolatedSlices = {{.first = 10, .last = 12}};
    showStudy(std::move(options));
    constexpr QRgb kMark = qRgb(255, 190, 90);
    for (const Orientation across : {Orientation::coronal, Orientation::sagittal}) {
        const auto view = pane(across);
        EXPECT_EQ(view->notes(), QStringList{"Interpolated between dashed lines: no image was taken there"});
        const QImage picture = pictureOf(*view);
        for (const double z : {-1.0, 5.0}) {
            const int row = placeOf(*view, {0.0, 0.0, z}).y();
            int marked = 0;
            for (int y = row - 1; y <= row + 1; ++y)
                for (int x = 0; x < picture.width(); ++x) marked += picture.pixel(x, y) == kMark ? 1 : 0;
            EXPECT_GT(marked, 60) << z;
        }
    }
    session_->change("Slab", [](scene::StudyState& next) {
        next.slices.crosshairMm = glm::dvec3(0.0, 0.0, 8.0);  // slice 14
        next.slices.slab.thicknessMm = 12.0;
    });
    const auto axial = pane(Orientation::axial);
    EXPECT_TRUE(axial->notes().contains("Some slices of the slab are interpolated"));
    session_->change("Slab", [](scene::StudyState& next) { next.slices.slab.thicknessMm = 2.0; });
    ASSERT_TRUE(settled(*axial));
    EXPECT_FALSE(axial->notes().contains("Some slices of the slab are interpolated"));
    move(*axial, placeOf(*axial, {0.0, 0.0, 8.0}), Qt::NoButton);
    EXPECT_FALSE(axial->probedText().contains("interpolated"));
    const auto coronal = pane(Orientation::coronal);
    move(*coronal, placeOf(*coronal, {3.0, 0.0, 2.0}), Qt::NoButton);
    EXPECT_TRUE(coronal->probedText().contains("0 HU, interpolated, at"))
        << coronal->probedText().toStdString();
}

// 0 to 5 SUV: what takes nothing up is white.
TEST_F(SliceViewTest, PetIsBlackOnWhiteFromZeroOn) {
    VolumeOptions options = test::sliceVolumeOptions();
    options.unitsFromStored = {.slope = 0.005, .intercept = -5.0};
    options.unit = Unit::suvBodyWeight;
    options.modality = "PT";
    options.windows = {{.center = 500.0, .width = 1000.0, .explanation = {}, .function = {}}};
    session_->show({.volume = test::sliceVolume(std::move(options)), .isLowBright = true}, {});
    session_->change("Cross-hair",
                     [](scene::StudyState& next) { next.slices.crosshairMm = test::kBlockCentreMm; });
    const auto view = pane(Orientation::axial);
    EXPECT_TRUE(view->notes().contains("Low values are white, as is custom for PET"));
    const QImage picture = pictureOf(*view);
    EXPECT_EQ(picture.pixel(placeOf(*view, test::kBlockCentreMm + glm::dvec3(1, 1, 0))), qRgb(0, 0, 0));
    EXPECT_EQ(picture.pixel(placeOf(*view, {10.0, 8.0, 12.0})), qRgb(255, 255, 255));
    move(*view, placeOf(*view, test::kBlockCentreMm), Qt::NoButton);
    EXPECT_TRUE(view->probedText().startsWith("5 SUV bw at")) << view->probedText().toStdString();
    QTest::keyClick(view.get(), Qt::Key_I);
    ASSERT_TRUE(settled(*view));
    EXPECT_TRUE(view->notes().isEmpty()) << "white on black is as it always is";
}

}  // namespace
}  // namespace macula::viewer
