// The panel of movies, what is written over their pictures, and the encoder, which here is a script.
#include <gtest/gtest.h>

#include <QFile>
#include <QFileInfo>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <optional>

#include "scene/camera/orbit_camera.h"
#include "viewer/offscreen.h"
#include "viewer/output/models_controller.h"
#include "viewer/output/movie_panel.h"
#include "viewer/output/movies_controller.h"
#include "viewer/output/picture_overlays.h"
#include "viewer/output/video_encoder.h"

namespace macula::viewer {
namespace {

class MoviePanelTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        panel_.emplace([this] { return camera_; });
        panel_->show();
    }
    void TearDown() override {
        panel_.reset();
        OffscreenTest::TearDown();
    }
    template <class Widget>
    Widget& find(const char* name) {
        return *panel_->findChild<Widget*>(QLatin1String(name));
    }
    void click(const char* name) { find<QPushButton>(name).click(); }
    static Camera at(double azimuthDeg) { return toCamera(scene::OrbitCamera{.azimuthDeg = azimuthDeg}); }

    std::optional<Camera> camera_ = at(0.0);
    std::optional<MoviePanel> panel_;
};

TEST_F(MoviePanelTest, ATurntableGoesAroundFromHere) {
    ASSERT_TRUE(panel_->isTurntable());
    EXPECT_EQ(panel_->frames(), 200);
    EXPECT_TRUE(panel_->isClosed());
    const auto path = panel_->pathFrom(at(0.0));
    ASSERT_TRUE(path);
    EXPECT_NEAR(path->seconds(), 8.0, 1e-9);
    const Camera quarter = cameraAt(*path, 2.0);
    EXPECT_GT(quarter.positionMm.x, 900.0) << "to the patient's left";
    EXPECT_FALSE(panel_->withNames()) << "nobody is named unless somebody wants that";
}

TEST_F(MoviePanelTest, ViewsMakeAWay) {
    find<QComboBox>("movie-kind").setCurrentIndex(1);
    EXPECT_FALSE(find<QPushButton>("movie-draw").isEnabled());
    EXPECT_FALSE(panel_->pathFrom(at(0.0)));
    for (const double azimuth : {0.0, 40.0, 90.0}) {
        camera_ = at(azimuth);
        click("movie-add");
    }
    ASSERT_EQ(panel_->views().stops.size(), 3u);
    EXPECT_EQ(panel_->views().seconds(), 4.0);
    EXPECT_EQ(panel_->seconds(), 4.0);
    EXPECT_TRUE(find<QPushButton>("movie-draw").isEnabled());
    EXPECT_FALSE(panel_->isClosed());
    find<QListWidget>("movie-views").setCurrentRow(1);
    click("movie-remove");
    ASSERT_EQ(panel_->views().stops.size(), 2u);
    EXPECT_EQ(panel_->views().stops[1].camera, at(90.0));
    EXPECT_EQ(panel_->views().seconds(), 2.0);
    find<QListWidget>("movie-views").setCurrentRow(0);
    click("movie-remove");
    EXPECT_EQ(panel_->views().stops.front().atS, 0.0);
    click("movie-remove");
    EXPECT_TRUE(panel_->views().stops.empty());
    click("movie-remove");
    camera_.reset();
    click("movie-add");
    EXPECT_TRUE(panel_->views().stops.empty()) << "there is no study";
}

TEST_F(MoviePanelTest, AWayOfAFileHasItsTimesAndMayBeStretched) {
    scene::CameraPath path;
    path.stops = {
        {.atS = 0.0, .camera = at(0.0)}, {.atS = 1.0, .camera = at(10.0)}, {.atS = 5.0, .camera = at(50.0)}};
    panel_->setViews(path);
    EXPECT_FALSE(panel_->isTurntable());
    EXPECT_EQ(panel_->seconds(), 5.0);
    const auto same = panel_->pathFrom(at(0.0));
    ASSERT_TRUE(same);
    EXPECT_EQ(same->stops[1].atS, 1.0);
    panel_->setViews({});
    EXPECT_FALSE(panel_->pathFrom(at(0.0)));
}

// Before hundreds of pictures are drawn for nothing.
TEST_F(MoviePanelTest, SaysThatThereIsNoEncoderBeforeAnythingIsDrawn) {
    const auto* says = panel_->findChild<QLabel*>(QStringLiteral("movie-no-encoder"));
    ASSERT_NE(says, nullptr);
    panel_->setHasEncoder(true);
    EXPECT_FALSE(says->isVisibleTo(&*panel_));
    EXPECT_TRUE(panel_->wantsVideo());
    panel_->setHasEncoder(false);
    EXPECT_TRUE(says->isVisibleTo(&*panel_));
    EXPECT_TRUE(says->text().contains(QStringLiteral("ffmpeg")));
    EXPECT_FALSE(panel_->wantsVideo());
    panel_->setHasEncoder(true);
    EXPECT_TRUE(panel_->wantsVideo()) << "it was installed meanwhile";
}

TEST_F(MoviePanelTest, LettersStandAtTheirEdges) {
    const scene::EdgeLetters letters = scene::edgeLetters(scene::OrbitCamera{});
    for (const glm::ivec2& size : {glm::ivec2(640, 480), glm::ivec2(16, 16), glm::ivec2(4096, 64)}) {
        const auto stamps = stampsOf({"A line", ""}, letters, size);
        ASSERT_EQ(stamps.size(), 5u);
        for (const pictures::Stamp& stamp : stamps)
            EXPECT_EQ(stamp.rgba.size(), std::size_t(stamp.sizePx.x) * std::size_t(stamp.sizePx.y) * 4);
        EXPECT_LT(stamps[1].atPx.x, stamps[2].atPx.x + stamps[2].sizePx.x) << "left is at the left";
        std::vector<std::uint8_t> picture(std::size_t(size.x) * std::size_t(size.y) * 4, 0);
        for (const pictures::Stamp& stamp : stamps) putOver(picture, size, stamp);
    }
    EXPECT_TRUE(stampsOf({}, {}, {640, 480}).empty());
    const auto stamps = stampsOf({}, letters, {640, 480});
    EXPECT_LT(stamps[0].atPx.x, 40);
    EXPECT_GT(stamps[1].atPx.x, 560);
    EXPECT_LT(stamps[2].atPx.y, 40);
    EXPECT_GT(stamps[3].atPx.y, 400);
}

TEST_F(MoviePanelTest, OverlaysOfASavedPictureAreLettersCubeAndScale) {
    const Camera anterior = toCamera(scene::OrbitCamera{});
    const auto letters = stampsOf({}, scene::edgeLetters(scene::OrbitCamera{}), {1280, 720});
    const auto all = overlaysOf(anterior, {1280, 720}, true);
    ASSERT_GT(all.size(), letters.size()) << "cube and scale";
    for (std::size_t i = 0; i < letters.size(); ++i) {
        EXPECT_EQ(all[i].atPx, letters[i].atPx);
        EXPECT_EQ(all[i].rgba, letters[i].rgba) << "left and right as in the window";
    }
    for (std::size_t i = letters.size(); i < all.size(); ++i) {
        EXPECT_EQ(all[i].rgba.size(), std::size_t(all[i].sizePx.x) * std::size_t(all[i].sizePx.y) * 4);
        EXPECT_GT(all[i].atPx.x, 640);
        EXPECT_GT(all[i].atPx.y, 360);
        EXPECT_LE(all[i].atPx.x + all[i].sizePx.x, 1280);
        EXPECT_LE(all[i].atPx.y + all[i].sizePx.y, 720);
    }
    // Twice the picture, twice the marks.
    const auto large = overlaysOf(anterior, {2560, 1440}, true);
    EXPECT_NEAR(large.back().sizePx.y, 2 * all.back().sizePx.y, 4);
    EXPECT_EQ(overlaysOf(anterior, {64, 48}, true).size(), 4u) << "letters alone";
    EXPECT_TRUE(overlaysOf(anterior, {0, 48}, true).empty());
    Camera none = anterior;
    none.targetMm = none.positionMm;
    EXPECT_TRUE(overlaysOf(none, {640, 480}, true).empty());
}

class VideoEncoderTest : public test::OffscreenTest {
  protected:
    QString script(const QByteArray& text) {
        const QString path = folder_.filePath(QStringLiteral("encoder"));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("#!/bin/sh\n" + text);
        file.close();
        file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        return path;
    }
    VideoRequest request() const {
        return {.folder = folder_.path(),
                .frames = 12,
                .picturesPerS = 25.0,
                .fileName = QStringLiteral("movie.mp4")};
    }
    // What it told; nothing while it runs.
    std::optional<bool> run(const QString& program) {
        std::optional<bool> told;
        VideoEncoder encoder;
        QObject::connect(&encoder, &VideoEncoder::ended, &encoder, [&](bool isWritten) { told = isWritten; });
        QObject::connect(&encoder, &VideoEncoder::progressed, &encoder,
                         [&](double fraction) { fraction_ = std::max(fraction_, fraction); });
        encoder.start(program, request());
        EXPECT_TRUE(waitUntil([&] { return told.has_value(); }));
        return told;
    }

    QTemporaryDir folder_;
    double fraction_ = 0.0;
};

using ModelExportTest = test::OffscreenTest;

TEST_F(ModelExportTest, AModelThatCouldNotBeReadIsAnEndAndTold) {
    ModelExport save;
    int ends = 0;
    std::vector<std::string> told;
    QObject::connect(&save, &ModelExport::ended, &save, [&] { ++ends; });
    QObject::connect(&save, &ModelExport::failed, &save,
                     [&](const Error& e) { told.push_back(e.message.english()); });
    save.expect({.path = "/no/such/folder/model.ply"}, 7);
    live::ModelSnapshot taken{.request = 7};
    taken.error = Error{ErrorCode::deviceLost, Text("The graphics device stopped."), {}, Text("Try again.")};
    save.onTaken(taken);
    save.onTaken(taken);
    EXPECT_EQ(ends, 1);
    EXPECT_EQ(told, std::vector<std::string>{"The graphics device stopped."});
}

std::shared_ptr<const Volume> smallVolume() {
    auto made =
        Volume::create({.size = glm::ivec3(2), .modality = "CT"}, std::vector<std::uint16_t>(8, 1000));
    return std::make_shared<const Volume>(*std::move(made));
}

TEST_F(ModelExportTest, HoldsNoStudyAfterItsEnd) {
    ModelExport save;
    std::weak_ptr<const Volume> held;
    const auto expect = [&](std::uint64_t number) {
        auto volume = smallVolume();
        held = volume;
        save.expect({.path = "/no/such/folder/model.ply", .volume = volume}, number);
    };
    expect(1);
    EXPECT_FALSE(held.expired());
    save.cancel();
    EXPECT_TRUE(held.expired());
    expect(2);
    save.onTaken({.request = 2});
    EXPECT_TRUE(held.expired());
    expect(3);
    int failures = 0;
    QObject::connect(&save, &ModelExport::failed, &save, [&](const Error&) { ++failures; });
    save.onTaken({.request = 3, .splats = std::make_shared<const splat::Splats>()});
    EXPECT_TRUE(waitUntil([&] { return failures == 1 && held.expired(); }));
}

TEST_F(ModelExportTest, NorDoesAMovie) {
    MovieExport movie(std::string{});
    int failures = 0;
    QObject::connect(&movie, &MovieExport::failed, &movie, [&](const Error&) { ++failures; });
    MovieRequest request;  // without a way: refused
    request.sequence.picture.volume = smallVolume();
    request.sequence.frames = 0;
    const std::weak_ptr<const Volume> held = request.sequence.picture.volume;
    movie.start(std::move(request));
    EXPECT_TRUE(waitUntil([&] { return failures == 1 && held.expired(); }));
}

TEST_F(VideoEncoderTest, IsGivenWordsAndWritesWhole) {
    const QStringList words = VideoEncoder::argumentsFor(request(), 0);
    EXPECT_TRUE(words.contains(QStringLiteral("frame-%04d.png")));
    EXPECT_TRUE(words.contains(QStringLiteral("libx264")));
    EXPECT_EQ(words.last(), QStringLiteral(".movie.mp4.part"));
    EXPECT_TRUE(VideoEncoder::argumentsFor(request(), 99).isEmpty());
    // The last word is the file that it writes.
    EXPECT_EQ(run(script("for last; do :; done\necho frame=6\necho frame=12\necho video > \"$last\"\n")),
              true);
    EXPECT_TRUE(QFileInfo::exists(folder_.filePath(QStringLiteral("movie.mp4"))));
    EXPECT_FALSE(QFileInfo::exists(folder_.filePath(QStringLiteral(".movie.mp4.part"))));
    EXPECT_EQ(fraction_, 1.0);
}

TEST_F(VideoEncoderTest, TakesTheKindThatItHas) {
    EXPECT_EQ(
        run(script("for last; do :; done\ncase \"$*\" in *mpeg4*) echo v > \"$last\";; *) exit 1;; esac\n")),
        true);
    EXPECT_TRUE(QFileInfo::exists(folder_.filePath(QStringLiteral("movie.mp4"))));
}

TEST_F(VideoEncoderTest, LeavesNothingWhereItFails) {
    EXPECT_EQ(run(script("for last; do :; done\necho half > \"$last\"\nexit 1\n")), false);
    EXPECT_EQ(run(folder_.filePath(QStringLiteral("no-such-program"))), false);
    EXPECT_FALSE(QFileInfo::exists(folder_.filePath(QStringLiteral("movie.mp4"))));
    EXPECT_FALSE(QFileInfo::exists(folder_.filePath(QStringLiteral(".movie.mp4.part"))));
    EXPECT_TRUE(VideoEncoder::find(QStringLiteral("no-such-program-anywhere")).isEmpty());
}

TEST_F(VideoEncoderTest, MayBeStopped) {
    VideoEncoder encoder;
    bool wasTold = false;
    QObject::connect(&encoder, &VideoEncoder::ended, &encoder, [&](bool) { wasTold = true; });
    encoder.start(script("for last; do :; done\necho half > \"$last\"\necho frame=1\nexec sleep 60\n"),
                  request());
    EXPECT_TRUE(
        waitUntil([&] { return QFileInfo::exists(folder_.filePath(QStringLiteral(".movie.mp4.part"))); }));
    encoder.cancel();
    settle();
    EXPECT_FALSE(encoder.running());
    EXPECT_FALSE(wasTold);
    EXPECT_FALSE(QFileInfo::exists(folder_.filePath(QStringLiteral(".movie.mp4.part"))));
}

}  // namespace
}  // namespace macula::viewer
