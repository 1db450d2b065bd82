// Any text as a link, which any web page can make. What is understood names studies and nothing else, and
// what is refused is told without repeating it.
#include <cstdint>
#include <string_view>

#include "base/check.h"
#include "base/printable.h"
#include "base/utf8.h"
#include "net/archive/file_meta.h"
#include "study/link/link_text.h"
#include "study/link/study_link.h"

namespace macula::study {
namespace {

constexpr std::size_t kMostBytesOfIdentifier = 64;

void checkIdentifier(const std::string& text) {
    MACULA_CHECK_LE(text.size(), kMostBytesOfIdentifier);
    MACULA_CHECK(isValidUtf8(text) && printable(text) == text);
    MACULA_CHECK(text.find_first_of("*?\\") == std::string::npos);
}

void checkLink(const StudyLink& link) {
    const bool namesSomething =
        !link.studyInstanceUids.empty() || !link.accessionNumbers.empty() || !link.patientId.empty();
    MACULA_CHECK(namesSomething);
    for (const std::string& uid : link.studyInstanceUids) MACULA_CHECK(net::isUid(uid));
    for (const std::string& number : link.accessionNumbers) checkIdentifier(number);
    checkIdentifier(link.patientId);
    checkIdentifier(link.issuer);
    for (const std::string* day : {&link.patientBirthDate, &link.dateFrom, &link.dateTo}) {
        MACULA_CHECK(day->empty() || day->size() == 8);
        MACULA_CHECK(day->find_first_not_of("0123456789") == std::string::npos);
    }
    MACULA_CHECK(isValidUtf8(link.archive) && printable(link.archive) == link.archive);
    MACULA_CHECK(!link.mostRecent || *link.mostRecent > 0);
}

}  // namespace
}  // namespace macula::study

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace macula;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto link = study::studyLinkOf(text);
    if (link) {
        MACULA_CHECK(study::isLink(text) && text.size() <= study::kMostBytesOfLink);
        study::checkLink(*link);
        return 0;
    }
    MACULA_CHECK(!link.error().message.empty() && !link.error().hint.empty() && link.error().where.empty());
    return 0;
}
