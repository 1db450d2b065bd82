#include "evaluate/stored_scene.h"

#include <utility>

#include "evaluate/measurement.h"
#include "scene/camera/orbit_camera.h"

namespace macula::evaluate {

namespace {

constexpr double kSliceMs = 20.0;
constexpr std::uint64_t kShelfBytes = std::uint64_t(1) << 30;

}  // namespace

hybrid::StoredModel WatchedStore::find(const std::string& key) {
    hybrid::StoredModel found = keeper_.find(key);
    last_ = found.answer;
    const Time now = std::chrono::steady_clock::now();
    const bool isWhole = last_ == Answer::whole;
    if (!drawableAt_ && (isWhole || last_ == Answer::drawable)) drawableAt_ = now;
    if (!wholeAt_ && isWhole) wholeAt_ = now;
    return found;
}

void WatchedStore::keep(std::shared_ptr<const hybrid::PeripheralState> state) {
    newest_ = std::move(state);
}

void WatchedStore::handOver() {
    if (newest_) keeper_.keep(newest_);
}

StoredScene::StoredScene(const BenchStudy& study, scene::Drawing drawing, live::SceneOnDevice scene,
                         std::filesystem::path folder, Progress& progress)
    : study_(study),
      drawing_(std::move(drawing)),
      scene_(std::move(scene)),
      folder_(std::move(folder)),
      progress_(progress) {}

std::unique_ptr<live::StudyKeeper> StoredScene::makeKeeper() {
    return std::make_unique<live::StudyKeeper>(session::StoreOptions{.folder = folder_},
                                               [this](const Error& error) {
                                                   const std::lock_guard lock(mutex_);
                                                   if (!told_) told_ = error;
                                               });
}

Result<void> StoredScene::checkKeepers() const {
    const std::lock_guard lock(mutex_);
    return told_ ? Result<void>(*told_) : Result<void>();
}

void StoredScene::look(live::StudyKeeper& keeper) const {
    keeper.willShow(kName, study_.volume, drawing_);
}

Result<hybrid::LiveModel> StoredScene::makeModel(std::shared_ptr<WatchedStore> store) const {
    hybrid::LiveModelOptions options = hybrid::liveModelOptions(*study_.device);
    options.mostWaitForStore = kPatience;
    return hybrid::LiveModel::create(study_.device, scene_.tracer,
                                     std::make_shared<hybrid::ModelShelf>(kShelfBytes), std::move(store),
                                     options);
}

Result<void> StoredScene::show(hybrid::LiveModel& model) const {
    return model.show(kName, drawing_.settings);
}

Result<void> StoredScene::work(hybrid::LiveModel& model) const {
    if (progress_.cancelled()) return cancelledError();
    return model.work(kSliceMs, [this] { return !progress_.cancelled(); });
}

Result<void> StoredScene::draw(hybrid::LiveModel& model, const Camera& camera) const {
    MACULA_TRY([[maybe_unused]] const splat::DevicePicture* picture,
               model.draw(camera, {study_.view.width, study_.view.height}));
    return study_.device->waitForAll();
}

Result<std::vector<Camera>> StoredScene::turn(int cameras) const {
    MACULA_TRY(const std::vector<glm::dvec3> outline, scene_.tracer.outlineMm());
    const scene::OrbitCamera first =
        scene::framed(outline, ViewDirection::anterior, study_.view.camera.verticalFovDeg,
                      double(study_.view.width) / study_.view.height);
    std::vector<Camera> all;
    for (int i = 0; i < cameras; ++i)
        all.push_back(scene::toCamera(scene::orbited(first, 360.0 * i / cameras, 0.0)));
    return all;
}

Result<session::Store> StoredScene::openStore() const {
    return session::Store::open({.folder = folder_});
}

Result<session::ModelInfo> storedModel(session::Store& store) {
    MACULA_TRY(const session::Listing<session::ModelInfo> models, store.listModels());
    if (models.entries.empty()) return nothingStored();
    return models.entries.front();
}

Error nothingStored() {
    return {ErrorCode::outputNotWritable,
            Text("What the model has learnt was not found again."),
            {},
            Text("Try again; --sessions chooses another folder.")};
}

}  // namespace macula::evaluate
