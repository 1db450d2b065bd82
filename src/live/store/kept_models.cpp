#include "live/store/kept_models.h"

#include <algorithm>
#include <fstream>
#include <span>
#include <sstream>
#include <utility>

#include "live/store/model_key_of_drawing.h"
#include "pipeline/hybrid/model/peripheral_file.h"

namespace macula::live {

namespace {

using Answer = hybrid::StoredModel::Answer;

constexpr std::size_t kMostScenes = 256;  // as SceneIds::kRemembered
constexpr std::size_t kMostKin = 16;

std::span<const std::byte> bytesOf(const std::string& text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

// The store names a model by the digest of its key, memory by the name of its scene.
void rename(hybrid::PeripheralState& state, const std::string& key) {
    state.training.options.key = key;
    state.first.key = key;
}

// The part of a stored model that can be drawn; nothing if its file cannot be read or understood.
std::optional<hybrid::DrawableModel> drawableOf(const session::Store& store, const session::ModelInfo& info) {
    const auto file = store.modelFile(info);
    if (!file) return std::nullopt;
    std::ifstream stream(*file, std::ios::binary);
    auto drawable = hybrid::readDrawable(stream, info.bytes);
    if (!drawable || drawable->isTrainingOnly || drawable->key != info.key.digest()) return std::nullopt;
    return *std::move(drawable);
}

hybrid::StoredModel storedModel(Answer answer, const hybrid::DrawableModel& drawable) {
    return {.answer = answer,
            .splats = drawable.splats,
            .steps = drawable.steps,
            .gain = drawable.gain,
            .seenMm = drawable.seenMm};
}

// Whether the stored model has taken more steps: another window stored it, or it came too late or could not
// be read, and this one was begun in its place.
bool isLessThanStored(session::Store& store, const session::ModelKey& key,
                      const hybrid::PeripheralState& state) {
    const auto info = store.findModel(key);
    if (!info || !*info) return false;
    const auto stored = drawableOf(store, **info);
    return stored && stored->steps > state.training.steps;
}

}  // namespace

void KeptModels::willShow(const std::string& name, std::shared_ptr<const Volume> volume,
                          const scene::Drawing& drawing) {
    {
        const std::lock_guard lock(mutex_);
        if (isWithoutStore_) return;
        names_.remove(name);
        names_.push_back(name);
        // Whole models are large, and nobody asks for those of other scenes before the next willShow() for
        // them. Scenes of other volumes would keep volumes in memory that may not be open any more.
        for (auto& other : scenes_) other.second.found = {.answer = Answer::none};
        std::erase_if(scenes_, [&](const auto& other) {
            const bool isOfAnother = other.second.volume && other.second.volume != volume;
            return isOfAnother && !toKeep_.contains(other.first);
        });
        const auto [scene, isNew] =
            scenes_.try_emplace(name, Scene{.volume = std::move(volume), .drawing = drawing});
        // What was found earlier is out of date; models that were shown are on the shelf.
        if (!isNew) scene->second.found = {};
        while (names_.size() > kMostScenes) {
            if (!toKeep_.contains(names_.front())) scenes_.erase(names_.front());
            names_.pop_front();
        }
    }
    thread_.post(StoreThread::Urgency::isWaitedFor, [this, name](session::Store& store) {
        try {
            searchFor(store, name);
        } catch (...) {
            answer(name, {.answer = Answer::none});  // otherwise its caller would wait for ever
            throw;
        }
    });
}

hybrid::StoredModel KeptModels::find(const std::string& name) {
    const std::lock_guard lock(mutex_);
    const auto scene = scenes_.find(name);
    if (scene == scenes_.end() || isWithoutStore_) return {.answer = Answer::none};
    hybrid::StoredModel found = scene->second.found;
    // The caller has the whole model now: no second copy is kept.
    if (found.answer == Answer::whole) scene->second.found = {.answer = Answer::none};
    return found;
}

void KeptModels::answer(const std::string& name, hybrid::StoredModel found) {
    const std::lock_guard lock(mutex_);
    if (names_.empty() || names_.back() != name) return;  // nobody asks for it any more
    if (const auto scene = scenes_.find(name); scene != scenes_.end()) scene->second.found = std::move(found);
}

std::optional<KeptModels::Named> KeptModels::nameForStore(const std::string& name) {
    std::shared_ptr<const Volume> volume;
    scene::Drawing drawing;
    {
        const std::lock_guard lock(mutex_);
        const auto scene = scenes_.find(name);
        if (scene == scenes_.end()) return std::nullopt;
        if (scene->second.named) return scene->second.named;
        volume = scene->second.volume;
        drawing = scene->second.drawing;
    }
    const std::string digest = digests_.of(volume);
    Named named{.key = modelKeyOf(digest, *volume, drawing, digests_),
                .volume = openedVolume(*volume, digest)};
    const std::lock_guard lock(mutex_);
    if (const auto scene = scenes_.find(name); scene != scenes_.end()) {
        scene->second.named = named;
        scene->second.volume = nullptr;
        scene->second.drawing = {};
    }
    return named;
}

void KeptModels::searchFor(session::Store& store, const std::string& name) {
    {
        const std::lock_guard lock(mutex_);
        // A hand that drags a curve shows a new scene many times a second: only the last is looked for.
        if (names_.empty() || names_.back() != name) return;
    }
    const std::optional<Named> named = nameForStore(name);
    if (!named) return;
    open_.reset();
    if (auto mark = store.markOpen(named->key)) open_.emplace(*std::move(mark));
    const auto info = store.findModel(named->key);
    hybrid::StoredModel found{.answer = Answer::none};
    if (!info) {
        messages_.tell(info.error());
        if (session::troubleOf(info.error()) == session::Trouble::modelDamaged)
            found.answer = Answer::damaged;
    } else if (*info) {
        found = resume(store, **info, name);
    } else {
        found = beginWithKin(store, named->key);
    }
    const bool isWhole = found.answer == Answer::whole;
    answer(name, std::move(found));
    // After the answer, because both wait for the disk.
    opened_.record(store, named->volume);
    if (!isWhole) return;
    if (const auto touched = store.touchModel(named->key); !touched) messages_.tell(touched.error());
}

// Answers first with what can be drawn at once; then returns the whole model with its training.
hybrid::StoredModel KeptModels::resume(session::Store& store, const session::ModelInfo& info,
                                       const std::string& name) {
    if (const auto drawable = drawableOf(store, info)) answer(name, storedModel(Answer::drawable, *drawable));

    // Only the checksum of the whole file shows damage. A disk that does not answer and a lack of memory are
    // not damage, and a file that is gone may have been replaced by another window.
    const auto blob = store.readModel(info);
    if (!blob) {
        const auto trouble = session::troubleOf(blob.error());
        if (trouble != session::Trouble::modelGone) messages_.tell(blob.error());
        const bool isDamaged = trouble == session::Trouble::modelDamaged;  // the store has set it aside
        return {.answer = isDamaged ? Answer::damaged : Answer::none};
    }
    const std::string text(reinterpret_cast<const char*>(blob->blob.data()), blob->blob.size());
    std::istringstream whole(text);
    auto read = hybrid::readPeripheral(whole, text.size());
    if (!read && read.error().code == ErrorCode::outOfMemory) {
        messages_.tell(read.error());
        return {.answer = Answer::none};
    }
    if (!read || read->isTrainingOnly || read->state.training.options.key != info.key.digest()) {
        messages_.tell({ErrorCode::inputNotUsable,
                        Text("A stored model is damaged, and is not used."),
                        {},
                        Text("`macula sessions verify` says what else is.")});
        if (const auto aside = store.setModelAside(blob->info, "content"); !aside)
            messages_.tell(aside.error());
        return {.answer = Answer::damaged};
    }
    rename(read->state, name);
    const auto state = std::make_shared<const hybrid::PeripheralState>(std::move(read->state));
    return {
        .answer = Answer::whole,
        .splats = state->shown ? state->shown : std::make_shared<const splat::Splats>(state->training.splats),
        .steps = state->training.steps,
        .gain = state->gain,
        .seenMm = state->seenMm,
        .state = state};
}

hybrid::StoredModel KeptModels::beginWithKin(session::Store& store, const session::ModelKey& key) {
    const auto candidates = store.nearestModels(key, kMostKin);
    if (!candidates) {
        messages_.tell(candidates.error());
        return {.answer = Answer::none};
    }
    for (const session::ModelCandidate& candidate : *candidates) {
        const Kinship kinship = kinshipOf(key, candidate.info.key);
        if (kinship == Kinship::none) continue;
        if (const auto drawable = drawableOf(store, candidate.info))
            return storedModel(kinship == Kinship::otherLights ? Answer::warm : Answer::stale, *drawable);
    }
    return {.answer = Answer::none};
}

void KeptModels::keep(std::shared_ptr<const hybrid::PeripheralState> state) {
    const std::string name = state->training.options.key;
    {
        const std::lock_guard lock(mutex_);
        if (isWithoutStore_ || !scenes_.contains(name)) return;
        auto& newest = toKeep_[name];
        // After a device loss a model hands over what is on the host: perhaps less than it handed over
        // before.
        if (newest && newest->training.steps > state->training.steps) return;
        newest = std::move(state);
    }
    thread_.post(StoreThread::Urgency::canWait, [this, name](session::Store& store) { save(store, name); });
}

void KeptModels::save(session::Store& store, const std::string& name) {
    // First, while toKeep_ still has the name: willShow() may erase the scene afterwards.
    const std::optional<Named> named = nameForStore(name);
    std::shared_ptr<const hybrid::PeripheralState> state;
    {
        const std::lock_guard lock(mutex_);
        const auto newest = toKeep_.find(name);
        if (newest == toKeep_.end()) return;  // saved with an earlier job
        state = std::move(newest->second);
        toKeep_.erase(newest);
        if (std::ranges::find(names_, name) == names_.end()) scenes_.erase(name);
    }
    if (!named || isLessThanStored(store, named->key, *state)) return;
    opened_.record(store, named->volume);
    hybrid::PeripheralState stored = *state;  // pictures are shared
    rename(stored, named->key.digest());
    std::ostringstream stream;
    Result<void> written;
    thread_.doBeside([&] { written = hybrid::writePeripheral(stream, stored, packed_); });
    if (!written) return messages_.tell(written.error());
    const std::string blob = std::move(stream).str();
    if (const auto saved = store.saveModel(named->key, bytesOf(blob)); !saved) messages_.tell(saved.error());
}

void KeptModels::doWithoutStore() {
    const std::lock_guard lock(mutex_);
    isWithoutStore_ = true;
    scenes_.clear();
    names_.clear();
    toKeep_.clear();
}

}  // namespace macula::live
