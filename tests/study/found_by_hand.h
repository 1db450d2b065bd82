// What a folder holds, made by hand: no file is there.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "study/open/found_volumes.h"

namespace macula::study::test {

inline dicom::Stack stackOf(std::size_t images, const std::string& modality) {
    dicom::Stack stack;
    stack.modality = modality;
    stack.columns = 512;
    stack.rows = 256;
    const auto instance = std::make_shared<const dicom::Instance>();
    for (std::size_t k = 0; k < images; ++k) {
        dicom::Frame frame;
        frame.instance = instance;
        stack.frames.push_back(std::move(frame));
    }
    return stack;
}

inline dicom::Stack volumeOf(std::size_t images, const std::string& modality = "CT") {
    dicom::Stack stack = stackOf(images, modality);
    for (std::size_t k = 0; k < images; ++k) stack.slices.push_back({.below = k, .above = k, .weight = 0.0});
    stack.spacingMm = glm::dvec3(0.7, 0.5, 1.25);
    stack.worldFromVoxel = glm::dmat4(1.0);
    return stack;
}

inline dicom::Stack refused(std::string_view key, const std::string& modality = "CT") {
    dicom::Stack stack = stackOf(1, modality);
    stack.messages.push_back(dicom::message(key));
    return stack;
}

inline dicom::Series seriesOf(int number, const std::string& description, std::vector<dicom::Stack> stacks,
                              const std::string& modality = "CT") {
    dicom::Series series;
    series.number = number;
    series.description = description;
    series.modality = modality;
    series.stacks = std::move(stacks);
    return series;
}

inline dicom::Study studyOf(int patient, const std::string& name, const std::string& date,
                            const std::string& description, std::vector<dicom::Series> series) {
    dicom::Study study;
    study.patient = patient;
    study.patientName = name;
    study.patientId = "ID" + std::to_string(patient);
    study.patientBirthDate = "19700102";
    study.patientSex = "F";
    study.date = date;
    study.description = description;
    study.series = std::move(series);
    return study;
}

// Patients with one study and `series` CT volumes.
inline std::shared_ptr<const FoundVolumes> manySeries(std::size_t series) {
    dicom::Scan scan;
    std::vector<dicom::Series> all;
    for (std::size_t n = 0; n < series; ++n)
        all.push_back(seriesOf(int(n) + 1, "Thorax " + std::to_string(n), {volumeOf(2)}));
    scan.studies.push_back(studyOf(0, "DOE^JANE", "20200102", "Chest", std::move(all)));
    scan.patients = 1;
    return std::make_shared<const FoundVolumes>(std::move(scan));
}

// Two patients: "Müller, Jörg" with two studies, CT and MR; "Doe, Jane" with what cannot be opened. Volumes:
// 0 the older CT, 1 and 2 the phases of the MR, 3 Doe's.
inline std::shared_ptr<const FoundVolumes> twoPatients() {
    dicom::Scan scan;
    dicom::Stack first = volumeOf(30, "MR");
    first.splitBy = {{"EchoTime", "4.6"}};
    dicom::Stack second = volumeOf(30, "MR");
    second.splitBy = {{"EchoTime", "9.2"}};
    second.phase = 1;
    second.phases = 2;
    dicom::Stack odd = volumeOf(20);
    odd.messages.push_back(dicom::message(dicom::key::kLossySource));
    dicom::Series report = seriesOf(9, "Report of Jane", {}, "SR");
    report.objects.push_back({.file = "/doe/report",
                              .sopClassUid = "",
                              .kind = Text("Structured report"),
                              .referencedSeriesUids = {}});
    report.messages.push_back(
        dicom::message(dicom::key::kUnsupportedSopClass, {{"kind", std::string("Structured report")}}));
    dicom::Series unreadable = seriesOf(10, "Broken", {});
    unreadable.messages.push_back(
        dicom::message(dicom::key::kNoValidInstances, {{"count", std::int64_t{4}}}));

    scan.studies.push_back(studyOf(0, "Müller^Jörg", "20190203", "Abdomen of Jörg",
                                   {seriesOf(1, "Scout", {refused(dicom::key::kLocalizer)}),
                                    seriesOf(2, "Portal venous", {volumeOf(100)})}));
    scan.studies.push_back(
        studyOf(0, "Müller^Jörg", "20200304", "Head", {seriesOf(3, "T2 two echoes", {first, second}, "MR")}));
    scan.studies.push_back(
        studyOf(1, "DOE^JANE", "20210405", "Thorax",
                {seriesOf(4, "Lung <b>sharp</b>", {odd, refused(dicom::key::kSingleSlice)}),
                 std::move(report), std::move(unreadable)}));
    scan.patients = 2;
    for (int n = 0; n < 3; ++n)
        scan.skipped.push_back({"/doe/jane/a", dicom::message(dicom::key::kDamagedFile), ""});
    scan.skipped.push_back({"/doe/jane/b", dicom::message(dicom::key::kUnreadableFile), ""});
    return std::make_shared<const FoundVolumes>(std::move(scan));
}

}  // namespace macula::study::test
