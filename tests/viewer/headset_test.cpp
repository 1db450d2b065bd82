// The mirror of a headset, and what is said where there is none.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <cstdlib>

#include "viewer/headset/headset_mirror.h"
#include "viewer/headset/headset_show.h"
#include "viewer/offscreen.h"
#include "viewer/program/command_line.h"

namespace macula::viewer {
namespace {

class HeadsetPanelTest : public test::OffscreenTest {};

QImage green() {
    QImage image(64, 32, QImage::Format_RGBX8888);
    image.fill(QColor(0, 255, 0));
    return image;
}

TEST_F(HeadsetPanelTest, NamesArePatientDataAndOffAtEachStart) {
    HeadsetMirror mirror;
    mirror.resize(400, 400);
    mirror.show();
    mirror.setNames(QStringLiteral("DOE, JANE"));
    auto* names = mirror.findChild<QCheckBox*>(QStringLiteral("headset-names"));
    auto* text = mirror.findChild<QLabel*>(QStringLiteral("headset-patient"));
    ASSERT_TRUE(names && text);
    EXPECT_FALSE(names->isChecked());
    EXPECT_FALSE(text->isVisible());
    EXPECT_EQ(text->text(), QString()) << "not even where a reader of screens finds it";
    names->setChecked(true);
    EXPECT_EQ(text->text(), QStringLiteral("DOE, JANE"));
    EXPECT_TRUE(text->isVisible());
    mirror.setRunning(true);
    EXPECT_FALSE(names->isChecked());
    EXPECT_EQ(text->text(), QString());
}

TEST_F(HeadsetPanelTest, ThePictureKeepsItsShapeAndGoesWithTheSession) {
    HeadsetMirror mirror;
    mirror.resize(400, 400);
    mirror.show();
    settle();
    auto* shown = mirror.findChild<QWidget*>(QStringLiteral("headset-picture"));
    ASSERT_TRUE(shown);
    const auto isGreenAt = [&](double x, double y) {
        const QImage seen = shown->grab().toImage();
        const QColor colour = seen.pixelColor(int(x * (seen.width() - 1)), int(y * (seen.height() - 1)));
        return colour.green() > 200 && colour.red() < 50;
    };
    mirror.setPicture(green());
    EXPECT_FALSE(isGreenAt(0.5, 0.5)) << "no session, no picture";
    mirror.setRunning(true);
    mirror.setPicture(green());
    EXPECT_TRUE(isGreenAt(0.5, 0.5));
    EXPECT_FALSE(isGreenAt(0.5, 0.02)) << "twice as wide as high: black above";
    mirror.setRunning(false);
    EXPECT_FALSE(isGreenAt(0.5, 0.5));
}

TEST_F(HeadsetPanelTest, OneButtonStartsAndStops) {
    HeadsetMirror mirror;
    auto* button = mirror.findChild<QPushButton*>(QStringLiteral("headset-button"));
    ASSERT_TRUE(button);
    int started = 0;
    int stopped = 0;
    QObject::connect(&mirror, &HeadsetMirror::startAsked, &mirror, [&] { ++started; });
    QObject::connect(&mirror, &HeadsetMirror::stopAsked, &mirror, [&] { ++stopped; });
    button->click();
    mirror.setRunning(true);
    button->click();
    EXPECT_EQ(started, 1);
    EXPECT_EQ(stopped, 1);
    EXPECT_FALSE(button->toolTip().isEmpty());
}

TEST_F(HeadsetPanelTest, WithoutARuntimeASentenceIsSaidAndTheWindowGoesOn) {
    setenv("XR_RUNTIME_JSON", "/nonexistent/runtime.json", 1);
    HeadsetShow show(nullptr);
    std::vector<Error> errors;
    int ended = 0;
    QObject::connect(&show, &HeadsetShow::failed, &show, [&](const Error& e) { errors.push_back(e); });
    QObject::connect(&show, &HeadsetShow::ended, &show, [&] { ++ended; });
    for (int attempt = 1; attempt <= 2; ++attempt) {
        show.start({.volume = smallStudy().volume, .drawing = {}, .presets = {}, .pictures = {}});
        ASSERT_TRUE(waitUntil([&] { return ended == attempt; }));
        ASSERT_EQ(errors.size(), std::size_t(attempt));
        EXPECT_EQ(errors.back().code, ErrorCode::deviceNotUsable);
        EXPECT_TRUE(errors.back().message.english().ends_with('.')) << errors.back().message;
        EXPECT_FALSE(errors.back().hint.empty());
        EXPECT_FALSE(show.isRunning());
    }
    unsetenv("XR_RUNTIME_JSON");
}

TEST(HeadsetOption, IsOfTheCommandLine) {
    const auto line = parseCommandLine({QStringLiteral("macula-viewer"), QStringLiteral("--xr")});
    ASSERT_TRUE(line.ok());
    EXPECT_TRUE(line->showsInHeadset);
    EXPECT_FALSE(parseCommandLine({QStringLiteral("macula-viewer")})->showsInHeadset);
    EXPECT_FALSE(parseCommandLine({QStringLiteral("macula-viewer"), QStringLiteral("--xr"),
                                   QStringLiteral("--script"), QStringLiteral("orbit")})
                     .ok());
}

}  // namespace
}  // namespace macula::viewer
