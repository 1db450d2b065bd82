// The volumes that a folder holds, to choose from.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "dicom/read/referenced_frames.h"
#include "dicom/scan.h"
#include "study/open/identity.h"

namespace macula::study {

struct FoundVolume {
    const dicom::Study* study = nullptr;
    const dicom::Series* series = nullptr;
    const dicom::Stack* stack = nullptr;
};

// Immutable. Its texts may name a patient.
class FoundVolumes {
  public:
    enum class Extent {
        whole,
        soFar,  // the scan still runs: series without stacks, and no volumes
    };
    explicit FoundVolumes(dicom::Scan scan, Extent extent = Extent::whole);
    FoundVolumes(const FoundVolumes&) = delete;
    FoundVolumes& operator=(const FoundVolumes&) = delete;

    bool isWhole() const { return extent_ == Extent::whole; }
    const dicom::Scan& scan() const { return scan_; }
    const std::vector<FoundVolume>& volumes() const { return volumes_; }         // in the order of the scan
    const std::string& key(std::size_t index) const { return keys_.at(index); }  // volumeKeys
    // One line each; with the patient and the date of the study where there are several.
    std::vector<Text> titles() const;

    struct ChosenVolume {
        std::size_t index = 0;
        Text why;  // a sentence, without patient data
    };
    // The best volume. inputNotUsable when there is none; the error's place is `folder`.
    Result<ChosenVolume> best(const std::filesystem::path& folder) const;
    // The best volume that is not in `failed`, if possible of the same patient as the first in there. Nothing
    // when none is left. `failed` is not empty.
    std::optional<std::size_t> bestWithout(const std::vector<std::size_t>& failed) const;
    bool areOfOnePatient(std::size_t a, std::size_t b) const;  // indices
    // The best volume of the series with that UID, or of that number in the list of `macula info`;
    // inputNotUsable when there is none, or when several studies have one.
    Result<ChosenVolume> ofSeries(const std::string& wanted, const std::filesystem::path& folder) const;
    // The volume that `file` belongs to, never another: the folder may hold other patients. inputNotUsable.
    Result<ChosenVolume> holding(const std::filesystem::path& file) const;

  private:
    std::optional<std::size_t> indexOf(const dicom::Stack* stack) const;

    dicom::Scan scan_;
    Extent extent_;
    std::vector<FoundVolume> volumes_;
    std::vector<std::string> keys_;
};

// The stacks of a scan that can be volumes, in its order. The scan must outlive them.
std::vector<FoundVolume> volumesOf(const dicom::Scan& scan);

// The images of a stack by UID, each once, with the frames of a multi-frame file. Empty where an image has no
// UID.
std::vector<dicom::ReferencedFrames> imagesOf(const dicom::Stack& stack);

// The frame of reference UID that all images share; empty where they differ or have none.
std::string frameOfReferenceOf(const dicom::Stack& stack);

Identity identityOf(const FoundVolume& volume);
// The identity without a series.
Identity identityOf(const dicom::Study& study);

// Identifies each volume within its series by attributes of its images. Other files in the folder, of another
// phase or no volume, do not change the key; they may change the place of the volume in the list.
// For each: a digest of modality, frame of reference, orientation, and all attributes that split a series
// (rules/split.json: times, phases, echoes, kernels) and that all images of the volume share. Of volumes of
// one series with equal digests, the second gets "-2", and so on. Reads each image once; FoundVolumes::key()
// keeps the result.
std::vector<std::string> volumeKeys(std::span<const FoundVolume> volumes);

}  // namespace macula::study
