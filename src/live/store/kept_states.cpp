#include "live/store/kept_states.h"

#include <exception>
#include <future>
#include <string_view>
#include <utility>
#include <vector>

#include "base/sha256.h"
#include "scene/state/state_merge.h"
#include "scene/state/study_state.h"

namespace macula::live {

namespace {

constexpr std::int64_t kStateVersion = 1;

session::DocumentId stateIdOf(const Volume& volume, const std::string& digest) {
    return {.kind = session::DocumentKind::studyState,
            .study = openedVolume(volume, digest).study,
            .name = digest + " " + kKeptStateName};
}

// Moves the stored state to a name of its own if it cannot be merged into the new one: because it is
// unreadable (damaged, or from a newer program), or because both together would be too large.
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

std::optional<std::string> KeptStates::stateOf(const std::shared_ptr<const Volume>& volume,
                                               std::chrono::milliseconds patience) {
    try {
        const std::string digest = digests_.of(volume);
        auto found = std::make_shared<std::promise<std::optional<std::string>>>();
        auto future = found->get_future();
        thread_.post(StoreThread::Urgency::isWaitedFor, [this, found, id = stateIdOf(*volume, digest),
                                                         opened = openedVolume(*volume, digest)](
                                                            session::Store& store) {
            const auto document = store.getDocument(id);
            if (!document) messages_.tell(document.error());
            found->set_value(document && *document ? std::optional((*document)->json) : std::nullopt);
            opened_.record(store, opened);  // after the answer: it waits for the disk
        });
        found.reset();  // without a store the job is dropped with the promise: nobody waits
        if (future.wait_for(patience) == std::future_status::ready) return future.get();
        thread_.post(StoreThread::Urgency::isWaitedFor, [this](session::Store&) {
            messages_.tell({ErrorCode::inputNotUsable,
                            Text("How this study was left was not found in time."),
                            {},
                            Text("It is kept: open the study again to see it.")});
        });
    } catch (const std::exception&) {
        // The promise was dropped with the job, or there is no memory.
    }
    return std::nullopt;
}

void KeptStates::keepState(std::shared_ptr<const Volume> volume, std::string json,
                           std::shared_ptr<std::string> base) {
    // Urgent, so that a stateOf() that follows finds it.
    thread_.post(StoreThread::Urgency::isWaitedFor, [this, volume = std::move(volume), json = std::move(json),
                                                     base = std::move(base)](session::Store& store) {
        const std::string digest = digests_.of(volume);
        opened_.record(store, openedVolume(*volume, digest));
        const session::DocumentId id = stateIdOf(*volume, digest);
        const auto before = store.getDocument(id);
        if (!before) {
            messages_.tell(before.error());  // the store has set a damaged one aside
        } else if (*before) {
            const auto aside = setAsideIfNotMerged(store, id, **before, base.get(), json);
            if (!aside) return messages_.tell(aside.error());
        }
        bool holdsMore = false;
        const auto merge = [&](const std::optional<std::string>& stored) {
            const auto merged = stored && base ? scene::mergedState(*base, json, *stored) : std::nullopt;
            holdsMore = merged && merged->holdsMore;
            return merged ? merged->json : json;
        };
        // Lists all keys: those missing from the new text, such as a clip that was taken back, are removed.
        const std::vector<std::string> keys = scene::stateKeys();
        const std::vector<std::string_view> known(keys.begin(), keys.end());
        if (const auto done = store.changeDocument(id, kStateVersion, merge, known); !done)
            return messages_.tell(done.error());  // `base` stays, so the next save merges as this one
        if (base) *base = json;
        if (holdsMore)
            messages_.tell({ErrorCode::inputNotUsable,
                            Text("More was measured on this study than is shown here: another window has it "
                                 "open, or had."),
                            {},
                            Text("All of it is kept; open the study again to see it.")});
    });
}

}  // namespace macula::live
