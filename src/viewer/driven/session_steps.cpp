#include "viewer/driven/session_steps.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QSlider>
#include <QTabWidget>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "scene/camera/picture_rays.h"
#include "scene/clip/kept_box.h"
#include "viewer/clip/scissor_tool.h"
#include "viewer/panes/pane_grid.h"
#include "viewer/slices/slice_view.h"

namespace macula::viewer {

namespace {

constexpr double kHandPixelsOfTurn = 1200.0;  // once around the patient
constexpr double kSwayPixels = 60.0;          // up and down
constexpr int kGalleryMs = 6'000;             // most of its small pictures are made by then
constexpr int kLookMs = 600;
constexpr int kPageMs = 150;
constexpr double kSlabMm = 20.0;
constexpr int kSizeWithinPx = 8;
constexpr int kResizedWithinMs = 500;

class SessionSteps {
  public:
    SessionSteps(MainWindow& window, DrivenHand& hand, OrbitGauge& orbit, const WorkdaySteps& work)
        : window_(window), hand_(hand), orbit_(orbit), work_(work) {}

    std::vector<DrivenStep> all() {
        addOrbit();
        addSlices();
        addBrowser();
        addGallery();
        addTransfer();
        addClip();
        addScissors();
        addSegments();
        addQuality();
        addDialogs();
        addEnd();
        return std::move(steps_);
    }

  private:
    DrivenStep& add(const char* name, std::function<void()> begin, std::function<bool()> isDone = {},
                    int restMs = 150) {
        DrivenStep step;
        step.name = QString::fromLatin1(name);
        step.begin = std::move(begin);
        step.isDone = std::move(isDone);
        step.restMs = restMs;
        steps_.push_back(std::move(step));
        return steps_.back();
    }
    // Done once the hand is at rest again.
    DrivenStep& addByHand(const char* name, std::function<void()> begin, int restMs = 150) {
        DrivenHand* hand = &hand_;
        return add(
            name, std::move(begin), [hand] { return !hand->isBusy(); }, restMs);
    }
    void addOrbit() {
        // The pane is what is left of the window: it comes to the size wanted in a few attempts, each of
        // which the window system has to answer.
        auto asked = std::make_shared<QElapsedTimer>();
        add("3D picture to its size", {}, [&window = window_, work = work_, asked] {
            const QSize missing = work.volumePixels - window.viewport().pictureSize();
            if (std::abs(missing.width()) <= kSizeWithinPx && std::abs(missing.height()) <= kSizeWithinPx)
                return true;
            if (asked->isValid() && asked->elapsed() < kResizedWithinMs) return false;
            asked->start();
            const double ratio = window.viewport().window().devicePixelRatio();
            const QSize more(int(std::lround(2.0 * missing.width() / ratio)),
                             int(std::lround(2.0 * missing.height() / ratio)));
            window.resize(window.size() + more);
            return false;
        }).patienceMs = 8'000;
        addByHand(
            "orbit",
            [&window = window_, &hand = hand_, &orbit = orbit_, work = work_] {
                VulkanWindow& target = window.viewport().window();
                const QPointF grip = DrivenHand::middleOf(target);
                DrivenHand::Drag drag;
                drag.target = &target;
                drag.lastsMs = int(work.orbitSeconds * 1000.0);
                drag.path = [grip, turns = work.orbitSeconds / work.turnSeconds](double share) {
                    const double sway = kSwayPixels * std::sin(4.0 * std::numbers::pi * turns * share);
                    return grip + QPointF(kHandPixelsOfTurn * turns * share, sway);
                };
                orbit.begin();
                hand.drag(std::move(drag));
            },
            0)
            .patienceMs = int(work_.orbitSeconds * 1000.0) + 10'000;
        add(
            "rest after the orbit", [&orbit = orbit_] { orbit.end(); }, {}, 1'500);
    }

    void addSlices() {
        const auto axial = [&window = window_]() -> SliceView& {
            return window.slices(slices::Orientation::axial);
        };
        addByHand(
            "slices by wheel", [axial, &hand = hand_] { hand.turnWheel(axial(), 30); }, 400);
        addByHand("cross-hair", [axial, &hand = hand_] {
            const QPointF middle = DrivenHand::middleOf(axial());
            hand.drag(axial(), middle, middle + QPointF(60, 40));
        });
        addByHand("window", [axial, &hand = hand_] {
            const QPointF middle = DrivenHand::middleOf(axial());
            hand.drag(axial(), middle, middle + QPointF(80, -50), Qt::RightButton);
        });
        addByHand("distance", [axial, &hand = hand_] {
            hand.trigger("slice-tool-distance");
            const QPointF middle = DrivenHand::middleOf(axial());
            hand.drag(axial(), middle - QPointF(50, 20), middle + QPointF(50, 20));
        });
        addByHand("ellipse", [axial, &hand = hand_] {
            hand.trigger("slice-tool-ellipse");
            const QPointF middle = DrivenHand::middleOf(axial());
            hand.drag(axial(), middle - QPointF(30, 60), middle + QPointF(30, -10));
        });
        add("tool put down", [&hand = hand_] { hand.trigger("slice-tool-crosshair"); });
        const auto slab = [&hand = hand_](const char* kind, double mm) {
            hand.trigger(kind);
            if (auto* thickness = hand.find<QDoubleSpinBox>("slab-thickness")) thickness->setValue(mm);
        };
        add(
            "slab", [slab] { slab("slab-maximum", kSlabMm); }, {}, kLookMs);
        add("no slab", [slab] { slab("slab-mean", 0.0); });
        add(
            "axial alone", [&hand = hand_] { hand.press(Qt::Key_F7); }, {}, kLookMs);
        add(
            "four panes", [&window = window_] { window.panes().maximize(Pane::axial); }, {}, kLookMs);
    }

    void addBrowser() {
        add(
            "studies shown", [&hand = hand_] { showPanel(hand, "studies-panel", true); }, {}, 1'500);
        add(
            "studies searched",
            [&hand = hand_] {
                if (auto* search = hand.find<QLineEdit>("search")) hand.type(*search, QStringLiteral("ct"));
            },
            {}, kLookMs);
        add("search ended", [&hand = hand_] {
            if (auto* search = hand.find<QLineEdit>("search")) hand.press(*search, Qt::Key_Escape);
        });
        add("studies by keys", [&hand = hand_] {
            auto* tree = hand.find<QAbstractItemView>("studies");
            for (int n = 0; tree != nullptr && n < 6; ++n)
                hand.press(*tree, n < 3 ? Qt::Key_Down : Qt::Key_Up);
        });
        add("studies hidden", [&hand = hand_] { showPanel(hand, "studies-panel", false); });
    }

    void addGallery() {
        add(
            "presets shown", [&hand = hand_] { showPanel(hand, "presets-panel", true); }, {}, kGalleryMs);
        add(
            "preset by keys",
            [&hand = hand_] {
                auto* list = hand.find<QAbstractItemView>("presets");
                if (list == nullptr) return;
                for (int n = 0; n < 3; ++n) hand.press(*list, Qt::Key_Down);
                hand.press(*list, Qt::Key_Return);
            },
            {}, 2'000);
        add(
            "presets searched",
            [&hand = hand_] {
                if (auto* filter = hand.find<QLineEdit>("preset-filter"))
                    hand.type(*filter, QStringLiteral("bone"));
            },
            {}, kLookMs);
        add("presets hidden", [&hand = hand_] { showPanel(hand, "presets-panel", false); });
    }

    void addTransfer() {
        add(
            "transfer function shown", [&hand = hand_] { showPanel(hand, "transfer-panel", true); }, {},
            kLookMs);
        addByHand(
            "curve shifted",
            [&hand = hand_] {
                auto* curve = hand.find<QWidget>("transfer-curve");
                if (curve == nullptr) return;
                const QPointF middle = DrivenHand::middleOf(*curve);
                hand.drag(*curve, middle, middle + QPointF(30, 10), Qt::RightButton);
            },
            kLookMs);
        addByHand(
            "curve shifted in 3D",
            [&window = window_, &hand = hand_] {
                VulkanWindow& target = window.viewport().window();
                const QPointF middle = DrivenHand::middleOf(target);
                hand.drag(target, middle, middle + QPointF(40, 15), Qt::RightButton, Qt::AltModifier);
            },
            kLookMs);
        add("transfer function hidden", [&hand = hand_] { showPanel(hand, "transfer-panel", false); });
    }

    void addClip() {
        add(
            "clip shown", [&hand = hand_] { showPanel(hand, "clip-panel", true); }, {}, kLookMs);
        add(
            "face by keys",
            [&hand = hand_] {
                auto* slider = hand.find<QSlider>("clip-slider-left");
                for (int n = 0; slider != nullptr && n < 10; ++n) hand.press(*slider, Qt::Key_Left);
            },
            {}, kLookMs);
        add("picture with handles", {}, [&window = window_] {
            return window.viewport().isCameraOnScreen();
        }).patienceMs = 5'000;
        addByHand(
            "handle in 3D", [&window = window_, &hand = hand_] { dragFace(window, hand); }, kLookMs);
        add("clip hidden", [&hand = hand_] { showPanel(hand, "clip-panel", false); });
        add(
            "no clip", [&hand = hand_] { hand.press(Qt::Key_U, Qt::ControlModifier); }, {}, kLookMs);
    }

    // From the middle of the patient's left side towards the middle of the volume.
    static void dragFace(MainWindow& window, DrivenHand& hand) {
        const auto& volume = window.session().study().volume;
        const PictureGeometry picture = window.viewport().geometry();
        const auto rays = scene::PictureRays::of(picture.camera, picture.aspect);
        if (!volume || !rays) return;
        const Box box = volume->worldBox();
        glm::dvec3 face = box.centre();
        const auto kept = scene::keptBox(window.session().state().clip, *volume);
        face.x = kept ? kept->high.x : box.high.x;
        const auto from = rays->placeOf(face);
        const auto to = rays->placeOf(glm::mix(face, box.centre(), 0.4));
        if (!from || !to) return;
        VulkanWindow& target = window.viewport().window();
        const auto pixels = [&](const glm::dvec2& place) {
            return QPointF(0.5 * (place.x + 1.0) * target.width(), 0.5 * (1.0 - place.y) * target.height());
        };
        hand.drag(target, pixels(*from), pixels(*to));
    }

    void addScissors() {
        add("picture before scissors", {}, [&window = window_] {
            return window.viewport().isCameraOnScreen();
        }).patienceMs = 5'000;
        addByHand("scissors", [&window = window_, &hand = hand_] {
            hand.press(Qt::Key_X);
            hand.dragAround(window.viewport().window(), 0.15);
        });
        add(
            "voxels cut", {}, [&window = window_] { return !window.cutting(); }, kLookMs);
        add(
            "cut undone", [&hand = hand_] { hand.trigger("undo"); },
            [&window = window_] { return !window.cutting(); }, kLookMs);
        add("scissors put away", [&window = window_, &hand = hand_] {
            if (window.scissors().isOut()) hand.press(Qt::Key_X);
        });
    }

    void addSegments() {
        add(
            "segments shown", [&hand = hand_] { showPanel(hand, "segments-panel", true); }, {}, 1'500);
        add("segments hidden", [&hand = hand_] { showPanel(hand, "segments-panel", false); });
    }

    void addQuality() {
        const auto orbits = [&window = window_, &hand = hand_] {
            VulkanWindow& target = window.viewport().window();
            const QPointF middle = DrivenHand::middleOf(target);
            hand.drag(target, middle, middle + QPointF(150, 20));
        };
        add("quality: fast", [&hand = hand_] {
            for (int n = 0; n < 8; ++n) hand.press(Qt::Key_BracketLeft, Qt::ControlModifier);
        });
        addByHand("orbit, fast", orbits, kLookMs);
        add("quality: accurate", [&hand = hand_] {
            for (int n = 0; n < 8; ++n) hand.press(Qt::Key_BracketRight, Qt::ControlModifier);
        });
        addByHand("orbit, accurate", orbits, kLookMs);
        add("quality: automatic", [&hand = hand_] {
            auto* automatic = hand.find<QAbstractButton>("quality-automatic");
            if (automatic != nullptr && !automatic->isChecked()) automatic->click();
        });
    }

    void addDialogs() {
        add(
            "settings shown", [&hand = hand_] { hand.trigger("settings"); }, {}, kLookMs);
        add(
            "pages of settings",
            [&hand = hand_] {
                auto* pages = hand.find<QTabWidget>("settings-pages");
                for (int n = 0; pages != nullptr && n < pages->count(); ++n)
                    QTimer::singleShot(n * kPageMs, pages, [pages, n] { pages->setCurrentIndex(n); });
            },
            {}, 5 * kPageMs);
        addClosing("settings closed");
        add(
            "picture to save", [&hand = hand_] { hand.trigger("save-picture"); }, {}, kLookMs);
        addClosing("picture not saved");
        add(
            "names hidden", [&hand = hand_] { hand.press(Qt::Key_N); }, {}, kLookMs);
        add("names shown", [&hand = hand_] { hand.press(Qt::Key_N); });
    }

    void addClosing(const char* name) {
        add(name, [&window = window_] {
            for (auto* dialog : window.findChildren<QDialog*>()) {
                if (dialog->isVisible()) dialog->reject();
            }
        });
    }

    void addEnd() {
        add(
            "undo and redo",
            [&hand = hand_] {
                for (int n = 0; n < 5; ++n) hand.trigger("undo");
                for (int n = 0; n < 5; ++n) hand.trigger("redo");
            },
            {}, kLookMs);
        add(
            "as when first opened", [&hand = hand_] { hand.trigger("show-afresh"); }, {}, 3'000);
    }

    MainWindow& window_;
    DrivenHand& hand_;
    OrbitGauge& orbit_;
    const WorkdaySteps work_;
    std::vector<DrivenStep> steps_;
};

}  // namespace

std::vector<DrivenStep> sessionSteps(MainWindow& window, DrivenHand& hand, OrbitGauge& orbit,
                                     const WorkdaySteps& work) {
    return SessionSteps(window, hand, orbit, work).all();
}

void showPanel(DrivenHand& hand, const char* name, bool shown) {
    const auto* dock = hand.find<QDockWidget>(name);
    if (dock != nullptr && dock->toggleViewAction()->isChecked() != shown)
        dock->toggleViewAction()->trigger();
}

}  // namespace macula::viewer
