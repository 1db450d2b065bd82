#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/volume/state_controller.h"

#include <QMainWindow>
#include <QMenu>
#include <chrono>
#include <utility>

#include "live/store/study_keeper.h"
#include "scene/state/carried_view.h"
#include "study/open/same_place.h"
#include "viewer/menus/controls.h"
#include "viewer/status/status_texts.h"
#include "viewer/status/study_notes.h"
#include "viewer/volume/shown_volume.h"
#include "viewer/volume/table_removal.h"

namespace macula::viewer {

namespace {

// A killed program loses no more than this: 0.3 s of choices and measurements, 5 s of camera.
constexpr std::chrono::milliseconds kChangeKeptAfter{300};
constexpr std::chrono::milliseconds kStateKeptEvery{5000};
constexpr std::chrono::milliseconds kWorkIsKeptWithin{3000};  // a desktop that logs out waits no longer

}  // namespace

StateController::StateController(const WindowContext& context, StateOptions options,
                                 live::StudyKeeper* keeper)
    : QObject(&context.window), context_(context), options_(std::move(options)), keeper_(keeper) {
    if (!keeper_) return;
    for (QTimer* timer : {&keeps_, &keepsChange_})
        connect(timer, &QTimer::timeout, this, &StateController::keep);
    keeps_.start(kStateKeptEvery);
    keepsChange_.setSingleShot(true);
    keepsChange_.setInterval(kChangeKeptAfter);
    // A running timer is not restarted, so that states are stored during a drag, too.
    connect(&context_.session, &StudyEditor::changed, &keepsChange_, [this] {
        if (!keepsChange_.isActive()) keepsChange_.start();
    });
}

const study::OpenedStudy& StateController::study() const {
    return context_.session.study();
}

scene::StudyState StateController::state() const {
    scene::StudyState state = context_.shown.state();
    if (study().volume) state.camera = toCamera(context_.viewport.camera());
    return state;
}

Result<void> StateController::setState(const scene::StudyState& state) {
    MACULA_TRY_VOID(context_.shown.take(state));
    context_.notes.set(NoteOn::session, QString());  // the state is no longer the restored one
    context_.notes.show();
    if (state.camera) context_.viewport.showFrom(*state.camera);
    return {};
}

// The preset of the command line if it fits, else the automatic one: a choice in one study says nothing about
// another. A curve over Hounsfield units is meaningless for a scanner's raw numbers, and the reverse.
std::shared_ptr<const TransferFunction> StateController::usualPreset(const Volume& volume) const {
    const auto& wanted = options_.preset;
    return wanted && suits(*wanted, volume.unit()) ? wanted
                                                   : scene::presetFor(context_.session.catalogue(), volume);
}

std::optional<scene::StudyState> StateController::stateAsLeft(const study::OpenedStudy& study) {
    if (study.stateAsLeft.empty() || options_.restores == Restores::nothing) return std::nullopt;
    auto state = scene::studyStateFromJson(study.stateAsLeft, {});
    if (!state) {
        context_.notes.set(NoteOn::session,
                           tr("How this study was left cannot be read; it is shown as when opened first."));
        return std::nullopt;
    }
    return *std::move(state);
}

OpeningState StateController::openingState(const study::OpenedStudy& study,
                                           const scene::OpeningPlanes& planes) {
    const Volume& volume = *study.volume;
    OpeningState opening;
    const auto preset = usualPreset(volume);
    if (const auto& wanted = options_.preset; wanted && wanted != preset)
        opening.notes << tr("The preset %1 is not made for this kind of volume; %2 is used instead.")
                             .arg(titleOr(wanted->title, wanted->name), titleOr(preset->title, preset->name));
    // The drawing is a choice for one study, and starts with the defaults. The arrangement of the window
    // stays.
    const scene::StudyState& before = context_.session.state();
    scene::StudyState now{.seriesDigest = study.seriesDigest,
                          .preset = preset,
                          .lights = options_.lights,
                          .showsMarks = before.showsMarks,
                          .background = before.background,
                          .layout = layoutOf(volume),
                          .slices = {.asAcquired = planes.asAcquired}};
    std::optional<scene::StudyState> left = stateAsLeft(study);
    if (left && options_.restores == Restores::work) {
        now.slices = left->slices;
        now.measurements = left->measurements;
        now.namedClips = left->namedClips;
        now.segmentations = scene::onSlicesAlone(left->segmentations);
        now.otherKeys = left->otherKeys;
        left.reset();
    } else if (left) {
        now = *left;
        if (options_.keepsLayout) now.layout = before.layout;
        now.seriesDigest = study.seriesDigest;
        now.camera.reset();
        now.leavesTableOut = false;  // until the table is found
        if (!now.preset) now.preset = preset;
        opening.notes.clear();  // they are about another preset
        context_.notes.set(
            NoteOn::session,
            tr("This study is shown as it was left. The View menu shows it as when first opened."));
    }
    now.slices = scene::carriedSlices(this->study(), before.slices, study, now.slices);
    opening.keepsCamera = study::staysInPlace(this->study(), study) && !context_.viewport.framedFrom();
    opening.state = std::move(now);
    opening.left = std::move(left);
    return opening;
}

scene::Layout StateController::layoutOf(const Volume& volume) const {
    const scene::Layout before = context_.session.state().layout;
    if (options_.keepsLayout || !options_.usualLayout) return before;
    return options_.usualLayout(volume).value_or(before);
}

// Leaves out a camera that nobody has moved: it fits the visible part in a window of any size.
scene::StudyState StateController::stateToKeep() const {
    scene::StudyState now = state();
    if (!study().volume) return now;
    if (context_.viewport.framedFrom() == context_.viewport.firstFrom()) now.camera.reset();
    return now;
}

// The opening state is not a person's choice, so it is not stored unless it changes.
void StateController::begin() {
    kept_ = stateToKeep();
    keptText_ =
        std::make_shared<std::string>(study().stateAsLeft.empty() ? toJson(*kept_) : study().stateAsLeft);
}

void StateController::keep() {
    if (!keeper_ || !study().volume || options_.restores == Restores::nothing) return;
    scene::StudyState now = stateToKeep();
    if (kept_ && *kept_ == now) return;
    keeper_->keepState(study().volume, toJson(now), keptText_);
    kept_ = std::move(now);
}

bool StateController::keepNow() {
    keep();
    return !keeper_ || keeper_->waitUntilStatesAreKept(kWorkIsKeptWithin);
}

void StateController::addActions(QMenu& view) {
    QAction* afresh = view.addAction(tr("Show as when first opened"), this, &StateController::showAfresh);
    describe(*afresh, "show-afresh",
             tr("Preset, lights, clip, look and camera that a study has which nobody has seen yet"));
}

// Keeps measurements, which are a person's work.
void StateController::showAfresh() {
    if (!study().volume) return;
    context_.shown.table().cancel();
    context_.notes.set(NoteOn::session, QString());
    context_.session.change(tr("Show afresh"), [this](scene::StudyState& next) {
        const scene::StudyState before = std::exchange(next, {});
        next.seriesDigest = before.seriesDigest;
        next.preset = usualPreset(*study().volume);
        next.lights = options_.lights;
        next.layout = before.layout;
        next.measurements = before.measurements;
        next.namedClips = before.namedClips;
        next.secondVolume = before.secondVolume;
        next.otherKeys = before.otherKeys;
    });
    context_.viewport.setParallel(false);
    context_.viewport.showFrom(context_.viewport.firstFrom());
    context_.notes.show();
}

}  // namespace macula::viewer
