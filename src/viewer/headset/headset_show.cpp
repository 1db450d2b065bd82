#ifdef MACULA_HAS_XR
#include "xr/study_in_headset.h"  // before Qt, see vulkan_window.h

#include "viewer/headset/headset_words.h"
#endif

#include "viewer/headset/headset_show.h"

#include <exception>
#include <mutex>
#include <optional>
#include <utility>

#include "viewer/jobs/newest_posted.h"
#include "viewer/jobs/post.h"
#include "viewer/language/window_language.h"

namespace macula::viewer {

// Shared by the UI thread and the headset's thread.
struct HeadsetShow::Shared {
    std::mutex mutex;
    std::optional<HeadsetSelection> wanted;  // the window's last choice that the headset has not taken
};

#ifdef MACULA_HAS_XR

namespace {

// What the room reports; each call passes it on to the UI thread.
struct Told {
    NewestPosted<QImage> mirror;
    NewestPosted<HeadsetSelection> chosen;
    std::function<void(const std::string&)> note;
};

QImage imageOf(const xr::EyeView& view) {
    const QImage lent(view.rgba.data(), view.sizePx.x, view.sizePx.y, view.sizePx.x * 4,
                      QImage::Format_RGBX8888);
    return lent.copy();
}

Result<Text> showIn(HeadsetShowRequest request, xr::RoomWords words, const Told& told,
                    std::function<std::optional<HeadsetSelection>()> wanted, Progress& progress) {
    xr::RoomScene scene;
    scene.volume = in16Bits(request.volume);
    scene.drawing = std::move(request.drawing);
    xr::RoomHost host;
    host.presets = std::move(request.presets);
    host.words = std::move(words);
    host.pictures = std::move(request.pictures);
    host.note = told.note;
    host.mirror = [&told](const xr::EyeView& view) { told.mirror(imageOf(view)); };
    host.changed = [&told](const xr::RoomState& state) {
        told.chosen({.transferFunction = state.transferFunction, .clip = state.clip});
    };
    host.wanted = [wanted = std::move(wanted)]() -> std::optional<xr::RoomState> {
        const auto choice = wanted();
        if (!choice) return std::nullopt;
        xr::RoomState state;
        state.transferFunction = choice->transferFunction;
        state.clip = choice->clip;
        return state;
    };
    MACULA_TRY(const xr::HeadsetFigures figures, xr::showScene(std::move(scene), std::move(host), progress));
    return xr::textOf(figures);
}

}  // namespace

#endif

HeadsetShow::HeadsetShow(QObject* parent)
    : QObject(parent),
      job_(this, {.ended =
                      [this](const Result<Text>& outcome) {
                          if (!outcome) Q_EMIT failed(outcome.error());
                          Q_EMIT ended(outcome ? inWindowsLanguage(*outcome) : QString());
                      }}),
      shared_(std::make_shared<Shared>()) {}

HeadsetShow::~HeadsetShow() {
    token_.cancel();
}

void HeadsetShow::stop() {
    token_.cancel();
}

void HeadsetShow::abandon() {
    isAbandoned_ = true;
    stop();
}

void HeadsetShow::propose(HeadsetSelection choice) {
    if (isAbandoned_) return;
    const std::lock_guard lock(shared_->mutex);
    shared_->wanted = std::move(choice);
}

void HeadsetShow::start([[maybe_unused]] HeadsetShowRequest request) {
    if (isRunning()) return;
    token_ = CancelToken();
    isAbandoned_ = false;
    shared_ = std::make_shared<Shared>();
#ifdef MACULA_HAS_XR
    const auto told = std::make_shared<Told>(
        Told{.mirror = NewestPosted<QImage>(this, [this](const QImage& image) { Q_EMIT mirrored(image); }),
             .chosen = NewestPosted<HeadsetSelection>(this,
                                                      [this](const HeadsetSelection& choice) {
                                                          if (!isAbandoned_) Q_EMIT chosen(choice);
                                                      }),
             .note = [this](const std::string& sentence) {
                 post(this, [this, sentence] { Q_EMIT noted(QString::fromStdString(sentence)); });
             }});
    const auto wanted = [shared = shared_]() -> std::optional<HeadsetSelection> {
        const std::lock_guard lock(shared->mutex);
        return std::exchange(shared->wanted, std::nullopt);
    };
    const xr::RoomWords words = headsetWords(request.presets);
    // Uses its own token, because cancelling job_ would suppress `ended`, which must follow stop().
    job_.start([request = std::move(request), words, told, wanted,
                token = token_](Progress&) mutable -> Result<Text> {
        Progress progress({}, token);
        try {
            return showIn(std::move(request), words, *told, wanted, progress);
        } catch (const std::exception&) {
            return Error{ErrorCode::outOfMemory,
                         Text("There is not enough memory for the headset."),
                         {},
                         Text("Close other programs.")};
        }
    });
#else
    job_.start([](Progress&) -> Result<Text> {
        return Error{ErrorCode::deviceNotUsable,
                     Text("This build of Macula knows no headsets."),
                     {},
                     Text("Build it with the package libopenxr-dev installed.")};
    });
#endif
    Q_EMIT began();
}

}  // namespace macula::viewer
