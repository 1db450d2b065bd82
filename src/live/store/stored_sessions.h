// What the store of sessions holds, gathered for who wants to know all of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "session/store.h"

namespace macula::app {

// True where no store was made yet: no folder, or an empty one. To open one would make it.
bool isNothingStored(const std::filesystem::path& folder);
Error nothingStored(const std::filesystem::path& folder);

// A study is named by the first digits of its identity, as many as make it the only one, at least these.
inline constexpr std::size_t kFewestDigits = 4;
inline constexpr std::size_t kShortDigits = 12;  // as lists show them
std::string shortOf(std::string_view digest);

// The study whose identity begins so. Fails with usage where it is none, or several, or no such digits.
Result<session::StudyEntry> studyOfPrefix(const session::Listing<session::StudyEntry>& studies,
                                          std::string_view typed);

struct ModelSum {
    std::size_t models = 0;
    std::uint64_t bytes = 0;

    void add(const session::ModelInfo& model) {
        ++models;
        bytes += model.bytes;
    }
};

struct StoredSessions {
    std::filesystem::path folder;
    session::Listing<session::StudyEntry> studies;  // latest opened first
    ModelSum models;                                // of all studies and none, but for those set aside
    ModelSum withoutStudy;                          // of these: of files that belong to no study
    std::size_t modelsAside = 0;
};
Result<StoredSessions> storedSessions(session::Store& store);

struct StoredStudy {
    session::StudyEntry study;
    session::Listing<session::SeriesEntry> series;       // latest opened first
    session::Listing<session::ModelInfo> models;         // latest used first, those set aside too
    session::Listing<session::DocumentEntry> documents;  // by kind and name
};
Result<StoredStudy> storedStudy(session::Store& store, const session::StudyEntry& study);

// The studies that each volume belongs to, by identity. Volumes of none are not in it.
using StudiesByVolume = std::map<std::string, std::set<std::string>>;
Result<StudiesByVolume> studiesByVolume(session::Store& store, std::span<const session::StudyEntry> studies);

}  // namespace macula::app
