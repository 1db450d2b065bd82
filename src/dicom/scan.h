// Reads a folder: which patients, studies, series and volumes are in it. Content decides what is DICOM, never
// a file's name.
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

// For the clinical display only: all of it names a patient. Text is UTF-8.
struct Study {
    std::string studyInstanceUid;
    std::string date;  // YYYYMMDD as in the file, or empty
    std::string description;
    std::string patientName;  // components separated by ^, representations by = (PS3.5 6.2.1)
    std::string patientId;
    std::vector<Series> series;    // by number, then UID
    std::string patientBirthDate;  // YYYYMMDD as in the file, or empty
    std::string patientSex;        // M, F, O, or empty
    int patient = 0;               // from 0; studies of one patient share it, as PatientNumbers has it
};

// A DICOM file that was left out, or a folder that could not be read.
// `message.sentence` does not name the file; `file` may name a patient.
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
    std::size_t archives = 0;                 // of those: archives, which are not opened
    std::set<std::string_view> archiveKinds;  // of these, by archiveKind
    std::size_t mediaDirectories = 0;         // DICOMDIR
    std::size_t listedFilesMissing = 0;       // by the media directories
    std::size_t unreadableFolders = 0;
    int patients = 0;          // see patient.h for what tells them apart
    int namelessPatients = 0;  // of those: studies that do not say whose they are

    std::size_t imageCount() const;   // files that hold images
    std::size_t objectCount() const;  // DICOM objects that are no images
};

// Told of a folder while it is still being read: its studies and series so far, with the number of images
// that were met (Series::instances), and no stacks or messages. Copies and broken files are not told apart
// yet.
using GlimpseListener = std::function<void(Scan)>;

struct ScanOptions {
    // Images that agree in everything but identifiers that were made anew for each of them are one series:
    // see join.h. Nobody but a person may say so; key::kUidPerSlice asks.
    bool join = false;
    GlimpseListener glimpsed = {};  // called on the threads that read; see scan_glimpse.h for how often
};

// `path` is a folder, read with all its sub-folders (see folder.h for links), or one file. A DICOMDIR given
// as the path stands for its folder. Headers are read on all cores; every DICOM file is in exactly one place
// of the result. One bad file never stops the others. The result does not depend on the order in which the
// file system lists files. Fails with inputNotUsable when the path does not exist, or holds nothing that is
// DICOM and readable; with cancelled within 200 ms of a cancellation.
Result<Scan> scanFolder(const std::filesystem::path& path, Progress& progress,
                        const ScanOptions& options = {});

// "2 patients"; "up to 2 patients" where two studies do not say whose they are, and may be of one.
std::string patientsText(const Scan& scan);

// Whether what names one series by its UID may be of both patients (Study::patient): they are one, or both
// are studies that do not say whose they are.
bool mayBeOnePatient(const Scan& scan, int patient, int other);

// The series with that UID. Null when there is none, or more than one: findAllSeries tells which.
const Series* findSeries(const Scan& scan, std::string_view seriesInstanceUid);
// More than one when patients or studies share a UID, which they must not; then by study as in the scan.
std::vector<const Series*> findAllSeries(const Scan& scan, std::string_view seriesInstanceUid);

}  // namespace macula::dicom
