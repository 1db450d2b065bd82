// The look of a dark room: what is written can be read, and what can be used can be seen.
#include "viewer/theme/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFontDatabase>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>
#include <QStyleOption>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "viewer/offscreen.h"
#include "viewer/overlay/painted_text.h"
#include "viewer/status/status_widgets.h"
#include "viewer/theme/theme_style.h"

namespace macula::viewer {
namespace {

constexpr double kLeastForText = 7.0;
constexpr double kLeastForLines = 3.0;

// WCAG 2.1, relative luminance and contrast ratio.
double luminance(QRgb colour) {
    const auto linear = [](int value) {
        const double share = value / 255.0;
        return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(qRed(colour)) + 0.7152 * linear(qGreen(colour)) + 0.0722 * linear(qBlue(colour));
}
double contrast(QRgb a, QRgb b) {
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

const ThemeColours* const kThemes[] = {&kDarkColours, &kHighContrastColours};

TEST(ThemeColours, ContrastIsThatOfTheStandard) {
    EXPECT_NEAR(contrast(0x000000, 0xffffff), 21.0, 1e-9);
    EXPECT_NEAR(contrast(0xffffff, 0x767676), 4.54, 0.005);
    EXPECT_NEAR(contrast(0x0000ff, 0xffffff), 8.59, 0.005);
    EXPECT_EQ(contrast(0x123456, 0x123456), 1.0);
}

TEST(ThemeColours, TextAndLinesStandOutInBothThemes) {
    for (const ThemeColours* theme : kThemes) {
        const char* name = theme == &kDarkColours ? "dark: " : "high contrast: ";
        for (const ColourPair& pair : textPairs(*theme))
            EXPECT_GE(contrast(pair.front, pair.back), kLeastForText) << name << pair.what;
        for (const ColourPair& pair : linePairs(*theme))
            EXPECT_GE(contrast(pair.front, pair.back), kLeastForLines) << name << pair.what;
    }
    for (const ColourPair& pair : textPairs(kHighContrastColours))
        EXPECT_GE(contrast(pair.front, pair.back), 8.0) << pair.what;
}

TEST(ThemeColours, NothingIsBrightInTheDark) {
    for (const QRgb ground : {kDarkColours.window, kDarkColours.field, kDarkColours.button, kDarkColours.tip,
                              kDarkColours.selection, kDarkColours.error, kDarkColours.note})
        EXPECT_LT(luminance(ground), 0.1);
}

TEST(ThemeOptions, AScaleOutOfRangeIsTakenAsTheNearest) {
    const auto scale = [](double asked) { return usable({.fontScale = asked}).fontScale; };
    EXPECT_EQ(scale(1.25), 1.25);
    EXPECT_EQ(scale(0.0), kSmallestFontScale);
    EXPECT_EQ(scale(std::numeric_limits<double>::infinity()), kLargestFontScale);
    EXPECT_EQ(scale(std::numeric_limits<double>::quiet_NaN()), 1.0);
    EXPECT_TRUE(usable({.highContrast = true}).highContrast);
}

class ThemeTest : public test::OffscreenTest {
  protected:
    void TearDown() override {
        if (application_) applyTheme(*application_, {});
        OffscreenTest::TearDown();
    }
    static int count(const QImage& image, QRgb colour) {
        int found = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) found += (image.pixel(x, y) & 0xffffff) == colour ? 1 : 0;
        }
        return found;
    }
    static int seenBeside(const QImage& image, QRgb ground) {
        int found = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x)
                found += contrast(image.pixel(x, y), ground) >= kLeastForLines ? 1 : 0;
        }
        return found;
    }
    static int count(QWidget& widget, QRgb colour) { return count(widget.grab().toImage(), colour); }
    static QImage drawn(const QStyle& style, QStyle::PrimitiveElement element, QStyle::State state) {
        QImage image(16, 16, QImage::Format_RGB32);
        image.fill(kDarkColours.window);
        QPainter painter(&image);
        QStyleOptionButton option;
        option.rect = image.rect();
        option.state = state;
        style.drawPrimitive(element, &option, &painter);
        return image;
    }
};

// Who needs large letters needs them for names and measurements above all; none becomes smaller than its own.
TEST_F(ThemeTest, LettersOverPicturesGrowToo) {
    const auto heightOfName = [] {
        return paintText({.names = {"A name"}}, QSize(1000, 600), 1.0)->size.height;
    };
    applyTheme(*application_, {});
    EXPECT_EQ(fontScaleOverPictures(), 1.0);
    const auto height = heightOfName();
    applyTheme(*application_, {.fontScale = 2.0});
    EXPECT_EQ(fontScaleOverPictures(), 2.0);
    EXPECT_GT(heightOfName(), 1.5 * height);
    applyTheme(*application_, {.fontScale = kSmallestFontScale});
    EXPECT_EQ(fontScaleOverPictures(), 1.0);
    EXPECT_EQ(heightOfName(), height);
}

// Arrows of what a narrow window hides of its bars.
TEST_F(ThemeTest, WhatABarHidesCanBeFound) {
    for (const ThemeColours* theme : kThemes) {
        const ThemeStyle style(*theme, 1.0);
        std::vector<QImage> arrows;
        for (const auto which :
             {QStyle::SP_ToolBarHorizontalExtensionButton, QStyle::SP_ToolBarVerticalExtensionButton}) {
            QImage image(16, 16, QImage::Format_RGB32);
            image.fill(theme->window);
            QPainter painter(&image);
            painter.drawPixmap(image.rect(), style.standardIcon(which).pixmap(QSize(16, 16)));
            painter.end();
            EXPECT_GT(seenBeside(image, theme->window), 15);
            arrows.push_back(image);
        }
        EXPECT_NE(arrows[0], arrows[1]) << "one shows to the right, one downwards";
    }
}

// What widgets are drawn with, and not only the table.
TEST_F(ThemeTest, ThePaletteStandsOutInAllStates) {
    using Pal = QPalette;
    const std::pair<Pal::ColorRole, Pal::ColorRole> pairs[] = {
        {Pal::WindowText, Pal::Window},       {Pal::Text, Pal::Base},
        {Pal::Text, Pal::AlternateBase},      {Pal::ButtonText, Pal::Button},
        {Pal::ToolTipText, Pal::ToolTipBase}, {Pal::HighlightedText, Pal::Highlight},
        {Pal::PlaceholderText, Pal::Base},    {Pal::Link, Pal::Window},
        {Pal::LinkVisited, Pal::Base}};
    for (const bool high : {false, true}) {
        applyTheme(*application_, {.highContrast = high});
        const QPalette palette = QApplication::palette();
        EXPECT_EQ(&themeColours(), high ? &kHighContrastColours : &kDarkColours);
        EXPECT_EQ(palette.color(Pal::Window).rgb() & 0xffffff, themeColours().window);
        for (const auto& [front, back] : pairs) {
            for (const Pal::ColorGroup group : {Pal::Active, Pal::Inactive, Pal::Disabled}) {
                const double least = group == Pal::Disabled ? kLeastForLines : kLeastForText;
                EXPECT_GE(contrast(palette.color(group, front).rgb(), palette.color(group, back).rgb()),
                          least)
                    << int(front) << " on " << int(back) << " in " << int(group);
            }
        }
        EXPECT_NE(palette.color(Pal::Disabled, Pal::Text), palette.color(Pal::Active, Pal::Text));
    }
}

TEST_F(ThemeTest, FontsAreScaledOnceHoweverOftenAThemeIsApplied) {
    const double own = QFontDatabase::systemFont(QFontDatabase::GeneralFont).pointSizeF();
    ASSERT_GT(own, 0.0);
    for (const double scale : {1.5, 1.5, 2.0, 0.8}) {
        applyTheme(*application_, {.fontScale = scale});
        const QLabel label(QStringLiteral("text"));
        EXPECT_NEAR(QApplication::font().pointSizeF(), scale * own, 1e-6);
        EXPECT_NEAR(label.font().pointSizeF(), scale * own, 1e-6);
    }
    applyTheme(*application_, {.fontScale = 1.0});
    const QLabel label(QStringLiteral("text"));
    const int once = label.style()->pixelMetric(QStyle::PM_IndicatorWidth, nullptr, &label);
    applyTheme(*application_, {.fontScale = 2.0});
    EXPECT_EQ(label.style()->pixelMetric(QStyle::PM_IndicatorWidth, nullptr, &label), 2 * once);
}

TEST_F(ThemeTest, CheckBoxesCanBeSeenInTheDark) {
    const ThemeStyle style(kDarkColours, 1.0);
    for (const auto element : {QStyle::PE_IndicatorCheckBox, QStyle::PE_IndicatorRadioButton}) {
        const auto look = [&](QStyle::State state) { return drawn(style, element, state); };
        const QImage off = look(QStyle::State_Enabled | QStyle::State_Off);
        const QImage on = look(QStyle::State_Enabled | QStyle::State_On);
        const QImage disabled = look(QStyle::State_On);
        EXPECT_GE(seenBeside(off, kDarkColours.window), 12) << int(element);
        EXPECT_EQ(count(off, kDarkColours.accent), 0);
        EXPECT_GE(count(on, kDarkColours.accent), 24);
        EXPECT_GE(count(disabled, kDarkColours.disabledText), 24);
        EXPECT_EQ(count(disabled, kDarkColours.accent), 0);
    }
    const QImage partly =
        drawn(style, QStyle::PE_IndicatorCheckBox, QStyle::State_Enabled | QStyle::State_NoChange);
    const QImage on = drawn(style, QStyle::PE_IndicatorCheckBox, QStyle::State_Enabled | QStyle::State_On);
    EXPECT_NE(partly, on);
}

TEST_F(ThemeTest, AToolButtonThatIsOnDiffersAndASplitterShowsWhereItIsHeld) {
    const ThemeStyle style(kDarkColours, 1.0);
    const auto flat = QStyle::State_Enabled | QStyle::State_AutoRaise;
    const auto look = [&](QStyle::State state) { return drawn(style, QStyle::PE_PanelButtonTool, state); };
    EXPECT_EQ(count(look(flat), kDarkColours.window), 256);
    EXPECT_GT(count(look(flat | QStyle::State_MouseOver), kDarkColours.button), 100);
    EXPECT_GT(count(look(flat | QStyle::State_On), kDarkColours.selection), 100);
    EXPECT_GT(count(look(flat | QStyle::State_On), kDarkColours.accent), 30);
    EXPECT_EQ(count(look(QStyle::State_AutoRaise | QStyle::State_On), kDarkColours.accent), 0) << "disabled";

    const auto splitter = [&](QStyle::State state) {
        QImage image(2, 20, QImage::Format_RGB32);
        image.fill(0);
        QPainter painter(&image);
        QStyleOption option;
        option.rect = image.rect();
        option.state = QStyle::State_Enabled | state;
        style.drawControl(QStyle::CE_Splitter, &option, &painter);
        return image;
    };
    EXPECT_EQ(count(splitter(QStyle::State_None), kDarkColours.window), 40);
    EXPECT_EQ(count(splitter(QStyle::State_MouseOver), kDarkColours.accent), 40);
}

TEST_F(ThemeTest, EveryControlShowsThatItHasTheFocus) {
    for (const bool high : {false, true}) {
        applyTheme(*application_, {.highContrast = high});
        QWidget window;
        auto* column = new QVBoxLayout(&window);
        auto* tool = new QToolButton;
        tool->setText(QStringLiteral("tool"));
        tool->setFocusPolicy(Qt::TabFocus);
        auto* combo = new QComboBox;
        combo->addItem(QStringLiteral("item"));
        const std::vector<QWidget*> controls{new QPushButton(QStringLiteral("push")),
                                             tool,
                                             new QCheckBox(QStringLiteral("check")),
                                             new QRadioButton(QStringLiteral("radio")),
                                             combo,
                                             new QDoubleSpinBox,
                                             new QLineEdit,
                                             new QSlider(Qt::Horizontal)};
        for (QWidget* control : controls) column->addWidget(control);
        window.resize(240, 400);
        window.show();
        window.activateWindow();
        window.setAttribute(Qt::WA_KeyboardFocusChange);  // as after Tab
        for (QWidget* control : controls) {
            const char* name = control->metaObject()->className();
            control->clearFocus();
            EXPECT_EQ(count(*control, themeColours().accent), 0) << name;
            control->setFocus(Qt::TabFocusReason);
            ASSERT_TRUE(waitUntil([&] { return control->hasFocus(); })) << name;
            window.setAttribute(Qt::WA_KeyboardFocusChange);
            EXPECT_GE(count(*control, themeColours().accent), 24) << name;
        }
    }
}

TEST_F(ThemeTest, MessagesAndTheBadgeHaveTheirColoursFromTheTheme) {
    MessageBar bar;
    FidelityBadge badge;
    const auto edge = [&] {
        const QImage image = badge.grab().toImage();
        return image.pixel(0, image.height() / 2) & 0xffffff;
    };
    for (const bool high : {false, true, false}) {
        applyTheme(*application_, {.highContrast = high});
        bar.resize(300, 60);
        bar.showError({ErrorCode::usage, Text("What went wrong."), {}, Text("What to do.")});
        EXPECT_EQ(bar.grab().toImage().pixel(1, 1) & 0xffffff, themeColours().error);
        bar.showNote(QStringLiteral("A note."));
        EXPECT_EQ(bar.grab().toImage().pixel(1, 1) & 0xffffff, themeColours().note);
        EXPECT_EQ(bar.findChild<QLabel*>()->palette().color(QPalette::WindowText).rgb() & 0xffffff,
                  themeColours().barText);
        badge.setFidelity({.isFinal = true});
        EXPECT_EQ(edge(), themeColours().finalBadge);
        badge.setFidelity({.isFinal = false});
        EXPECT_EQ(edge(), themeColours().preliminaryBadge);
    }
    // What is on screen changes with the theme.
    applyTheme(*application_, {.highContrast = true});
    EXPECT_EQ(bar.grab().toImage().pixel(1, 1) & 0xffffff, kHighContrastColours.note);
}

}  // namespace
}  // namespace macula::viewer
