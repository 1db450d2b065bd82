#include "dicom/documents/report.h"

#include <string>
#include <utility>

#include "dicom/documents/content_tree.h"
#include "dicom/documents/document_tags.h"
#include "dicom/documents/document_values.h"

namespace macula::dicom {

namespace {

namespace tags = document_tag;

constexpr std::size_t kMostObservers = 20;

void addVerification(StudyDocument& document, const Dataset& header) {
    const std::string flag = header.shortText(tags::kVerificationFlag);
    const std::vector<Dataset> observers = header.items(tags::kVerifyingObservers);
    if (flag != "VERIFIED") {
        if (flag == "UNVERIFIED")
            document.status.push_back(Text("Not verified by anybody."));
        else
            document.status.push_back(Text("The document does not say whether anybody verified it."));
        if (!observers.empty())
            document.notes.push_back(
                Text("The document names who verified it, but does not say that it is verified."));
        return;
    }
    document.isVerified = true;
    if (observers.empty()) {
        document.status.push_back(Text("Verified."));
        document.notes.push_back(Text("The document says that it is verified, and not by whom."));
    }
    for (std::size_t i = 0; i < std::min(observers.size(), kMostObservers); ++i) {
        const Dataset& observer = observers[i];
        std::string who = personOf(observer.text(tags::kVerifyingObserver).value_or(""));
        const std::string organisation = inLines(observer.text(tags::kVerifyingOrganisation).value_or(""));
        if (!organisation.empty()) who += (who.empty() ? "" : ", ") + organisation;
        const std::string when = dateTimeOf(observer.text(tags::kVerificationDateTime).value_or(""));
        if (who.empty() && when.empty())
            document.status.push_back(Text("Verified."));
        else if (who.empty())
            document.status.push_back(Text("Verified on {}.", when));
        else if (when.empty())
            document.status.push_back(Text("Verified by {}.", who));
        else
            document.status.push_back(Text("Verified by {} on {}.", who, when));
    }
}

// PS3.3 C.17.2.
void addStatus(StudyDocument& document, const Dataset& header) {
    const std::string completion = header.shortText(tags::kCompletionFlag);
    if (completion == "COMPLETE")
        document.status.push_back(Text("Complete."));
    else if (completion == "PARTIAL")
        document.status.push_back(Text("Partial: some of its content may be missing."));
    else
        document.status.push_back(Text("The document does not say whether it is complete."));
    if (const Text why = wordsOf(header, tags::kCompletionDescription); !why.empty())
        document.status.push_back(why);
    const std::string preliminary = header.shortText(tags::kPreliminaryFlag);
    if (preliminary == "PRELIMINARY") document.status.push_back(Text("Preliminary."));
    if (preliminary == "FINAL") document.status.push_back(Text("Final."));
    addVerification(document, header);
    if (header.itemCount(tags::kPredecessors) > 0)
        document.status.push_back(Text("It follows an earlier document, which it amends or replaces."));
}

}  // namespace

void readReport(StudyDocument& document, const Dataset& header) {
    document.titleCode = codeIn(header, tags::kConceptName);
    document.title = wordsOf(document.titleCode);
    if (document.title.empty()) document.notes.push_back(Text("The document has no title."));
    // A selection has no status (PS3.3 C.17.6.2).
    if (document.kind == StudyDocument::Kind::report) addStatus(document, header);
    if (header.shortText(tags::kValueType) != "CONTAINER")
        document.notes.push_back(Text("The document does not begin as the standard wants it."));
    addContent(document, header);
    if (document.entries.empty()) document.notes.push_back(Text("The document is empty."));
}

}  // namespace macula::dicom
