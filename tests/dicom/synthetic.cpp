#include "synthetic.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "dicom/read/dataset.h"
#include "support.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::dicom::test {

namespace fs = std::filesystem;

namespace {

void check(const OFCondition& condition) {
    ASSERT_TRUE(condition.good()) << condition.text();
}

std::vector<double> list(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

std::string orientationOf(const Slice& slice) {
    std::vector<double> six = list(slice.rowDirection);
    for (const double d : list(slice.columnDirection)) six.push_back(d);
    return decimals(six);
}

const char* singleFrameClass(const std::string& modality) {
    static const std::map<std::string, const char*> classes{
        {"CT", UID_CTImageStorage},
        {"MR", UID_MRImageStorage},
        {"PT", UID_PositronEmissionTomographyImageStorage},
        {"NM", UID_NuclearMedicineImageStorage},
        {"CR", UID_ComputedRadiographyImageStorage},
        {"DX", UID_DigitalXRayImageStorageForPresentation},
        {"US", UID_UltrasoundImageStorage},
    };
    const auto at = classes.find(modality);
    return at == classes.end() ? UID_SecondaryCaptureImageStorage : at->second;
}

const char* enhancedClass(const std::string& modality) {
    return modality == "CT"   ? UID_EnhancedCTImageStorage
           : modality == "MR" ? UID_EnhancedMRImageStorage
           : modality == "PT" ? UID_EnhancedPETImageStorage
                              : UID_MultiframeGrayscaleWordSecondaryCaptureImageStorage;
}

void putPatientAndStudy(DcmItem& item, const SyntheticSeries& series) {
    put(item, DCM_PatientName, series.patientName);
    put(item, DCM_PatientID, series.patientId);
    put(item, DCM_StudyDate, "20200102");
    put(item, DCM_StudyInstanceUID, series.studyUid);
    put(item, DCM_SeriesInstanceUID, series.seriesUid);
    put(item, DCM_SeriesNumber, std::to_string(series.number));
    put(item, DCM_Modality, series.modality);
    put(item, DCM_FrameOfReferenceUID, series.frameOfReferenceUid);
    put(item, DCM_ImageType, series.imageType);
    put(item, DCM_PatientPosition, series.patientPosition);
}

void putPixelModule(DcmItem& item, const SyntheticSeries& series, const CellFormat& format) {
    putWord(item, DCM_SamplesPerPixel, 1);
    put(item, DCM_PhotometricInterpretation, "MONOCHROME2");
    putWord(item, DCM_Rows, series.size.y);
    putWord(item, DCM_Columns, series.size.x);
    putWord(item, DCM_BitsAllocated, format.bitsAllocated);
    putWord(item, DCM_BitsStored, format.bitsStored);
    putWord(item, DCM_HighBit, format.highBit);
    putWord(item, DCM_PixelRepresentation, format.isSigned ? 1 : 0);
}

void putRescale(DcmItem& item, const SyntheticSeries& series, const Slice& slice) {
    if (!series.writeRescale) return;
    put(item, DCM_RescaleIntercept, decimal(slice.intercept));
    put(item, DCM_RescaleSlope, decimal(slice.slope));
    put(item, DCM_RescaleType, series.modality == "CT" ? "HU" : "US");
}

void appendCells(std::vector<Uint16>& cells, const SyntheticSeries& series, const Slice& slice) {
    const CellFormat& f = slice.format;
    const int shift = f.highBit + 1 - f.bitsStored;
    const auto mask = static_cast<unsigned>((1u << f.bitsStored) - 1u);
    const auto noise = series.cellNoise & ~(mask << shift);
    for (int j = 0; j < series.size.y; ++j) {
        for (int i = 0; i < series.size.x; ++i) {
            const unsigned raw = static_cast<unsigned>(rawAt(series, slice, i, j)) & mask;
            cells.push_back(static_cast<Uint16>((raw << shift) | noise));
        }
    }
}

void putCells(DcmItem& item, const std::vector<Uint16>& cells, int bitsAllocated) {
    if (bitsAllocated == 8) {
        const std::vector<Uint8> bytes(cells.begin(), cells.end());
        check(item.putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size()));
    } else {
        check(item.putAndInsertUint16Array(DCM_PixelData, cells.data(), cells.size()));
    }
}

void save(DcmFileFormat& format, const fs::path& file, const std::string& transferSyntaxUid) {
    const E_TransferSyntax syntax = DcmXfer(transferSyntaxUid.c_str()).getXfer();
    ASSERT_NE(syntax, EXS_Unknown) << transferSyntaxUid;
    if (syntax == EXS_RLELossless) DcmRLEEncoderRegistration::registerCodecs();
    check(format.getDataset()->chooseRepresentation(syntax, nullptr));
    fs::create_directories(file.parent_path());
    check(format.saveFile(file.c_str(), syntax));
}

std::string hashedName(std::size_t n) {
    return fmt::format("I{:08x}", static_cast<std::uint32_t>((n + 1) * 2654435761u));
}

}  // namespace

SyntheticSeries::SyntheticSeries() : worldFromVoxel(obliqueAffine()) {}

Ramp SyntheticSeries::rampOf(int phase) const {
    const glm::dvec3 middle = transformPoint(worldFromVoxel, 0.5 * glm::dvec3(size - 1));
    Ramp result = ramp.value_or(Ramp{});
    if (!ramp) result.throughMm = middle;
    return result.plus(phaseStep * phase);
}

glm::dmat4 SyntheticSeries::expectedAffine() const {
    const glm::dmat4& m = worldFromVoxel;
    if (glm::determinant(glm::dmat3(m)) > 0.0) return m;
    return affine(m[0], m[1], -glm::dvec3(m[2]), transformPoint(m, {0, 0, size.z - 1}));
}

std::vector<Slice> slicesOf(const SyntheticSeries& series) {
    const glm::dmat4& m = series.worldFromVoxel;
    std::vector<Slice> slices;
    const std::size_t count =
        series.places.empty() ? static_cast<std::size_t>(series.size.z) : series.places.size();
    for (int phase = 0; phase < series.phases; ++phase) {
        for (std::size_t n = 0; n < count; ++n) {
            const double place = series.places.empty() ? static_cast<double>(n) : series.places[n];
            Slice slice;
            slice.columnSpacingMm = glm::length(glm::dvec3(m[0]));
            slice.rowSpacingMm = glm::length(glm::dvec3(m[1]));
            slice.rowDirection = glm::normalize(glm::dvec3(m[0]));
            slice.columnDirection = glm::normalize(glm::dvec3(m[1]));
            slice.positionMm = transformPoint(m, {0, 0, place});
            slice.slope = series.slope;
            slice.intercept = series.intercept;
            slice.format = series.format;
            slice.phase = phase;
            slice.place = static_cast<int>(n);
            slice.instanceNumber = static_cast<int>(slices.size()) + 1;
            // Ends in a digit that is not 0 by any accident of the series' own UID.
            slice.sopInstanceUid = fmt::format("{}.{}.{}", series.seriesUid, phase + 1, n + 1);
            slice.fileName =
                hashedName(slices.size() + 1000 * static_cast<std::size_t>(series.number) +
                           std::hash<std::string>{}(series.seriesUid + series.imageType) % 100000);
            slices.push_back(std::move(slice));
        }
    }
    if (series.shuffleNumbers) {
        std::vector<int> numbers;
        for (const Slice& slice : slices) numbers.push_back(slice.instanceNumber);
        std::shuffle(numbers.begin(), numbers.end(), std::mt19937(20200102));
        for (std::size_t n = 0; n < slices.size(); ++n) slices[n].instanceNumber = numbers[n];
    }
    return slices;
}

int rawAt(const SyntheticSeries& series, const Slice& slice, int i, int j) {
    if (series.rawInstead) {
        if (const auto raw = series.rawInstead(slice, i, j)) return *raw;
    }
    const glm::dvec3 world = slice.positionMm + i * slice.columnSpacingMm * slice.rowDirection +
                             j * slice.rowSpacingMm * slice.columnDirection;
    const double raw = std::round((series.rampOf(slice.phase)(world) - slice.intercept) / slice.slope);
    const int bits = slice.format.bitsStored;
    const double least = slice.format.isSigned ? -std::ldexp(1.0, bits - 1) : 0.0;
    const double most = std::ldexp(1.0, slice.format.isSigned ? bits - 1 : bits) - 1.0;
    if (!(raw >= least && raw <= most)) {
        ADD_FAILURE() << "the test wants a raw value of " << raw << " in " << bits << " bits";
        return 0;
    }
    return static_cast<int>(raw);
}

std::vector<fs::path> writeFiles(const fs::path& folder, const SyntheticSeries& series,
                                 const std::vector<Slice>& slices) {
    silenceToolkit();
    std::vector<fs::path> files;
    for (const Slice& slice : slices) {
        DcmFileFormat format;
        DcmItem& item = *format.getDataset();
        put(item, DCM_SOPClassUID,
            series.sopClassUid.empty() ? singleFrameClass(series.modality) : series.sopClassUid);
        put(item, DCM_SOPInstanceUID, slice.sopInstanceUid);
        putPatientAndStudy(item, series);
        put(item, DCM_InstanceNumber, std::to_string(slice.instanceNumber));
        put(item, DCM_ImagePositionPatient, decimals(list(slice.positionMm)));
        put(item, DCM_ImageOrientationPatient, orientationOf(slice));
        put(item, DCM_PixelSpacing, decimals({slice.rowSpacingMm, slice.columnSpacingMm}));
        // Wrong on purpose: spacing comes from positions.
        put(item, DCM_SliceThickness, "7.25");
        putPixelModule(item, series, slice.format);
        putRescale(item, series, slice);
        std::vector<Uint16> cells;
        appendCells(cells, series, slice);
        putCells(item, cells, slice.format.bitsAllocated);
        for (const Edit& edit : series.edits) edit(item);
        for (const Edit& edit : slice.edits) edit(item);
        files.push_back(folder / slice.fileName);
        save(format, files.back(), series.transferSyntaxUid);
    }
    return files;
}

void writeMultiFrame(const fs::path& file, const SyntheticSeries& series, const std::vector<Slice>& slices,
                     const MultiFrame& options) {
    silenceToolkit();
    ASSERT_FALSE(slices.empty());
    const Slice& first = slices.front();
    DcmFileFormat format;
    DcmItem& item = *format.getDataset();
    put(item, DCM_SOPClassUID,
        series.sopClassUid.empty() ? enhancedClass(series.modality) : series.sopClassUid);
    put(item, DCM_SOPInstanceUID, options.sopInstanceUid);
    putPatientAndStudy(item, series);
    put(item, DCM_InstanceNumber, "1");
    put(item, DCM_NumberOfFrames, std::to_string(slices.size()));
    putPixelModule(item, series, first.format);
    if (options.dimensions) {
        constexpr const char* kOrganisation = "2.25.4000";
        put(nested(item, DCM_DimensionOrganizationSequence), DCM_DimensionOrganizationUID, kOrganisation);
        const DcmTagKey pointers[] = {DCM_StackID, DCM_InStackPositionNumber, DCM_TemporalPositionIndex};
        for (const DcmTagKey& pointer : pointers) {
            DcmItem& index = appended(item, DCM_DimensionIndexSequence);
            put(index, DCM_DimensionOrganizationUID, kOrganisation);
            check(index.putAndInsertTagKey(DCM_DimensionIndexPointer, pointer));
            check(index.putAndInsertTagKey(DCM_FunctionalGroupPointer, DCM_FrameContentSequence));
        }
    }
    const auto measures = [&](DcmItem& groups, const Slice& slice) {
        DcmItem& macro = nested(groups, DCM_PixelMeasuresSequence);
        put(macro, DCM_PixelSpacing, decimals({slice.rowSpacingMm, slice.columnSpacingMm}));
        put(macro, DCM_SliceThickness, "7.25");
    };
    const auto orientation = [&](DcmItem& groups, const Slice& slice) {
        put(nested(groups, DCM_PlaneOrientationSequence), DCM_ImageOrientationPatient, orientationOf(slice));
    };
    const auto transformation = [&](DcmItem& groups, const Slice& slice) {
        putRescale(nested(groups, DCM_PixelValueTransformationSequence), series, slice);
    };
    if (options.functionalGroups) {
        DcmItem& shared = nested(item, DCM_SharedFunctionalGroupsSequence);
        if (options.sharedMeasures) measures(shared, first);
        if (options.sharedOrientation) orientation(shared, first);
        if (options.sharedTransformation) transformation(shared, first);
    }
    std::vector<Uint16> cells;
    for (const Slice& slice : slices) {
        appendCells(cells, series, slice);
        if (!options.functionalGroups) continue;
        DcmItem& groups = appended(item, DCM_PerFrameFunctionalGroupsSequence);
        DcmItem& content = nested(groups, DCM_FrameContentSequence);
        if (options.dimensions) {
            put(content, DCM_StackID, slice.stackId);
            const Uint32 values[] = {
                static_cast<Uint32>(options.firstDimensionIndex),
                static_cast<Uint32>(slice.place + options.firstDimensionIndex),
                static_cast<Uint32>(slice.phase + options.firstDimensionIndex),
            };
            check(content.putAndInsertUint32(DCM_InStackPositionNumber, values[1]));
            check(content.putAndInsertUint32(DCM_TemporalPositionIndex, values[2]));
            // DCMTK 3.6.7 has no setter for several values of a UL.
            auto* element = new DcmUnsignedLong(DCM_DimensionIndexValues);
            check(element->putUint32Array(values, 3));
            check(content.insert(element));
        }
        put(nested(groups, DCM_PlanePositionSequence), DCM_ImagePositionPatient,
            decimals(list(slice.positionMm)));
        if (!options.sharedMeasures) measures(groups, slice);
        if (!options.sharedOrientation) orientation(groups, slice);
        if (!options.sharedTransformation) transformation(groups, slice);
        for (const Edit& edit : slice.edits) edit(groups);
    }
    putCells(item, cells, first.format.bitsAllocated);
    for (const Edit& edit : series.edits) edit(item);
    for (const Edit& edit : options.edits) edit(item);
    save(format, file, series.transferSyntaxUid);
}

void writeShell(const fs::path& file, const Shell& shell) {
    silenceToolkit();
    DcmFileFormat format;
    DcmItem& item = *format.getDataset();
    put(item, DCM_SOPClassUID, shell.sopClassUid);
    put(item, DCM_SOPInstanceUID, shell.sopInstanceUid);
    putPatientAndStudy(item, SyntheticSeries{});
    put(item, DCM_SeriesInstanceUID, shell.seriesUid);
    put(item, DCM_Modality, shell.modality);
    erase(item, DCM_ImageType);
    for (const Edit& edit : shell.edits) edit(item);
    save(format, file, UID_LittleEndianExplicitTransferSyntax);
}

namespace {

DcmItem& appendedRecord(DcmItem& directory, const std::string& type) {
    DcmItem& record = appended(directory, DCM_DirectoryRecordSequence);
    check(record.putAndInsertUint32(DcmTag(DCM_OffsetOfTheNextDirectoryRecord, EVR_UL), 0));
    putWord(record, DCM_RecordInUseFlag, 0xFFFF);
    check(record.putAndInsertUint32(DcmTag(DCM_OffsetOfReferencedLowerLevelDirectoryEntity, EVR_UL), 0));
    put(record, DCM_DirectoryRecordType, type);
    return record;
}

}  // namespace

void writeDirectoryOf(const fs::path& file, const std::vector<DirectoryEntry>& entries) {
    silenceToolkit();
    DcmFileFormat format;
    DcmItem& item = *format.getDataset();
    put(item, DCM_SOPClassUID, UID_MediaStorageDirectoryStorage);
    put(item, DCM_SOPInstanceUID, "2.25.5000");
    put(item, DCM_FileSetID, "SYNTHETIC");
    check(item.putAndInsertUint32(DcmTag(DCM_OffsetOfTheFirstDirectoryRecordOfTheRootDirectoryEntity, EVR_UL),
                                  0));
    check(item.putAndInsertUint32(DcmTag(DCM_OffsetOfTheLastDirectoryRecordOfTheRootDirectoryEntity, EVR_UL),
                                  0));
    putWord(item, DCM_FileSetConsistencyFlag, 0);
    std::string series;
    for (const DirectoryEntry& entry : entries) {
        if (entry.seriesUid != series)
            put(appendedRecord(item, "SERIES"), DCM_SeriesInstanceUID, entry.seriesUid);
        series = entry.seriesUid;
        DcmItem& record = appendedRecord(item, "IMAGE");
        put(record, DCM_ReferencedFileID, entry.fileId);
        put(record, DCM_ReferencedSOPClassUIDInFile, UID_CTImageStorage);
        put(record, DCM_ReferencedSOPInstanceUIDInFile, entry.sopInstanceUid);
        put(record, DCM_ReferencedTransferSyntaxUIDInFile, UID_LittleEndianExplicitTransferSyntax);
        put(record, DCM_InstanceNumber, std::to_string(entry.instanceNumber));
    }
    save(format, file, UID_LittleEndianExplicitTransferSyntax);
}

void writeDirectory(const fs::path& file, const std::vector<std::string>& fileIds) {
    std::vector<DirectoryEntry> entries;
    for (const std::string& id : fileIds) entries.push_back({.fileId = id});
    writeDirectoryOf(file, entries);
}

void put(DcmItem& item, const DcmTagKey& tag, const std::string& value) {
    check(item.putAndInsertOFStringArray(tag, OFString(value.data(), value.size())));
}

void putNumber(DcmItem& item, const DcmTagKey& tag, double value) {
    const DcmEVR vr = DcmTag(tag).getEVR();
    if (vr == EVR_FD) return check(item.putAndInsertFloat64(tag, value));
    if (vr == EVR_FL) return check(item.putAndInsertFloat32(tag, static_cast<Float32>(value)));
    if (vr == EVR_UL) return check(item.putAndInsertUint32(tag, static_cast<Uint32>(value)));
    put(item, tag, decimal(value));
}

void putWord(DcmItem& item, const DcmTagKey& tag, int value) {
    check(item.putAndInsertUint16(DcmTag(tag, EVR_US), static_cast<Uint16>(value)));
}

void erase(DcmItem& item, const DcmTagKey& tag) {
    item.findAndDeleteElement(tag, OFTrue);
}

DcmItem& nested(DcmItem& item, const DcmTagKey& sequence) {
    DcmItem* found = nullptr;
    const OFCondition condition = item.findOrCreateSequenceItem(sequence, found, 0);
    if (condition.bad() || !found) throw std::runtime_error(condition.text());
    return *found;
}

DcmItem& appended(DcmItem& item, const DcmTagKey& sequence) {
    DcmItem* found = nullptr;
    const OFCondition condition = item.findOrCreateSequenceItem(sequence, found, -2);
    if (condition.bad() || !found) throw std::runtime_error(condition.text());
    return *found;
}

std::string decimal(double value) {
    for (int digits = 15; digits > 0; --digits) {
        std::string text = fmt::format("{:.{}g}", value, digits);
        if (text.size() <= 16) return text;
    }
    return "0";
}

std::string decimals(const std::vector<double>& values) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : "\\") + decimal(value);
    return text;
}

void editFile(const fs::path& file, const Edit& edit) {
    silenceToolkit();
    DcmFileFormat format;
    check(format.loadFile(file.c_str()));
    check(format.loadAllDataIntoMemory());
    edit(*format.getDataset());
    check(format.saveFile(file.c_str(), format.getDataset()->getOriginalXfer()));
}

void expectRamp(const Volume& volume, const Ramp& ramp, double tolerance) {
    const glm::ivec3 size = volume.size();
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                ASSERT_NEAR(volume.value(i, j, k), ramp(transformPoint(volume.worldFromVoxel(), {i, j, k})),
                            tolerance + 1e-3)
                    << "voxel " << i << " " << j << " " << k;
            }
        }
    }
}

void expectGrid(const Volume& volume, const glm::ivec3& size, const glm::dmat4& worldFromVoxel,
                double toleranceMm) {
    EXPECT_EQ(volume.size(), size);
    EXPECT_LT(affineError(volume.worldFromVoxel(), worldFromVoxel), toleranceMm);
}

void expectVolumeOf(const Volume& volume, const SyntheticSeries& series, int phase) {
    expectGrid(volume, series.size, series.expectedAffine());
    // A measured value is rounded once; an interpolated one, of rounded values, again.
    const double roundings = volume.provenance().interpolatedSlices.empty() ? 0.5 : 1.0;
    expectRamp(volume, series.rampOf(phase), roundings * std::abs(series.slope));
}

}  // namespace macula::dicom::test
