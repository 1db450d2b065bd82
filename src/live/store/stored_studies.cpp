#include "live/store/stored_studies.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <iterator>
#include <vector>

namespace macula::live {

namespace fs = std::filesystem;

namespace {

using session::DocumentKind;

constexpr std::array kDocumentKinds{
    DocumentKind::studyState, DocumentKind::view,      DocumentKind::layout, DocumentKind::measurement,
    DocumentKind::preset,     DocumentKind::favourite, DocumentKind::clip,   DocumentKind::calibration};
constexpr std::size_t kMostNamed = 8;

template <class T>
void append(session::Listing<T>& all, session::Listing<T> more) {
    all.damaged += more.damaged;
    std::ranges::move(more.entries, std::back_inserter(all.entries));
}

bool isOfDigits(std::string_view text) {
    return text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

Error ambiguous(std::string_view digits, const std::vector<const session::StudyEntry*>& found) {
    std::vector<std::string> names;
    for (const session::StudyEntry* study : found) {
        if (names.size() == kMostNamed) {
            names.emplace_back("...");
            break;
        }
        names.push_back(study->identity.substr(0, std::max(kShortDigits, digits.size() + kFewestDigits)));
    }
    return {ErrorCode::usage,
            Text("{} studies begin with {}.", found.size(), digits),
            {},
            Text("Give more digits: {}.", fmt::format("{}", fmt::join(names, ", ")))};
}

}  // namespace

bool isNothingStored(const fs::path& folder) {
    std::error_code error;
    const fs::file_status status = fs::status(folder, error);
    if (status.type() == fs::file_type::not_found) return true;
    return fs::is_directory(status) && fs::is_empty(folder, error) && !error;
}

Error nothingStored(const fs::path& folder) {
    return {ErrorCode::usage, Text("Nothing is stored yet."), folder.string(),
            Text("Check --folder if you expected studies here.")};
}

std::string shortOf(std::string_view digest) {
    return std::string(digest.substr(0, kShortDigits));
}

Result<session::StudyEntry> studyOfPrefix(const session::Listing<session::StudyEntry>& studies,
                                          std::string_view typed) {
    std::string digits(typed);
    std::ranges::transform(digits, digits.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const Text hint = Text("macula sessions list shows those there are.");
    if (digits.size() < kFewestDigits || !isOfDigits(digits))
        return Error{
            ErrorCode::usage,
            Text("A study is named by the first {} or more of its digits, 0 to 9 and a to f.", kFewestDigits),
            {},
            hint};
    std::vector<const session::StudyEntry*> found;
    for (const session::StudyEntry& study : studies.entries)
        if (study.identity.starts_with(digits)) found.push_back(&study);
    if (found.empty())
        return Error{ErrorCode::usage, Text("No stored study begins with {}.", digits), {}, hint};
    if (found.size() > 1) return ambiguous(digits, found);
    return *found.front();
}

Result<StudiesByVolume> studiesByVolume(session::Store& store, std::span<const session::StudyEntry> studies) {
    StudiesByVolume found;
    for (const session::StudyEntry& study : studies) {
        MACULA_TRY(const auto series, store.listSeries(study.identity));
        for (const session::SeriesEntry& one : series.entries)
            for (const std::string& volume : one.volumes) found[volume].insert(study.identity);
    }
    return found;
}

Result<StoredStudies> storedStudies(session::Store& store) {
    StoredStudies all{.folder = store.folder()};
    MACULA_TRY(all.studies, store.listStudies());
    MACULA_TRY(const StudiesByVolume studies, studiesByVolume(store, all.studies.entries));
    MACULA_TRY(const auto models, store.listModels());
    for (const session::ModelInfo& model : models.entries) {
        if (!model.aside.empty()) {
            ++all.modelsAside;
            continue;
        }
        all.models.add(model);
        if (!studies.contains(model.key.volume)) all.withoutStudy.add(model);
    }
    return all;
}

Result<StoredStudy> storedStudy(session::Store& store, const session::StudyEntry& study) {
    StoredStudy found{.study = study};
    MACULA_TRY(found.series, store.listSeries(study.identity));
    std::set<std::string> volumes;
    for (const session::SeriesEntry& series : found.series.entries)
        volumes.insert(series.volumes.begin(), series.volumes.end());
    for (const std::string& volume : volumes) {
        MACULA_TRY(auto models, store.listModels(volume));
        append(found.models, std::move(models));
    }
    std::ranges::stable_sort(found.models.entries, std::greater(), &session::ModelInfo::usedMs);
    for (const DocumentKind kind : kDocumentKinds) {
        MACULA_TRY(auto documents, store.listDocuments(kind, study.identity));
        append(found.documents, std::move(documents));
    }
    return found;
}

}  // namespace macula::live
