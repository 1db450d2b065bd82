#include "net/web/stow_answer.h"

#include <array>

#include "base/parsing.h"
#include "net/archive/file_meta.h"
#include "net/web/dicom_json.h"

namespace macula::net {

namespace {

namespace stow {
constexpr std::uint32_t kSopInstanceUid = 0x00081155;  // Referenced SOP Instance UID
constexpr std::uint32_t kFailureReason = 0x00081197;
constexpr std::uint32_t kFailedSequence = 0x00081198;
constexpr std::uint32_t kReferencedSequence = 0x00081199;
}  // namespace stow

constexpr std::array kOfStow{stow::kSopInstanceUid, stow::kFailureReason, stow::kFailedSequence,
                             stow::kReferencedSequence};

}  // namespace

Result<StowAnswer> stowAnswerIn(std::string_view text) {
    StowAnswer answer;
    if (trimmed(text).empty()) return answer;
    constexpr std::size_t kMostAnswers = 1000;
    MACULA_TRY(const auto datasets, dicomJsonOf(text, kOfStow, kMostAnswers));
    for (const JsonDataset& dataset : datasets) {
        for (const JsonDataset& item : dataset.items(stow::kReferencedSequence))
            if (auto uid = item.first(stow::kSopInstanceUid); isUid(uid))
                answer.stored.insert(std::move(uid));
        for (const JsonDataset& item : dataset.items(stow::kFailedSequence)) {
            constexpr double kMostReason = 0xFFFF;
            const auto reason = finiteNumber(item.first(stow::kFailureReason));
            const bool isReason = reason && *reason >= 0 && *reason <= kMostReason;
            if (auto uid = item.first(stow::kSopInstanceUid); isUid(uid))
                answer.refused.emplace(std::move(uid), isReason ? static_cast<int>(*reason) : 0);
        }
    }
    return answer;
}

StowReason stowReason(int failureReason) {
    const int family = failureReason & 0xFF00;
    const int kind = failureReason & 0xF000;
    if (failureReason == 0x0122)
        return {Text("The archive does not store objects of this kind."),
                Text("Ask its administrator to accept the kind, or send them elsewhere.")};
    if (failureReason == 0x0124)
        return {Text("The archive does not allow this user to store."),
                Text("Ask its administrator for the right to store.")};
    if (failureReason == 0x0111)
        return {Text("The archive has an object with this identifier already."),
                Text("Look there: if it is the same one, nothing is to be done.")};
    if (failureReason == 0xC122)
        return {Text("The archive does not store this encoding of the image."),
                Text("Ask its administrator which encodings it takes.")};
    if (failureReason == 0xC409)
        return {Text("The object belongs to another study than the one it was sent to."),
                Text("Send it again without the others.")};
    if (family == 0xA700)
        return {Text("The archive has no room left."), Text("Tell its administrator, and send again later.")};
    if (family == 0xA900)
        return {Text("The archive finds that the object does not hold what its kind requires."),
                Text("Ask whoever made the object; Macula sends it unchanged.")};
    if (kind == 0xC000)
        return {Text("The archive does not understand the object."),
                Text("Check that the file opens here, and ask the administrator of the archive.")};
    if (failureReason == 0x0110)
        return {Text("The archive failed while it stored the object."),
                Text("Send it again; if it fails again, ask the administrator of the archive.")};
    if (failureReason == 0)
        return {Text("The archive did not store the object, and does not say why."),
                Text("Ask the administrator of the archive.")};
    return {Text("The archive did not store the object, for its reason {:04X}.", failureReason),
            Text("Ask the administrator of the archive.")};
}

}  // namespace macula::net
