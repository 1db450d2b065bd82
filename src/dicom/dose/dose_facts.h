// What a radiotherapy dose (PS3.3 A.18) says of itself, and what its plan prescribes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dicom/scan.h"

namespace macula::dicom {

struct DoseFacts {
    std::string units;      // DoseUnits, as in the file: "GY", "RELATIVE"; may be empty
    std::string type;       // DoseType: "PHYSICAL", "EFFECTIVE", "ERROR"; may be empty
    std::string summation;  // DoseSummationType: "PLAN", "BEAM", …; may be empty
    std::size_t plansNamed = 0;
    bool isPlanHere = false;  // the only plan that it names is in the scan, and can be read
    std::vector<double>
        prescriptionsGy;  // TargetPrescriptionDose of that plan's targets, above 0, descending
    int fractions = 0;    // NumberOfFractionsPlanned of its only group; 0: not known

    bool isInGy() const { return units == "GY"; }
    // Of a whole plan. Others are a part: of a beam, a fraction or a session.
    bool isOfPlan() const { return summation == "PLAN"; }
    // The highest prescription of the plan that this is the whole dose of; nothing for a part of it, and for
    // values that are not in Gy.
    std::optional<double> prescribedGy() const;

    bool operator==(const DoseFacts&) const = default;
};

// Reads the headers of the dose and of the plans of its study. Nothing if the stack is no dose.
std::optional<DoseFacts> doseFactsOf(const Scan& scan, const Stack& stack);

}  // namespace macula::dicom
