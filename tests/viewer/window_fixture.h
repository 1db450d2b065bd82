// A main window on a display, in this process.
#pragma once

#include "viewer/window/main_window.h"  // before Qt, see vulkan_window.h

#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QImage>
#include <QMouseEvent>
#include <QPixmap>
#include <QScreen>
#include <QSet>
#include <QThread>
#include <memory>
#include <optional>
#include <vector>

#include "gpu/lose_device.h"
#include "viewer/display.h"
#include "viewer/overlay/painted_text.h"
#include "viewer/wait_until.h"

namespace macula::viewer {

class WindowTest : public testing::Test {
  protected:
    void SetUp() override {
        if (const std::string why = test::ensureDisplay(); !why.empty()) GTEST_SKIP() << why;
        application_.emplace(argc_, argv_);
        makeWindow();
    }
    void makeWindow() {
        auto instance = createInstanceForWindows();
        if (!instance) FAIL() << "packaging/bootstrap installs a Vulkan driver: " << instance.error().message;
        window_.emplace(*std::move(instance), windowOptions());
        QObject::connect(&*window_, &MainWindow::frameShown, &*window_,
                         [this](const live::FrameShown& frame) {
                             last_ = frame;
                             ++frames_;
                         });
        window_->show();
    }
    MainWindowOptions windowOptions() const {
        MainWindowOptions options{.catalogue = scene::builtInCatalogue().value()};
        // Not used for CT; and refused by the device's side of the program for all else.
        if (refusesRaw_)
            options.preset = std::make_shared<const TransferFunction>(
                TransferFunction{.name = "empty", .unit = Unit::raw});
        options.layout = layout_;
        options.pictureSize = QSize(320, 240);
        options.firstView = firstView_;
        options.sampleLimit = 2;
        options.usesModel = usesModel_;
        options.sessions = sessions_;
        options.settings = settings_;
        options.watchPace = watchPace_;
        options.showsInHeadset = showsInHeadset_;
        return options;
    }
    void TearDown() override {
        macula::test::loseDeviceAt(macula::test::VulkanCall::submit, 1, 0);
        window_.reset();
        application_.reset();
    }

    static study::OpenedStudy smallStudy(Unit unit) {
        auto volume = Volume::create({.size = glm::ivec3(8), .unit = unit, .modality = "CT"},
                                     std::vector<std::uint16_t>(512, 1000));
        return {.volume = std::make_shared<const Volume>(*std::move(volume)),
                .identity = {.series = Text("Second"), .isOfNobody = true},
                .description = Text("Second")};
    }
    static study::OpenedStudy studyThatCannotBeShown() { return smallStudy(Unit::raw); }
    // What a person sees there.
    QImage middle() {
        VulkanWindow& target = window_->viewport().window();
        const QPoint corner = target.mapToGlobal(QPoint(target.width() / 4, target.height() / 4));
        return target.screen()
            ->grabWindow(0, corner.x(), corner.y(), target.width() / 2, target.height() / 2)
            .toImage();
    }
    // Of the whole picture, in device pixels.
    QImage picture() {
        VulkanWindow& target = window_->viewport().window();
        const QPoint corner = target.mapToGlobal(QPoint(0, 0));
        return target.screen()
            ->grabWindow(0, corner.x(), corner.y(), target.width(), target.height())
            .toImage();
    }
    // Whether exactly this stands over the picture.
    static bool isNamed(const QImage& picture, const study::Identity& identity, std::size_t mostLines = 4) {
        std::vector<std::string> lines;
        for (const Text& line : linesOf(identity)) lines.push_back(line.english());
        lines.resize(std::min(lines.size(), mostLines));
        const auto text = paintText({.names = lines}, picture.size(), 1.0);
        for (const VkRect2D& box : text->boxes) {
            for (int y = box.offset.y; y < box.offset.y + int(box.extent.height); ++y) {
                for (int x = box.offset.x; x < box.offset.x + int(box.extent.width); ++x) {
                    const std::byte* wanted =
                        &text->rgba[4 * (std::size_t(y) * text->size.width + std::size_t(x))];
                    const QRgb is = picture.pixel(x, y);
                    if (qRed(is) != int(wanted[0]) || qGreen(is) != int(wanted[1]) ||
                        qBlue(is) != int(wanted[2]))
                        return false;
                }
            }
        }
        return true;
    }
    qsizetype coloursInTheMiddle() {
        const QImage picture = middle();
        QSet<QRgb> colours;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) colours.insert(picture.pixel(x, y));
        }
        return colours.size();
    }

    bool waitForConverged() {
        last_.reset();
        return waitUntil([&] { return last_ && last_->stage == live::Stage::converged; });
    }
    void sendMouse(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons held) {
        VulkanWindow& target = window_->viewport().window();
        QMouseEvent event(type, at, target.mapToGlobal(at), button, held, Qt::NoModifier);
        QCoreApplication::sendEvent(&target, &event);
    }
    void pressKey(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QKeyEvent event(QEvent::KeyPress, key, modifiers);
        QCoreApplication::sendEvent(&window_->viewport().window(), &event);
    }

    bool refusesRaw_ = true;  // what is no CT cannot be shown
    scene::Layout layout_ = scene::Layout::volume;
    std::optional<ViewDirection> firstView_ = ViewDirection::anterior;  // nothing: as programs do
    bool showsInHeadset_ = false;
    bool usesModel_ = false;  // to search for one takes seconds: for tests that are about it
    Settings settings_;
    WatchPace watchPace_;
    std::optional<std::filesystem::path> sessions_;  // where models and states are kept; nothing: nowhere
    int argc_ = 1;
    char name_[5] = "test";
    char* argv_[2] = {name_, nullptr};
    std::optional<QApplication> application_;
    std::optional<MainWindow> window_;
    std::optional<live::FrameShown> last_;
    int frames_ = 0;
};

}  // namespace macula::viewer
