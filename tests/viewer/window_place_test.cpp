// A window comes back where it was left, and never where nobody can see it.
#include "viewer/settings/window_place.h"

#include <QScreen>
#include <QWidget>

#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

class WindowPlaceTest : public test::OffscreenTest {
  protected:
    static QString placeOf(const QRect& geometry) {
        QString kept;
        QWidget window;
        new WindowPlace(window, [&](const QString& place) { kept = place; });
        window.setGeometry(geometry);
        window.show();
        settle();
        window.close();
        return kept;
    }
};

TEST_F(WindowPlaceTest, ComesBackAsItWasLeft) {
    const QRect left(60, 80, 500, 400);
    QWidget again;
    ASSERT_TRUE(placeWindow(again, placeOf(left)));
    EXPECT_EQ(again.geometry(), left);
}

TEST_F(WindowPlaceTest, OfAScreenThatIsGoneItIsOnOneThatIsThere) {
    const QRect screen = QGuiApplication::primaryScreen()->availableGeometry();
    for (const QRect& left : {QRect(9000, 7000, 500, 400), QRect(-4000, -3000, 640, 480),
                              QRect(100, 100, 20000, 9000), QRect(screen.right() - 20, 50, 500, 400)}) {
        QWidget again;
        ASSERT_TRUE(placeWindow(again, placeOf(left)));
        EXPECT_TRUE(screen.contains(again.geometry()))
            << again.x() << " " << again.y() << " " << again.width() << " " << again.height();
        EXPECT_GE(again.width(), 100);
    }
}

TEST_F(WindowPlaceTest, ATextThatIsNoPlaceMovesNothing) {
    QWidget window;
    window.resize(321, 123);
    for (const char* text : {"", "AAEC", "no base 64!", "AdnQywAD"})
        EXPECT_FALSE(placeWindow(window, QString::fromLatin1(text))) << text;
    EXPECT_EQ(window.size(), QSize(321, 123));
}

}  // namespace
}  // namespace macula::viewer
