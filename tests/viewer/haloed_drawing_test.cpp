// Letters on slices are kept as pictures: they look as those that are drawn anew.
#include "viewer/overlay/haloed_drawing.h"

#include <gtest/gtest.h>

#include <QFont>
#include <QImage>
#include <QPixmapCache>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

class HaloedTextTest : public test::OffscreenTest {
  protected:
    static QFont pixels(int size) {
        QFont font;
        font.setPixelSize(size);
        return font;
    }
    // On grey.
    static QImage drawn(const QString& text, const QPointF& at, double pixelRatio,
                        const QFont& font = pixels(20), const QColor& ink = QColor(255, 240, 200),
                        double dotsPerInch = 96.0) {
        QImage image(int(260 * pixelRatio), int(60 * pixelRatio), QImage::Format_ARGB32_Premultiplied);
        image.setDevicePixelRatio(pixelRatio);
        image.setDotsPerMeterX(int(std::lround(dotsPerInch / 0.0254)));
        image.setDotsPerMeterY(int(std::lround(dotsPerInch / 0.0254)));
        image.fill(QColor(90, 90, 90));
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setFont(font);
        drawHaloedText(painter, at, text, ink);
        return image;
    }
    static int lit(const QImage& image) {
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) count += qRed(image.pixel(x, y)) > 200;
        return count;
    }
    static int dark(const QImage& image) {
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) count += qRed(image.pixel(x, y)) < 50;
        return count;
    }
};

TEST_F(HaloedTextTest, IsTheSameTheSecondTimeAndOnEachScreen) {
    QPixmapCache::clear();
    for (const double pixelRatio : {1.0, 2.0}) {
        const QImage first = drawn(QStringLiteral("W 400 L 40"), {10, 35}, pixelRatio);
        EXPECT_GT(lit(first), 100);
        EXPECT_GT(dark(first), 100) << "the halo";
        EXPECT_EQ(drawn(QStringLiteral("W 400 L 40"), {10, 35}, pixelRatio), first);
        EXPECT_NE(drawn(QStringLiteral("W 401 L 40"), {10, 35}, pixelRatio), first);
    }
    EXPECT_GT(lit(drawn(QStringLiteral("R"), {10, 35}, 2.0)),
              2 * lit(drawn(QStringLiteral("R"), {10, 35}, 1.0)));
}

// What is kept of one is never shown for another.
TEST_F(HaloedTextTest, AnotherFontColourOrScreenIsAnotherPicture) {
    QPixmapCache::clear();
    const QString text = QStringLiteral("Ap 12");
    const QImage usual = drawn(text, {10, 35}, 1.0);
    EXPECT_GT(lit(drawn(text, {10, 35}, 1.0, pixels(30))), lit(usual));
    QFont bold = pixels(20);
    bold.setBold(true);
    EXPECT_NE(drawn(text, {10, 35}, 1.0, bold), usual);
    EXPECT_EQ(lit(drawn(text, {10, 35}, 1.0, pixels(20), QColor(0, 120, 255))), 0);
    EXPECT_EQ(drawn(text, {10, 35}, 1.0), usual);
    QFont points;
    points.setPointSizeF(12.0);
    const QColor ink(255, 240, 200);
    const int once = lit(drawn(text, {10, 40}, 1.0, points, ink, 96.0));
    EXPECT_GT(lit(drawn(text, {10, 40}, 1.0, points, ink, 192.0)), 2 * once);
    EXPECT_EQ(lit(drawn(text, {10, 40}, 1.0, points, ink, 96.0)), once);
}

// Also where it begins left of its base line, between two pixels, and where nothing is to be drawn.
TEST_F(HaloedTextTest, NothingOfItIsCutOff) {
    QPixmapCache::clear();
    for (const char* text : {"jJgÄÅ", "W", "fff", "123 mm²"}) {
        QImage direct(260, 60, QImage::Format_ARGB32_Premultiplied);
        direct.fill(QColor(90, 90, 90));
        {
            QPainter painter(&direct);
            painter.setRenderHint(QPainter::Antialiasing);
            QFont font;
            font.setPixelSize(20);
            painter.setFont(font);
            // A scale of one in effect, which is drawn as a path.
            painter.setTransform(QTransform(1.0 + 1e-9, 0, 0, 1.0 + 1e-9, 0, 0));
            ASSERT_GT(painter.transform().type(), QTransform::TxTranslate);
            drawHaloedText(painter, {12, 35}, QString::fromUtf8(text), QColor(255, 240, 200));
        }
        const QImage kept = drawn(QString::fromUtf8(text), {12, 35}, 1.0);
        int worst = 0;
        for (int y = 0; y < kept.height(); ++y)
            for (int x = 0; x < kept.width(); ++x)
                worst = std::max(worst, std::abs(qGreen(kept.pixel(x, y)) - qGreen(direct.pixel(x, y))));
        EXPECT_LE(worst, 3) << text;
    }
    const QImage plain = drawn(QString(), {12, 35}, 1.0);
    EXPECT_EQ(lit(plain), 0);
    EXPECT_EQ(drawn(QStringLiteral("A"), {10.3, 35.2}, 1.0), drawn(QStringLiteral("A"), {10, 35}, 1.0));
}

}  // namespace
}  // namespace macula::viewer
