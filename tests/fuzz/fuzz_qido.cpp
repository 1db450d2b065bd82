// Any text as the JSON that an archive answers with: to searches, to what it was sent, and as the first bytes
// of a file. What is found can be used.
#include <cstdint>
#include <span>
#include <string_view>

#include "base/check.h"
#include "base/utf8.h"
#include "net/archive/file_meta.h"
#include "net/web/qido_answers.h"
#include "net/web/stow_answer.h"

namespace macula::net {
namespace {

template <class T>
bool isTold(const Result<T>& result) {
    return !result.error().message.empty() && !result.error().hint.empty();
}

void readStudies(std::string_view text) {
    const auto page = studiesInJson(text);
    if (!page) return MACULA_CHECK(isTold(page));
    for (const FoundStudy& study : page->found) {
        MACULA_CHECK(isUid(study.studyInstanceUid));
        MACULA_CHECK(isValidUtf8(study.patientName) && isValidUtf8(study.description));
        for (const auto& modality : study.modalities) MACULA_CHECK(!modality.empty());
    }
    MACULA_CHECK_LE(page->found.size() + page->unusable, page->datasets);
}

void readOthers(std::string_view text) {
    const auto series = seriesInJson(text);
    if (!series) MACULA_CHECK(isTold(series));
    const auto instances = instancesInJson(text);
    if (!instances) return MACULA_CHECK(isTold(instances));
    for (const FoundInstance& instance : instances->found)
        MACULA_CHECK(instance.seriesInstanceUid.empty() || isUid(instance.seriesInstanceUid));
}

void readStow(std::string_view text) {
    const auto answer = stowAnswerIn(text);
    if (!answer) return MACULA_CHECK(isTold(answer));
    for (const auto& [uid, reason] : answer->refused) {
        MACULA_CHECK(isUid(uid));
        MACULA_CHECK(!stowReason(reason).why.empty());
    }
}

void readMeta(std::span<const std::byte> bytes) {
    const auto meta = fileMetaOf(bytes);
    if (!meta) return;
    MACULA_CHECK_LE(meta->datasetOffset, bytes.size());
    MACULA_CHECK(meta->sopInstanceUid.empty() || isUid(meta->sopInstanceUid));
}

}  // namespace
}  // namespace macula::net

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace macula::net;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    readStudies(text);
    readOthers(text);
    readStow(text);
    readMeta(std::as_bytes(std::span(data, size)));
    return 0;
}
