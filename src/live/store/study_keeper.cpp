#include "live/store/study_keeper.h"

#include <algorithm>
#include <exception>
#include <fstream>
#include <future>
#include <span>
#include <sstream>
#include <system_error>
#include <utility>

#include "base/check.h"
#include "base/give_way.h"
#include "base/log.h"
#include "base/sha256.h"
#include "live/store/model_key_of_drawing.h"
#include "live/store/purge_plan.h"
#include "live/store/seen_before.h"
#include "pipeline/hybrid/model/peripheral_file.h"
#include "scene/state/state_keys.h"
#include "scene/state/state_merge.h"
#include "scene/state/study_state.h"

namespace macula::live {

namespace {

using Answer = hybrid::StoredModel::Answer;

constexpr std::size_t kMostScenes = 64;  // as many as have names, SceneIds
constexpr std::size_t kMostKin = 16;
constexpr const char* kStateName = "as it was left";
constexpr std::int64_t kStateVersion = 1;

std::span<const std::byte> bytesOf(const std::string& text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

// In the store a model has the digest of its key, in the program the name of its scene.
void rename(hybrid::PeripheralState& state, const std::string& key) {
    state.training.options.key = key;
    state.first.key = key;
}

session::OpenedVolume openedVolume(const Volume& volume, std::string digest) {
    const Provenance& from = volume.provenance();
    session::OpenedVolume opened{.study = {}, .series = {}, .volume = std::move(digest)};
    if (from.studyInstanceUid.empty() || from.seriesInstanceUid.empty()) return opened;
    opened.study = session::studyIdentity(from.studyInstanceUid);
    opened.series = session::seriesIdentity(from.studyInstanceUid, from.seriesInstanceUid);
    return opened;
}

// What was shown of a stored model; nothing where its file cannot be read, or not be understood.
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

// Whether more is stored than this has learnt: of a model whose answer came too late or could not be read,
// and in whose place another one was begun, or by another window.
bool isLessThanStored(session::Store& store, const session::ModelKey& key,
                      const hybrid::PeripheralState& state) {
    const auto info = store.findModel(key);
    if (!info || !*info) return false;
    const auto stored = drawableOf(store, **info);
    return stored && stored->steps > state.training.steps;
}

session::DocumentId stateIdOf(const Volume& volume, const std::string& digest) {
    return {.kind = session::DocumentKind::studyState,
            .study = openedVolume(volume, digest).study,
            .name = digest + " " + kStateName};
}

// What cannot be taken into the new state stays under a name of its own before that takes its place: what
// this program cannot read, of a newer one or of a fault, and what would be too much together.
Result<void> setAsideIfNotMerged(session::Store& store, const session::DocumentId& id,
                                 const session::Document& before, const std::string* base,
                                 const std::string& json) {
    const bool isReadable = scene::studyStateFromJson(before.json, {}).ok();
    if (isReadable && (base == nullptr || scene::mergedState(*base, json, before.json))) return {};
    session::DocumentId aside = id;
    aside.name +=
        (isReadable ? ", of another window " : ", unreadable ") + sha256Hex(before.json).substr(0, 16);
    MACULA_TRY_VOID(store.putDocument(aside, before.version, before.json, {}));
    MACULA_TRY_VOID(store.removeDocument(id));
    return {};
}

}  // namespace

StudyKeeper::StudyKeeper(session::StoreOptions options, KeeperListener listener,
                         std::optional<std::chrono::days> retention)
    : options_(std::move(options)),
      listener_(std::move(listener)),
      retention_(retention),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

StudyKeeper::~StudyKeeper() {
    thread_.request_stop();  // what was handed over is done before it ends
}

void StudyKeeper::post(Urgency urgency, Job job) {
    {
        const std::lock_guard lock(mutex_);
        (urgency == Urgency::isWaitedFor ? waitedFor_ : canWait_).push_back(std::move(job));
    }
    wake_.notify_one();
}

void StudyKeeper::run(const std::stop_token& stop) {
    std::optional<CheckBoundary> boundary;
    if (isBounded_) boundary.emplace();
    giveWay(GiveWay::toTheFrame);
    openStore();
    forgetUnused();
    std::unique_lock lock(mutex_);
    hasNoStore_ = !store_;
    if (hasNoStore_) {  // what nobody will save is not held on to
        scenes_.clear();
        names_.clear();
        toKeep_.clear();
    }
    while (wake_.wait(lock, stop, [this] { return hasJobs(); })) {
        isBusy_ = true;
        doFirst(waitedFor_.empty() ? canWait_ : waitedFor_, lock);
        isBusy_ = false;
        if (!hasJobs()) idle_.notify_all();
    }
}

void StudyKeeper::doFirst(std::deque<Job>& jobs, std::unique_lock<std::mutex>& lock) {
    Job job = std::move(jobs.front());
    jobs.pop_front();
    lock.unlock();
    try {
        if (store_) job(*store_);
    } catch (const std::exception&) {
        tellOfNoMemory("There is not enough memory to keep this study's model.");
    } catch (const CheckFailure& failure) {
        tellOfFault(failure);
    }
    job = nullptr;
    lock.lock();
}

void StudyKeeper::doBeside(const std::function<void()>& work) {
    bool isDone = false;
    std::exception_ptr thrown;
    std::jthread thread;
    try {
        thread = std::jthread([&] {
            giveWay(GiveWay::toAll);
            std::optional<CheckBoundary> boundary;
            if (isBounded_) boundary.emplace();
            try {
                work();
            } catch (...) {
                thrown = std::current_exception();
            }
            const std::lock_guard lock(mutex_);
            isDone = true;
            wake_.notify_one();
        });
    } catch (const std::system_error&) {
        return work();  // the process has no thread left: whoever waits does so for longer
    }
    std::unique_lock lock(mutex_);
    while (true) {
        wake_.wait(lock, [&] { return isDone || !waitedFor_.empty(); });
        if (isDone) break;
        doFirst(waitedFor_, lock);
    }
    if (thrown) std::rethrow_exception(thrown);
}

void StudyKeeper::openStore() {
    try {
        Result<session::Store> opened = session::Store::open(options_);
        if (!opened) return tell(opened.error());
        store_.emplace(*std::move(opened));
        if (store_->notes().setAside)
            tell({ErrorCode::inputNotUsable,
                  "The file of stored sessions was damaged. It was set aside, and what could be read of it "
                  "was rescued.",
                  store_->notes().setAside->folder.string(), "`macula sessions verify` says what is there."});
    } catch (const std::exception&) {
        tellOfNoMemory("Stored sessions could not be opened.");
    } catch (const CheckFailure& failure) {
        store_.reset();
        tellOfFault(failure);
    }
}

void StudyKeeper::forgetUnused() {
    if (!store_ || !retention_) return;
    try {
        const auto purged = store_->purgeUnused(*retention_, session::DamagedFiles::keep);
        if (!purged) return tell(purged.error());
        if (purged->studies + purged->volumes > 0)
            log::info("Stored sessions: {} studies and {} volumes were not opened for {} days, and deleted.",
                      purged->studies, purged->volumes, retention_->count());
        if (purged->clock != session::ClockDoubt::none) tell(keptForClock(purged->clock));
    } catch (const std::exception&) {
        tellOfNoMemory("What was not opened for long could not be deleted.");
    } catch (const CheckFailure& failure) {
        tellOfFault(failure);
    }
}

bool StudyKeeper::isIdle() {
    const std::lock_guard lock(mutex_);
    return !hasJobs() && !isBusy_;
}

void StudyKeeper::withStore(StoreUse use) {
    // The destructor tells the caller that there is no store: without one the job is dropped unrun, and this
    // goes with it.
    struct Once {
        explicit Once(StoreUse given) : use(std::move(given)) {}
        Once(const Once&) = delete;
        Once& operator=(const Once&) = delete;
        StoreUse use;
        ~Once() {
            if (use) use(nullptr);
        }
    };
    post(Urgency::isWaitedFor, [once = std::make_shared<Once>(std::move(use))](session::Store& store) {
        std::exchange(once->use, nullptr)(&store);
    });
}

bool StudyKeeper::waitUntilStatesAreKept(std::chrono::milliseconds patience) {
    auto kept = std::make_shared<std::promise<void>>();
    const auto future = kept->get_future();
    withStore([kept](session::Store*) { kept->set_value(); });
    return future.wait_for(patience) == std::future_status::ready;
}

void StudyKeeper::waitUntilIdle() {
    std::unique_lock lock(mutex_);
    idle_.wait(lock, [this] { return !hasJobs() && !isBusy_; });
}

void StudyKeeper::tell(const Error& error) {
    if (!told_.insert(error.message).second) return;
    log::warning("Stored sessions: {}", error.message);
    if (listener_) listener_(error);
}

void StudyKeeper::tellOfNoMemory(const char* sentence) noexcept {
    try {
        tell({ErrorCode::outOfMemory, sentence, {}, "Close other programs."});
    } catch (const std::exception&) {
        // There is none to say so either.
    }
}

void StudyKeeper::tellOfFault(const CheckFailure& failure) noexcept {
    try {
        log::error("Stored sessions: {}", failure.text());
        tell({ErrorCode::inputNotUsable,
              "Stored sessions were not changed, because Macula found a mistake of its own.",
              {},
              "Please report this: " + failure.text()});
    } catch (const std::exception&) {
        // There is no memory to say so.
    }
}

void StudyKeeper::willShow(const std::string& name, std::shared_ptr<const Volume> volume,
                           const scene::Drawing& drawing) {
    {
        const std::lock_guard lock(mutex_);
        if (hasNoStore_) return;
        names_.remove(name);
        names_.push_back(name);
        // Nobody asks for those of before until they are looked for again, and a whole model is large. Those
        // that were given up hold a volume, which may not be open any more.
        for (auto& other : scenes_) other.second.found = {.answer = Answer::none};
        std::erase_if(scenes_, [&](const auto& other) {
            const bool isOfAnother = other.second.volume && other.second.volume != volume;
            return isOfAnother && !toKeep_.contains(other.first);
        });
        const auto [scene, isNew] =
            scenes_.try_emplace(name, Scene{.volume = std::move(volume), .drawing = drawing});
        // Models differ by now from what was found once; the shelf has those that were shown.
        if (!isNew) scene->second.found = {};
        while (names_.size() > kMostScenes) {
            if (!toKeep_.contains(names_.front())) scenes_.erase(names_.front());
            names_.pop_front();
        }
    }
    post(Urgency::isWaitedFor, [this, name](session::Store& store) {
        try {
            searchFor(store, name);
        } catch (...) {
            answer(name, {.answer = Answer::none});  // or it would be waited for for ever
            throw;
        }
    });
}

hybrid::StoredModel StudyKeeper::find(const std::string& name) {
    const std::lock_guard lock(mutex_);
    const auto scene = scenes_.find(name);
    if (scene == scenes_.end() || hasNoStore_) return {.answer = Answer::none};
    hybrid::StoredModel found = scene->second.found;
    // Whoever goes on with it has it.
    if (found.answer == Answer::whole) scene->second.found = {.answer = Answer::none};
    return found;
}

void StudyKeeper::answer(const std::string& name, hybrid::StoredModel found) {
    const std::lock_guard lock(mutex_);
    if (names_.empty() || names_.back() != name) return;  // nobody asks for it any more
    if (const auto scene = scenes_.find(name); scene != scenes_.end()) scene->second.found = std::move(found);
}

std::optional<StudyKeeper::Named> StudyKeeper::nameForStore(const std::string& name) {
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

void StudyKeeper::record(session::Store& store, const session::OpenedVolume& volume) {
    if (recorded_.contains(volume.volume)) return;
    if (const auto done = store.recordOpened(volume); !done) return tell(done.error());
    recorded_.insert(volume.volume);
}

void StudyKeeper::searchFor(session::Store& store, const std::string& name) {
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
        tell(info.error());
        if (session::troubleOf(info.error()) == session::Trouble::modelDamaged)
            found.answer = Answer::damaged;
    } else if (*info) {
        found = resume(store, **info, name);
    } else {
        found = beginWithKin(store, named->key);
    }
    const bool isWhole = found.answer == Answer::whole;
    answer(name, std::move(found));
    // Only now: both wait for the disk.
    record(store, named->volume);
    if (!isWhole) return;
    if (const auto touched = store.touchModel(named->key); !touched) tell(touched.error());
}

// What was shown at once, by answer(); then all of it.
hybrid::StoredModel StudyKeeper::resume(session::Store& store, const session::ModelInfo& info,
                                        const std::string& name) {
    if (const auto drawable = drawableOf(store, info)) answer(name, storedModel(Answer::drawable, *drawable));

    // The checksum of all of it tells whether it is damaged. A disk that does not answer and a lack of memory
    // are no damage, and a file that is gone may have been saved anew by another window.
    const auto blob = store.readModel(info);
    if (!blob) {
        const auto trouble = session::troubleOf(blob.error());
        if (trouble != session::Trouble::modelGone) tell(blob.error());
        const bool isDamaged = trouble == session::Trouble::modelDamaged;  // the store has set it aside
        return {.answer = isDamaged ? Answer::damaged : Answer::none};
    }
    const std::string text(reinterpret_cast<const char*>(blob->blob.data()), blob->blob.size());
    std::istringstream whole(text);
    auto read = hybrid::readPeripheral(whole, text.size());
    if (!read && read.error().code == ErrorCode::outOfMemory) {
        tell(read.error());
        return {.answer = Answer::none};
    }
    if (!read || read->isTrainingOnly || read->state.training.options.key != info.key.digest()) {
        tell({ErrorCode::inputNotUsable,
              "A stored model is damaged, and is not used.",
              {},
              "`macula sessions verify` says what else is."});
        if (const auto aside = store.setModelAside(blob->info, "content"); !aside) tell(aside.error());
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

hybrid::StoredModel StudyKeeper::beginWithKin(session::Store& store, const session::ModelKey& key) {
    const auto candidates = store.nearestModels(key, kMostKin);
    if (!candidates) {
        tell(candidates.error());
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

void StudyKeeper::keep(std::shared_ptr<const hybrid::PeripheralState> state) {
    const std::string name = state->training.options.key;
    {
        const std::lock_guard lock(mutex_);
        if (hasNoStore_ || !scenes_.contains(name)) return;
        auto& newest = toKeep_[name];
        // After a loss a model hands over what is on the host, which may be older than what it gave before.
        if (newest && newest->training.steps > state->training.steps) return;
        newest = std::move(state);
    }
    post(Urgency::canWait, [this, name](session::Store& store) { save(store, name); });
}

void StudyKeeper::save(session::Store& store, const std::string& name) {
    // First, as willShow() leaves only those scenes alone of which something is to be kept.
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
    record(store, named->volume);
    hybrid::PeripheralState stored = *state;  // pictures are shared
    rename(stored, named->key.digest());
    std::ostringstream stream;
    Result<void> written;
    doBeside([&] { written = hybrid::writePeripheral(stream, stored, packed_); });
    if (!written) return tell(written.error());
    const std::string blob = std::move(stream).str();
    if (const auto saved = store.saveModel(named->key, bytesOf(blob)); !saved) tell(saved.error());
}

std::optional<std::string> StudyKeeper::stateOf(const std::shared_ptr<const Volume>& volume,
                                                std::chrono::milliseconds patience) {
    try {
        const std::string digest = digests_.of(volume);
        auto found = std::make_shared<std::promise<std::optional<std::string>>>();
        auto future = found->get_future();
        post(Urgency::isWaitedFor, [this, found, id = stateIdOf(*volume, digest),
                                    opened = openedVolume(*volume, digest)](session::Store& store) {
            const auto document = store.getDocument(id);
            if (!document) tell(document.error());
            found->set_value(document && *document ? std::optional((*document)->json) : std::nullopt);
            record(store, opened);  // only now: it waits for the disk
        });
        found.reset();  // where there is no store the job is dropped, and nobody waits
        if (future.wait_for(patience) == std::future_status::ready) return future.get();
        post(Urgency::isWaitedFor, [this](session::Store&) {
            tell({ErrorCode::inputNotUsable,
                  "How this study was left was not found in time.",
                  {},
                  "It is kept: open the study again to see it."});
        });
    } catch (const std::exception&) {
        // The promise was dropped, or there is no memory.
    }
    return std::nullopt;
}

void StudyKeeper::askWhatWasSeen(std::shared_ptr<const study::FoundVolumes> found,
                                 std::function<void(std::set<std::size_t>)> answer) {
    post(Urgency::isWaitedFor,
         [this, found = std::move(found), answer = std::move(answer)](session::Store& store) {
             if (const auto seen = volumesSeenBefore(store, *found))
                 return answer(*seen);
             else
                 tell(seen.error());
         });
}

void StudyKeeper::keepState(std::shared_ptr<const Volume> volume, std::string json,
                            std::shared_ptr<std::string> base) {
    // Before whoever asks for it next.
    post(Urgency::isWaitedFor, [this, volume = std::move(volume), json = std::move(json),
                                base = std::move(base)](session::Store& store) {
        const std::string digest = digests_.of(volume);
        record(store, openedVolume(*volume, digest));
        const session::DocumentId id = stateIdOf(*volume, digest);
        const auto before = store.getDocument(id);
        if (!before) {
            tell(before.error());  // a damaged one the store has set aside by itself
        } else if (*before) {
            const auto aside = setAsideIfNotMerged(store, id, **before, base.get(), json);
            if (!aside) return tell(aside.error());
        }
        bool holdsMore = false;
        const auto merge = [&](const std::optional<std::string>& stored) {
            const auto merged = stored && base ? scene::mergedState(*base, json, *stored) : std::nullopt;
            holdsMore = merged && merged->holdsMore;
            return merged ? merged->json : json;
        };
        // A clip that was taken back is in the older text still.
        const std::vector<std::string> keys = scene::stateKeys();
        const std::vector<std::string_view> known(keys.begin(), keys.end());
        if (const auto done = store.changeDocument(id, kStateVersion, merge, known); !done)
            return tell(done.error());  // the next one is still made of what was kept before
        if (base) *base = json;
        if (holdsMore)
            tell({ErrorCode::inputNotUsable,
                  "More was measured on this study than is shown here: another window has it open, or had.",
                  {},
                  "All of it is kept; open the study again to see it."});
    });
}

}  // namespace macula::live
