#include "live/frame/phase_models.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <thread>
#include <utility>

#include "base/check.h"
#include "base/elapsed.h"
#include "base/log.h"
#include "base/timeline.h"
#include "pipeline/trace/device_scene.h"

namespace macula::live {

namespace {

using Clock = std::chrono::steady_clock;
using Answer = hybrid::StoredModel::Answer;

constexpr std::chrono::milliseconds kStoreIsAskedEvery{2};
// The store looks for one scene at a time: after so long without an answer it is asked again. The first
// search of a volume reads all of its voxels.
constexpr std::chrono::seconds kAnswerMayTake{10};
constexpr int kMostSearches = 2;

std::size_t apart(std::size_t a, std::size_t b, std::size_t count) {
    const std::size_t between = a < b ? b - a : a - b;
    return std::min(between, count - between);  // the first phase follows the last
}

}  // namespace

// Names scenes only when the wanted phases change: each edit of a drawing makes others.
void PhaseModels::takeWanted(const FrameInput& input) {
    if (wanted_ == input.phases && study_ == input.study) return;
    std::vector<Phase> before = std::exchange(phases_, {});
    const std::vector<std::string> namesBefore = std::exchange(names_, {});
    const std::string learning = learning_ ? namesBefore[*learning_] : std::string();
    wanted_ = input.phases;
    study_ = input.study;
    searches_ = 0;
    if (wanted_) {
        for (const PhaseScene& scene : *wanted_) {
            names_.push_back(scenes_.nameOf(study_, scene));
            const auto known = std::ranges::find(namesBefore, names_.back());
            phases_.push_back(known == namesBefore.end()
                                  ? Phase{}
                                  : std::move(before[std::size_t(known - namesBefore.begin())]));
            phases_.back().scene = scene;
        }
    }
    if (learning.empty()) return;
    learning_ = indexOf(learning);
    if (!learning_ && model_) model_->hide();
    if (!wanted_) freeDevice();
}

std::optional<std::size_t> PhaseModels::indexOf(const std::string& name) const {
    const auto found = std::ranges::find(names_, name);
    return found == names_.end() ? std::nullopt : std::optional(std::size_t(found - names_.begin()));
}

std::optional<std::size_t> PhaseModels::nextToLearn(const FrameInput& input) const {
    if (learning_) return learning_;
    std::size_t shown = 0;
    for (std::size_t i = 0; i < phases_.size(); ++i)
        if (phases_[i].scene.phase == input.phase) shown = i;
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < phases_.size(); ++i) {
        if (phases_[i].isLearnt || phases_[i].isGivenUp || names_[i] == onScreen_) continue;
        if (!nearest || apart(i, shown, phases_.size()) < apart(*nearest, shown, phases_.size())) nearest = i;
    }
    return nearest;
}

bool PhaseModels::hasWork(const FrameInput& input, const std::string& onScreen) {
    takeWanted(input);
    onScreen_ = onScreen;
    const bool has = input.learnsPhases && !noRoom_ && nextToLearn(input).has_value();
    if (!has) rest();
    if (wanted_ || told_ != PhaseModelsChanged{}) tell(input);
    return has;
}

Result<void> PhaseModels::work(const FrameInput& input, double budgetMs,
                               const std::function<bool()>& keepGoing) {
    const TimelineStage stage("phases: learn");
    const std::optional<std::size_t> index = nextToLearn(input);
    MACULA_CHECK(index.has_value());
    const auto start = Clock::now();
    const auto goesOn = [&] { return msSince(start) < budgetMs && keepGoing(); };
    Result<void> done;
    if (learning_)
        done = learn(budgetMs, keepGoing);
    else if (phases_[*index].sought != Sought::done)
        seek(*index, goesOn);
    else
        done = begin(*index);
    tell(input);
    return done;
}

// Asks the store between other work, as a model on screen does. Without one it is not asked.
void PhaseModels::seek(std::size_t index, const std::function<bool()>& goesOn) {
    Phase& phase = phases_[index];
    const std::shared_ptr<SceneKeeper>& keeper = scenes_.keeper();
    if (!keeper || scenes_.isOnShelf(names_[index])) {
        phase.sought = Sought::done;
        return;
    }
    if (phase.sought == Sought::no) {
        keeper->willShow(names_[index], phase.scene.volume, phase.scene.drawing);
        phase.sought = Sought::inStore;
        soughtSince_ = Clock::now();
    }
    while (true) {
        const hybrid::StoredModel found = keeper->find(names_[index]);
        takeFound(phase, found);
        if (found.answer != Answer::pending && found.answer != Answer::drawable) break;
        if (phase.isLearnt) break;
        if (Clock::now() - soughtSince_ > kAnswerMayTake) {
            if (++searches_ >= kMostSearches) break;
            phase.sought = Sought::no;
            return;
        }
        if (!goesOn()) return;
        std::this_thread::sleep_for(kStoreIsAskedEvery);
    }
    searches_ = 0;
    phase.sought = Sought::done;
}

void PhaseModels::takeFound(Phase& phase, const hybrid::StoredModel& found) {
    if (found.answer != Answer::drawable && found.answer != Answer::whole) return;
    phase.drawable = Drawable{.splats = found.splats, .gain = found.gain, .steps = found.steps};
    phase.isLearnt = found.steps >= kStepsOfLearnt;
    if (found.state && scenes_.hasShelf()) scenes_.shelf()->put(found.state);
}

Result<void> PhaseModels::begin(std::size_t index) {
    const Phase& phase = phases_[index];
    MACULA_TRY_VOID(bringToDevice(phase.scene));
    if (!model_) {
        MACULA_TRY(model_,
                   hybrid::LiveModel::create(device_.device(), *tracer_, scenes_.shelf(), scenes_.keeper(),
                                             hybrid::liveModelOptions(*device_.device())));
    }
    learning_ = index;
    return model_->show(names_[index], phase.scene.drawing.settings);
}

// As AppliedScene does on screen: a part that is there already stays.
Result<void> PhaseModels::bringToDevice(const PhaseScene& scene) {
    const TimelineStage stage("phases: set scene");
    if (model_) model_->hide();
    const bool isNew = !tracer_;
    if (isNew) {
        MACULA_TRY(tracer_, trace::PathTracer::create(device_.device()));
    }
    trace::DeviceScene& device = tracer_->scene();
    const scene::Drawing& drawing = scene.drawing;
    const PhaseScene before = std::exchange(onDevice_, {});
    const bool isOther = isNew || before.volume != scene.volume;
    if (isOther) MACULA_TRY_VOID(device.setVolume(scene.volume));
    if (isNew || before.drawing.clip != drawing.clip)
        MACULA_TRY_VOID(device.setClip(drawing.clip ? *drawing.clip : Clip{}));
    if (isOther || before.drawing.additions != drawing.additions)
        MACULA_TRY_VOID(device.setAdditions(drawing.additions ? *drawing.additions : Additions{}));
    if (isOther || before.drawing.transferFunction != drawing.transferFunction)
        MACULA_TRY_VOID(device.setTransferFunction(*drawing.transferFunction));
    if (isNew || before.drawing.lights != drawing.lights)
        MACULA_TRY_VOID(device.setEnvironment(trace::Environment::fromRig(*drawing.lights)));
    onDevice_ = scene;
    return {};
}

Result<void> PhaseModels::learn(double budgetMs, const std::function<bool()>& keepGoing) {
    Phase& phase = phases_[*learning_];
    if (model_->hasWork()) MACULA_TRY_VOID(model_->work(budgetMs, keepGoing));
    const hybrid::ModelNews news = model_->news();
    const bool isFit = hybrid::isFitToBeShown(news) && model_->canBeDrawn();
    if (isFit)
        phase.drawable = Drawable{.splats = model_->shown(), .gain = model_->gain(), .steps = news.steps};
    // A model may come to rest before it has taken so many steps: it will not become better.
    phase.isLearnt = isFit && (news.steps >= kStepsOfLearnt || !model_->hasWork());
    if (!phase.isLearnt && model_->hasWork()) return {};
    phase.isGivenUp = !phase.isLearnt;
    noRoom_ = news.stage == hybrid::ModelStage::noRoom;
    endLearning();
    return {};
}

void PhaseModels::endLearning() {
    if (model_) model_->hide();
    learning_.reset();
}

void PhaseModels::freeDevice() {
    endLearning();
    model_.reset();
    tracer_.reset();
    onDevice_ = {};
}

void PhaseModels::rest() {
    if (tracer_) freeDevice();
}

void PhaseModels::giveUp(const FrameInput& input, const Error& error) {
    if (const auto index = nextToLearn(input)) phases_[*index].isGivenUp = true;
    noRoom_ = error.code == ErrorCode::outOfMemory;
    freeDevice();
    tell(input);
}

void PhaseModels::note(const FrameInput& input, const std::string& name, Drawable drawable) {
    takeWanted(input);
    const auto index = indexOf(name);
    if (!index || !drawable.splats) return;
    phases_[*index].drawable = std::move(drawable);
    phases_[*index].isLearnt = true;
}

void PhaseModels::release(const std::string& name) {
    if (learning_ && names_[*learning_] == name) endLearning();
}

void PhaseModels::putAway() {
    try {
        freeDevice();
    } catch (const std::exception&) {
        log::warning("There was no memory to keep the models of phases.");
    }
}

void PhaseModels::forget() {
    putAway();
    drawn_.forget();
    wanted_.reset();
    phases_.clear();
    names_.clear();
    noRoom_ = false;
    told_ = {};
}

void PhaseModels::dropDevice() {
    try {
        if (model_) model_->save();
    } catch (const std::exception&) {
        log::warning("There was no memory to keep the models of phases.");
    }
    learning_.reset();
    model_.reset();
    tracer_.reset();
    onDevice_ = {};
    drawn_.forget();
}

bool PhaseModels::canDraw(const FrameInput& input) {
    takeWanted(input);
    const auto index = indexOf(scenes_.nameOf(input));
    return index && phases_[*index].isLearnt;
}

Result<hybrid::Periphery> PhaseModels::periphery(const FrameInput& input) {
    const auto index = indexOf(scenes_.nameOf(input));
    MACULA_CHECK(index && phases_[*index].drawable);
    const Drawable& drawable = *phases_[*index].drawable;
    drawnName_ = names_[*index];
    drawnSteps_ = drawable.steps;
    if (!drawn_.isOf(drawable.splats))
        MACULA_TRY_VOID(drawn_.show(device_.device(), drawable.splats, drawable.gain));
    return hybrid::Periphery{
        .draw = [this](const Camera& eye, const glm::ivec2& sizePx) -> Result<hybrid::DrawnSplats> {
            MACULA_TRY(const splat::DevicePicture* picture,
                       drawn_.draw(eye, sizePx, splat::RasterView{}.nearMm));
            return hybrid::DrawnSplats{picture, &drawn_.depths()};
        },
        .gain = static_cast<float>(drawn_.gain()),
        .isLikeness = true};
}

void PhaseModels::doWithoutDrawing() {
    drawn_.forget();
    if (const auto index = indexOf(drawnName_)) {
        phases_[*index].drawable.reset();
        phases_[*index].isLearnt = false;
        phases_[*index].isGivenUp = true;
    }
}

hybrid::ModelNews PhaseModels::newsOfDrawn() const {
    hybrid::ModelNews news{.stage = hybrid::ModelStage::resting,
                           .origin = hybrid::ModelOrigin::shelf,
                           .steps = drawnSteps_,
                           .isSharp = true};
    if (drawn_.splats()) news.splats = static_cast<std::uint32_t>(drawn_.splats()->size());
    return news;
}

void PhaseModels::tell(const FrameInput& input) {
    PhaseModelsChanged now{.study = input.study, .wanted = phases_.size(), .noRoom = noRoom_};
    now.learnt = std::size_t(std::ranges::count(phases_, true, &Phase::isLearnt));
    if (learning_ && model_) {
        now.learning = phases_[*learning_].scene.phase;
        now.steps = model_->news().steps / 20 * 20;  // not for each step
    }
    if (now == told_) return;
    told_ = now;
    reports_.tell(now);
}

}  // namespace macula::live
