#include "dicom/write/series_writer.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpls/djencode.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <mutex>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/draft.h"
#include "base/parallel.h"
#include "base/sha256.h"
#include "dicom/stack/examination.h"
#include "dicom/write/decimal_string.h"
#include "dicom/write/uid.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

constexpr double kPerpendicular = 1e-6;

Error notWritable(Text message, const fs::path& where, Text hint) {
    return {ErrorCode::outputNotWritable, std::move(message), where.string(), std::move(hint)};
}

std::string decimalStrings(std::initializer_list<double> values) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : "\\") + decimalString(value);
    return text;
}

E_TransferSyntax transferSyntax(WriteSyntax syntax) {
    switch (syntax) {
        case WriteSyntax::explicitLittleEndian:
            return EXS_LittleEndianExplicit;
        case WriteSyntax::implicitLittleEndian:
            return EXS_LittleEndianImplicit;
        case WriteSyntax::explicitBigEndian:
            return EXS_BigEndianExplicit;
        case WriteSyntax::deflated:
            return EXS_DeflatedLittleEndianExplicit;
        case WriteSyntax::rle:
            return EXS_RLELossless;
        case WriteSyntax::jpegLossless:
            return EXS_JPEGProcess14SV1;
        case WriteSyntax::jpegLs:
            return EXS_JPEGLSLossless;
    }
    std::abort();
}

void registerEncoders() {
    static std::once_flag once;
    std::call_once(once, [] {
        DcmRLEEncoderRegistration::registerCodecs();
        DJEncoderRegistration::registerCodecs();
        // "Cooked" encoding would rescale the pixels to the range that is used.
        DJLSEncoderRegistration::registerCodecs(0, 0, 0, 0, OFFalse);
    });
}

// The data that every file of the series shares.
struct Common {
    bool isCt = true;
    bool isSigned = false;
    UnitsFromStored unitsFromRaw;
    glm::dvec3 rowDirection{0.0};
    glm::dvec3 columnDirection{0.0};
    glm::dvec3 spacingMm{0.0};  // between columns, rows, slices
    std::string contentHash;
};

Result<Common> describe(const Volume& volume, const SeriesWriterOptions& options) {
    const auto refuse = [](Text message) {
        return Error{ErrorCode::usage, std::move(message), {}, Text("Choose another volume.")};
    };
    Common common;
    common.isCt = volume.modality() == "CT";
    if (!common.isCt && volume.modality() != "MR")
        return refuse(Text("Only CT and MR volumes can be written as DICOM."));

    const glm::dmat4& m = volume.worldFromVoxel();
    common.spacingMm = volume.spacingMm();
    common.rowDirection = glm::dvec3(m[0]) / common.spacingMm.x;
    common.columnDirection = glm::dvec3(m[1]) / common.spacingMm.y;
    if (std::abs(glm::dot(common.rowDirection, common.columnDirection)) > kPerpendicular) {
        return refuse(
            Text("The rows and columns of this volume are not perpendicular, which DICOM cannot express."));
    }
    const UnitsFromStored map = volume.unitsFromStored();
    const double signedIntercept = map.intercept + 32768.0 * map.slope;
    common.isSigned =
        options.pixelSign == PixelSign::asSigned ||
        (options.pixelSign == PixelSign::automatic && std::abs(signedIntercept) < std::abs(map.intercept));
    common.unitsFromRaw = {map.slope, common.isSigned ? signedIntercept : map.intercept};

    std::string text = fmt::format("{} {} {} {}", sha256Hex(std::as_bytes(volume.voxels())), map.slope,
                                   map.intercept, volume.modality());
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row) text += fmt::format(" {}", m[column][row]);
    }
    common.contentHash = sha256Hex(text);
    return common;
}

// DcmItem has one put per type; a failed one means a value that does not fit its VR, and the file must not be
// written.
class Filler {
  public:
    explicit Filler(DcmItem& item) : item_(item) {}
    void text(const DcmTagKey& tag, const std::string& value) {
        ok_ = ok_ && item_.putAndInsertString(tag, value.c_str()).good();
    }
    void word(const DcmTagKey& tag, int value) {
        ok_ = ok_ && item_.putAndInsertUint16(tag, static_cast<Uint16>(value)).good();
    }
    void signedWord(const DcmTagKey& tag, int value) {
        ok_ = ok_ && item_.putAndInsertSint16(DcmTag(tag, EVR_SS), static_cast<Sint16>(value)).good();
    }
    bool ok() const { return ok_; }

  private:
    DcmItem& item_;
    bool ok_ = true;
};

void fillPatientStudySeries(Filler& fill, const Common& common, const SeriesWriterOptions& options) {
    fill.text(DCM_SpecificCharacterSet, "ISO_IR 192");
    fill.text(DCM_PatientName, "PHANTOM^MACULA");
    fill.text(DCM_PatientID, "MACULA-PHANTOM");
    fill.text(DCM_PatientBirthDate, "");
    fill.text(DCM_PatientSex, "O");
    fill.text(DCM_StudyInstanceUID, uidFrom("study " + common.contentHash));
    fill.text(DCM_StudyDate, "20000101");
    fill.text(DCM_StudyTime, "000000");
    fill.text(DCM_StudyID, "1");
    fill.text(DCM_AccessionNumber, "");
    fill.text(DCM_ReferringPhysicianName, "");
    fill.text(DCM_StudyDescription, "Synthetic data, no patient");
    const std::string seriesSalt = fmt::format(" {} {}", options.seriesNumber, common.contentHash);
    fill.text(DCM_SeriesInstanceUID, uidFrom("series" + seriesSalt));
    fill.text(DCM_SeriesNumber, std::to_string(options.seriesNumber));
    fill.text(DCM_SeriesDescription, options.seriesDescription);
    fill.text(DCM_Modality, common.isCt ? "CT" : "MR");
    fill.text(DCM_Manufacturer, "Macula");
    fill.text(DCM_PatientPosition, "HFS");
    fill.text(DCM_FrameOfReferenceUID, uidFrom("frame " + common.contentHash));
    fill.text(DCM_PositionReferenceIndicator, "");
    fill.text(DCM_ImageType, "ORIGINAL\\PRIMARY\\AXIAL");
    if (common.isCt) {
        fill.text(DCM_KVP, "");
        fill.text(DCM_RescaleType, "HU");
    } else {
        fill.text(DCM_ScanningSequence, "RM");
        fill.text(DCM_SequenceVariant, "NONE");
        fill.text(DCM_ScanOptions, "");
        fill.text(DCM_MRAcquisitionType, "");
        fill.text(DCM_RepetitionTime, "");
        fill.text(DCM_EchoTime, "");
        fill.text(DCM_EchoTrainLength, "");
    }
    fill.text(DCM_AcquisitionNumber, "1");
    fill.text(DCM_ContentDate, "20000101");
    fill.text(DCM_ContentTime, "000000");
}

void fillImage(Filler& fill, const Volume& volume, const Common& common, const SeriesWriterOptions& options,
               int k) {
    const auto& [r, c] = std::pair(common.rowDirection, common.columnDirection);
    const glm::dvec3 position = transformPoint(volume.worldFromVoxel(), {0, 0, k});
    fill.text(DCM_SOPClassUID, common.isCt ? UID_CTImageStorage : UID_MRImageStorage);
    fill.text(DCM_SOPInstanceUID,
              uidFrom(fmt::format("image {} {} {}", k, options.seriesNumber, common.contentHash)));
    fill.text(DCM_InstanceNumber, std::to_string(k + 1));
    fill.text(DCM_ImagePositionPatient, decimalStrings({position.x, position.y, position.z}));
    fill.text(DCM_ImageOrientationPatient, decimalStrings({r.x, r.y, r.z, c.x, c.y, c.z}));
    fill.text(DCM_PixelSpacing,
              decimalStrings({common.spacingMm.y, common.spacingMm.x}));  // rows first: PS3.3 10.7.1.3
    fill.text(DCM_SliceThickness, decimalString(common.spacingMm.z));
    fill.word(DCM_SamplesPerPixel, 1);
    fill.text(DCM_PhotometricInterpretation, "MONOCHROME2");
    fill.word(DCM_Rows, volume.size().y);
    fill.word(DCM_Columns, volume.size().x);
    fill.word(DCM_BitsAllocated, 16);
    fill.word(DCM_BitsStored, 16);
    fill.word(DCM_HighBit, 15);
    fill.word(DCM_PixelRepresentation, common.isSigned ? 1 : 0);
    fill.text(DCM_RescaleSlope, decimalString(common.unitsFromRaw.slope));
    fill.text(DCM_RescaleIntercept, decimalString(common.unitsFromRaw.intercept));
    if (const auto& padding = volume.padding()) {
        const auto put = [&](const DcmTagKey& tag, int stored) {
            common.isSigned ? fill.signedWord(tag, stored - 32768) : fill.word(tag, stored);
        };
        put(DCM_PixelPaddingValue, padding->low);
        if (padding->high != padding->low) put(DCM_PixelPaddingRangeLimit, padding->high);
    }
}

Result<void> writeSlice(const Volume& volume, const Common& common, const SeriesWriterOptions& options, int k,
                        const fs::path& file) try {
    const Error failed = notWritable(Text("A DICOM file could not be written."), file,
                                     Text("Check free space and permissions."));
    const QuietToolkit quiet;
    DcmFileFormat format;
    DcmDataset& dataset = *format.getDataset();
    Filler fill(dataset);
    fillPatientStudySeries(fill, common, options);
    fillImage(fill, volume, common, options, k);
    if (!fill.ok()) return failed;

    const std::size_t count =
        static_cast<std::size_t>(volume.size().x) * static_cast<std::size_t>(volume.size().y);
    const auto stored = volume.voxels().subspan(static_cast<std::size_t>(k) * count, count);
    std::vector<Uint16> cells(stored.begin(), stored.end());
    if (common.isSigned) {
        for (Uint16& cell : cells)
            cell = static_cast<Uint16>(cell - 32768);  // two's complement of stored - 32768
    }
    const auto length = static_cast<unsigned long>(count);
    if (dataset.putAndInsertUint16Array(DCM_PixelData, cells.data(), length).bad()) return failed;
    const E_TransferSyntax syntax = transferSyntax(options.syntax);
    if (dataset.chooseRepresentation(syntax, nullptr).bad() || !dataset.canWriteXfer(syntax)) return failed;
    if (format.saveFile(file.c_str(), syntax).bad()) return failed;
    // DCMTK does not report that the last bytes are missing when the disk is full.
    if (examine(file).state != FileState::complete) return failed;
    return {};
} catch (const CheckFailure&) {
    throw;  // a bug in Macula, not a fault of the file
} catch (...) {
    return notWritable(Text("A DICOM file could not be written."), file,
                       Text("Check free space and memory."));
}

// True when both folders hold the same files, byte for byte.
bool sameFolder(const fs::path& a, const fs::path& b, std::size_t files) {
    std::error_code error;
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(a, error)) {
        constexpr std::size_t kLargest = std::size_t{1} << 30;
        const auto mine = readText(entry.path(), kLargest);
        const auto other = readText(b / entry.path().filename(), kLargest);
        if (!mine || !other || *mine != *other) return false;
        ++count;
    }
    return !error && count == files;
}

}  // namespace

Result<std::vector<fs::path>> writeSeries(const Volume& volume, const fs::path& folder,
                                          const SeriesWriterOptions& options, Progress& progress) try {
    const QuietToolkit quiet;
    registerEncoders();
    MACULA_TRY(const Common common, describe(volume, options));

    std::error_code error;
    const fs::path target = fs::absolute(folder, error).lexically_normal();
    const fs::path parent = target.has_filename() ? target.parent_path() : target.parent_path().parent_path();
    const fs::path name = target.has_filename() ? target.filename() : target.parent_path().filename();
    fs::create_directories(parent, error);
    const Result<Draft> temporary = Draft::beside(parent / name, Draft::Kind::folder);
    if (!temporary) {
        return notWritable(Text("The folder to write into cannot be created."), folder,
                           Text("Check the permissions, or choose another place."));
    }

    const auto slices = static_cast<std::size_t>(volume.size().z);
    progress.beginStage(Text("Writing {} slices", slices), slices);
    std::mutex mutex;
    std::optional<Error> failure;
    parallelFor(
        slices,
        [&](std::size_t k) {
            const auto file = temporary->path() / fmt::format("IM{:05}.dcm", k + 1);
            const Result<void> written = writeSlice(volume, common, options, static_cast<int>(k), file);
            if (!written) {
                const std::lock_guard lock(mutex);
                if (!failure) failure = written.error();
            }
            progress.advance();
        },
        progress.token());
    if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("Writing was cancelled."), {}, {}};
    if (failure) {
        failure->where = folder.string();
        return *failure;
    }

    // rename() replaces an empty folder and refuses any other, so that nothing of the user's is ever lost.
    const fs::path final = parent / name;
    fs::rename(temporary->path(), final, error);
    if (error && !(fs::is_directory(final) && sameFolder(final, temporary->path(), slices))) {
        return notWritable(Text("The folder to write into is not empty, or cannot be replaced."), folder,
                           Text("Choose a folder that is empty or does not exist."));
    }
    std::vector<fs::path> files;
    for (std::size_t k = 0; k < slices; ++k) files.push_back(folder / fmt::format("IM{:05}.dcm", k + 1));
    return files;
} catch (const std::exception&) {
    return notWritable(Text("The series could not be written."), folder,
                       Text("Check free space, memory and permissions."));
}

}  // namespace macula::dicom
