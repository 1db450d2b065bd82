#include "study/dose/found_dose.h"

#include <algorithm>
#include <utility>

namespace macula::study {

namespace {

Text kindText(const dicom::DoseFacts& facts) {
    const std::string& summation = facts.summation;
    if (summation == "PLAN") return Text("Dose of a whole plan");
    if (summation == "MULTI_PLAN") return Text("Dose of several plans");
    if (summation == "PLAN_OVERVIEW") return Text("Dose of an overview of plans");
    if (summation == "FRACTION" || summation == "FRACTION_SESSION") return Text("Dose of a fraction");
    if (summation == "BEAM" || summation == "BEAM_SESSION") return Text("Dose of a beam");
    if (summation == "BRACHY" || summation == "BRACHY_SESSION") return Text("Dose of a source");
    if (summation == "CONTROL_POINT") return Text("Dose of a part of a beam");
    return Text("Dose, and nothing says of what");
}

bool mayBeOn(const FoundVolumes& found, const FoundVolume& dose, const FoundVolume& volume) {
    return dicom::mayBeOnePatient(found.scan(), dose.study->patient, volume.study->patient);
}

}  // namespace

std::vector<FoundDose> dosesOn(const FoundVolumes& found, std::size_t volume) {
    std::vector<FoundDose> doses;
    if (volume >= found.volumes().size()) return doses;
    const FoundVolume& on = found.volumes()[volume];
    const std::string frame = frameOfReferenceOf(*on.stack);
    if (frame.empty() || on.series->modality == "RTDOSE") return doses;
    for (std::size_t i = 0; i < found.volumes().size(); ++i) {
        const FoundVolume& each = found.volumes()[i];
        if (i == volume || each.series->modality != "RTDOSE" || !mayBeOn(found, each, on) ||
            frameOfReferenceOf(*each.stack) != frame)
            continue;
        if (auto facts = dicom::doseFactsOf(found.scan(), *each.stack))
            doses.push_back({i, *std::move(facts)});
    }
    std::stable_partition(doses.begin(), doses.end(),
                          [](const FoundDose& each) { return each.facts.isOfPlan(); });
    return doses;
}

Text doseText(const dicom::DoseFacts& facts) {
    std::vector<Text> parts{kindText(facts)};
    if (const auto gy = facts.prescribedGy()) {
        parts.push_back(facts.fractions > 0
                            ? Text("{:.4g} Gy prescribed in {} fractions", *gy, facts.fractions)
                            : Text("{:.4g} Gy prescribed", *gy));
    }
    return Text::joined(std::move(parts), ", ");
}

std::vector<Text> doseNotes(const dicom::DoseFacts& facts) {
    std::vector<Text> notes;
    if (!facts.isInGy())
        notes.push_back(Text("The values of the dose are relative to a reference, and not in Gy."));
    if (facts.type == "ERROR") notes.push_back(Text("It is a difference between doses, and no dose."));
    if (facts.type == "EFFECTIVE")
        notes.push_back(Text("It is an effective dose: the planning system weighted the physical one."));
    if (!facts.isOfPlan())
        notes.push_back(Text("It is not the dose of one whole plan: no prescription applies to it."));
    else if (facts.isInGy() && facts.plansNamed != 1)
        notes.push_back(Text("It does not name one plan: the prescription is not known."));
    else if (facts.isInGy() && !facts.isPlanHere)
        notes.push_back(Text("Its plan is not in the folder: the prescription is not known."));
    else if (facts.isInGy() && facts.prescriptionsGy.empty())
        notes.push_back(Text("Its plan prescribes no dose to a target."));
    if (facts.prescribedGy() && facts.prescriptionsGy.size() > 1 &&
        facts.prescriptionsGy.back() != facts.prescriptionsGy.front())
        notes.push_back(
            Text("Its plan has {} prescriptions, from {:.4g} to {:.4g} Gy: percentages are of the "
                 "highest.",
                 facts.prescriptionsGy.size(), facts.prescriptionsGy.back(), facts.prescriptionsGy.front()));
    return notes;
}

}  // namespace macula::study
