#include "dicom/dose/dose_facts.h"

#include <algorithm>
#include <functional>
#include <set>

#include "dicom/read/dataset.h"
#include "dicom/read/sop_class.h"
#include "dicom/read/tags.h"

namespace macula::dicom {

namespace {

constexpr std::string_view kDose = "1.2.840.10008.5.1.4.1.1.481.2";
constexpr std::string_view kPlan = "1.2.840.10008.5.1.4.1.1.481.5";
constexpr std::string_view kIonPlan = "1.2.840.10008.5.1.4.1.1.481.8";

constexpr Tag kReferencedSopInstanceUid{0x0008, 0x1155};
constexpr Tag kDoseType{0x3004, 0x0004};
constexpr Tag kDoseSummationType{0x3004, 0x000A};
constexpr Tag kDoseReferences{0x300A, 0x0010};
constexpr Tag kDoseReferenceType{0x300A, 0x0020};
constexpr Tag kTargetPrescriptionDose{0x300A, 0x0026};
constexpr Tag kFractionGroups{0x300A, 0x0070};
constexpr Tag kFractionsPlanned{0x300A, 0x0078};
constexpr Tag kReferencedPlans{0x300C, 0x0002};

constexpr double kMostGy = 1000.0;           // a prescription above is no number of Gy
constexpr std::size_t kMostPlansRead = 200;  // of one study

std::set<std::string> plansOf(const Dataset& dose) {
    std::set<std::string> uids;
    for (const Dataset& item : dose.items(kReferencedPlans))
        if (auto uid = item.text(kReferencedSopInstanceUid)) uids.insert(*std::move(uid));
    return uids;
}

void readPlan(const Dataset& plan, DoseFacts& facts) {
    facts.isPlanHere = true;
    for (const Dataset& item : plan.items(kDoseReferences)) {
        if (item.text(kDoseReferenceType) != "TARGET") continue;
        const auto gy = item.number(kTargetPrescriptionDose);
        if (gy && *gy > 0.0 && *gy <= kMostGy) facts.prescriptionsGy.push_back(*gy);
    }
    std::ranges::sort(facts.prescriptionsGy, std::greater());
    const std::vector<Dataset> groups = plan.items(kFractionGroups);
    constexpr int kMostFractions = 1000;
    if (groups.size() == 1)
        facts.fractions =
            std::clamp(groups.front().integer(kFractionsPlanned).value_or(0), 0, kMostFractions);
}

void findPlan(const Scan& scan, const std::string& studyUid, const std::string& planUid, DoseFacts& facts) {
    std::size_t read = 0;
    for (const Study& study : scan.studies) {
        if (study.studyInstanceUid != studyUid) continue;
        for (const Series& series : study.series) {
            for (const OtherObject& object : series.objects) {
                if (object.sopClassUid != kPlan && object.sopClassUid != kIonPlan) continue;
                if (++read > kMostPlansRead) return;
                const HeaderFile file = readHeader(object.file);
                if (!file.header || file.header->text(tag::kSopInstanceUid) != planUid) continue;
                return readPlan(*file.header, facts);
            }
        }
    }
}

}  // namespace

std::optional<double> DoseFacts::prescribedGy() const {
    if (!isInGy() || !isOfPlan() || prescriptionsGy.empty()) return std::nullopt;
    return prescriptionsGy.front();
}

std::optional<DoseFacts> doseFactsOf(const Scan& scan, const Stack& stack) {
    if (stack.frames.empty() || !stack.frames.front().instance) return std::nullopt;
    const Instance& instance = *stack.frames.front().instance;
    if (instance.sopClassUid != kDose) return std::nullopt;
    DoseFacts facts;
    const HeaderFile file = readHeader(instance.file);
    if (!file.header) return facts;
    facts.units = file.header->text(tag::kDoseUnits).value_or("");
    facts.type = file.header->text(kDoseType).value_or("");
    facts.summation = file.header->text(kDoseSummationType).value_or("");
    const std::set<std::string> plans = plansOf(*file.header);
    facts.plansNamed = plans.size();
    if (plans.size() == 1)
        findPlan(scan, file.header->text(tag::kStudyInstanceUid).value_or(""), *plans.begin(), facts);
    return facts;
}

}  // namespace macula::dicom
