#include "live/store/kept_measurements.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "live/store/kept_states.h"
#include "scene/followup/follow_up.h"
#include "scene/state/study_state.h"

namespace macula::live {

namespace {

constexpr const char* kGoneName = "follow-up";
constexpr const char* kGone = "gone";
constexpr std::int64_t kGoneVersion = 1;
constexpr std::size_t kLongestLesion = 200;  // bytes

session::DocumentId goneIdOf(const std::string& study) {
    return {.kind = session::DocumentKind::measurement, .study = study, .name = kGoneName};
}

// Leaves out what is no lesion.
std::vector<std::string> goneFrom(const std::string& text) {
    const auto json = nlohmann::json::parse(text, nullptr, false);
    std::vector<std::string> gone;
    if (!json.is_object() || !json.contains(kGone) || !json[kGone].is_array()) return gone;
    for (const auto& each : json[kGone]) {
        if (gone.size() == scene::kMostFollowedLesions) break;
        if (!each.is_string()) continue;
        const auto& lesion = each.get_ref<const std::string&>();
        if (!lesion.empty() && lesion.size() <= kLongestLesion) gone.push_back(lesion);
    }
    return gone;
}

bool isStateOfVolume(const std::string& name) {
    return name.ends_with(std::string(" ") + kKeptStateName);
}

}  // namespace

Result<std::vector<KeptMeasurements>> keptMeasurements(session::Store& store,
                                                       std::span<const StudyToRead> studies) {
    std::vector<KeptMeasurements> all;
    for (const StudyToRead& each : studies) {
        KeptMeasurements& kept = all.emplace_back();
        if (each.study.empty()) continue;
        MACULA_TRY(const auto gone, store.getDocument(goneIdOf(each.study)));
        if (gone) kept.gone = goneFrom(gone->json);
        MACULA_TRY(const auto documents, store.listDocuments(session::DocumentKind::studyState, each.study));
        kept.unreadable += documents.damaged;
        for (const session::DocumentEntry& entry : documents.entries) {
            const std::string& name = entry.id.name;
            if (!isStateOfVolume(name)) continue;
            if (!each.exceptVolume.empty() && name.starts_with(each.exceptVolume)) continue;
            MACULA_TRY(const auto document, store.getDocument(entry.id));
            if (!document) continue;
            auto state = scene::studyStateFromJson(document->json, {});
            if (!state) {
                ++kept.unreadable;
                continue;
            }
            ++kept.volumes;
            for (slices::Measurement& measurement : state->measurements)
                kept.measurements.push_back(std::move(measurement));
        }
    }
    return all;
}

Result<void> keepGone(session::Store& store, const std::string& study, std::span<const std::string> lesions) {
    const nlohmann::json json{{kGone, std::vector<std::string>(lesions.begin(), lesions.end())}};
    constexpr std::string_view kKnown[] = {kGone};
    return store.putDocument(goneIdOf(study), kGoneVersion,
                             json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), kKnown);
}

}  // namespace macula::live
