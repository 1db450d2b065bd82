// Reads a folder and finds its patients, studies, series and volumes. Content decides what is DICOM, never a
// file's name.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/stack/series.h"

namespace macula::dicom {

// For the clinical display only: every field may name a patient. Text is UTF-8.
struct Study {
    std::string studyInstanceUid;
    std::string date;  // YYYYMMDD as in the file, or empty
    std::string description;
    std::string patientName;  // components separated by ^, representations by = (PS3.5 6.2.1)
    std::string patientId;
    std::vector<Series> series;    // by number, then UID
    std::string patientBirthDate;  // YYYYMMDD as in the file, or empty
    std::string patientSex;        // M, F, O, or empty
    int patient = 0;               // from 0; shared by studies of one patient: see PatientNumbers
};

// A DICOM file that was skipped, or a folder that could not be read. `message.sentence` does not name the
// file; `file` may name a patient.
struct SkippedFile {
    std::filesystem::path file;
    Message message;
    std::string seriesInstanceUid;  // when the header could be read
    bool isFolder = false;
};

struct Scan {
    std::vector<Study> studies;  // by date, then UID, then patient
    std::vector<SkippedFile> skipped;
    std::vector<Message> messages;  // about the folder as a whole
    std::size_t filesSeen = 0;
    std::size_t notDicom = 0;
    std::size_t archives = 0;                 // those of notDicom that are archives, which are not opened
    std::set<std::string_view> archiveKinds;  // their kinds, by archiveKind
    std::size_t listedFilesMissing = 0;       // according to the media directories
    std::size_t unreadableFolders = 0;
    int patients = 0;          // as patient.h distinguishes them
    int namelessPatients = 0;  // those of `patients` that are studies without a name or ID

    std::size_t imageCount() const;   // files that hold images
    std::size_t objectCount() const;  // DICOM objects that are not images
};

// Receives, while a folder is being read, its studies and series so far, with the number of images read
// (Series::instances) and without stacks or messages. Copies and broken files are not separated yet.
using GlimpseListener = std::function<void(Scan)>;

struct ScanOptions {
    // Joins images into one series that differ only in identifiers that were made separately for each of
    // them: see join.h. Only a person may decide this; key::kUidPerSlice asks.
    bool join = false;
    GlimpseListener glimpsed = {};  // called by reading threads; scan_glimpse.h says how often
};

// `path` is a folder, read with all its sub-folders (see folder.h for links), or one file. A DICOMDIR given
// as the path stands for its folder. Reads headers on all cores; every DICOM file is in exactly one place of
// the result. A bad file never stops the others. The result does not depend on the order in which the file
// system lists files. Fails with inputNotUsable when the path does not exist, or holds nothing that is DICOM
// and readable; with cancelled within 200 ms of a cancellation.
Result<Scan> scanFolder(const std::filesystem::path& path, Progress& progress,
                        const ScanOptions& options = {});

// "2 patients"; "up to 2 patients" when two studies name no patient, and may belong to one.
Text patientsText(const Scan& scan);

// Whether the two patients (Study::patient) may be one, so that a series UID may belong to both: they are the
// same, or both are studies that name no patient.
bool mayBeOnePatient(const Scan& scan, int patient, int other);

// The series with that UID. Null when there is none or more than one; findAllSeries distinguishes the two.
const Series* findSeries(const Scan& scan, std::string_view seriesInstanceUid);
// More than one when patients or studies share a UID, which they must not; then by study as in the scan.
std::vector<const Series*> findAllSeries(const Scan& scan, std::string_view seriesInstanceUid);

}  // namespace macula::dicom
