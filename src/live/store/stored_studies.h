// The content of the study store, gathered for lists and reports.
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

namespace macula::live {

// True if no store was made yet: the folder is missing or empty. Opening a store would create it.
bool isNothingStored(const std::filesystem::path& folder);
Error nothingStored(const std::filesystem::path& folder);

// A study can be named by the first digits of its identity: as many as make it unique, and at least these.
inline constexpr std::size_t kFewestDigits = 4;
inline constexpr std::size_t kShortDigits = 12;  // as lists show them
std::string shortOf(std::string_view digest);

// The study whose identity begins with `typed`. Fails with usage for no or several matches, or for other
// characters than digits.
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

struct StoredStudies {
    std::filesystem::path folder;
    session::Listing<session::StudyEntry> studies;  // latest opened first
    ModelSum models;                                // with or without a study, except those set aside
    ModelSum withoutStudy;                          // those of `models` that belong to no study
    std::size_t modelsAside = 0;
};
Result<StoredStudies> storedStudies(session::Store& store);

struct StoredStudy {
    session::StudyEntry study;
    session::Listing<session::SeriesEntry> series;       // latest opened first
    session::Listing<session::ModelInfo> models;         // latest used first; includes those set aside
    session::Listing<session::DocumentEntry> documents;  // by kind and name
};
Result<StoredStudy> storedStudy(session::Store& store, const session::StudyEntry& study);

// The studies of each volume, by identity. Volumes without a study are left out.
using StudiesByVolume = std::map<std::string, std::set<std::string>>;
Result<StudiesByVolume> studiesByVolume(session::Store& store, std::span<const session::StudyEntry> studies);

}  // namespace macula::live
