// The data elements that are read, by their keywords (PS3.6).
#pragma once

#include <cstdint>

namespace macula::dicom {

// A tag, as listed in PS3.6.
struct Tag {
    std::uint16_t group;
    std::uint16_t element;

    bool operator==(const Tag&) const = default;
    std::uint32_t key() const { return std::uint32_t{group} << 16 | element; }
    bool isPrivate() const { return group % 2 == 1; }
};

}  // namespace macula::dicom

namespace macula::dicom::tag {

inline constexpr Tag kDirectoryRecords{0x0004, 0x1220};
inline constexpr Tag kSpecificCharacterSet{0x0008, 0x0005};
inline constexpr Tag kImageType{0x0008, 0x0008};
inline constexpr Tag kSopClassUid{0x0008, 0x0016};
inline constexpr Tag kSopInstanceUid{0x0008, 0x0018};
inline constexpr Tag kStudyDate{0x0008, 0x0020};
inline constexpr Tag kSeriesDate{0x0008, 0x0021};
inline constexpr Tag kAcquisitionDate{0x0008, 0x0022};
inline constexpr Tag kSeriesTime{0x0008, 0x0031};
inline constexpr Tag kAcquisitionTime{0x0008, 0x0032};
inline constexpr Tag kModality{0x0008, 0x0060};
inline constexpr Tag kCodeValue{0x0008, 0x0100};
inline constexpr Tag kStudyDescription{0x0008, 0x1030};
inline constexpr Tag kSeriesDescription{0x0008, 0x103E};
inline constexpr Tag kTimezoneOffsetFromUtc{0x0008, 0x0201};
inline constexpr Tag kReferencedSeries{0x0008, 0x1115};
inline constexpr Tag kFrameType{0x0008, 0x9007};
inline constexpr Tag kPatientName{0x0010, 0x0010};
inline constexpr Tag kPatientId{0x0010, 0x0020};
inline constexpr Tag kPatientBirthDate{0x0010, 0x0030};
inline constexpr Tag kPatientSex{0x0010, 0x0040};
inline constexpr Tag kPatientWeight{0x0010, 0x1030};
inline constexpr Tag kAnatomicalOrientationType{0x0010, 0x2210};
inline constexpr Tag kCineRate{0x0018, 0x0040};
inline constexpr Tag kSliceThickness{0x0018, 0x0050};
inline constexpr Tag kSpacingBetweenSlices{0x0018, 0x0088};
inline constexpr Tag kFrameTime{0x0018, 0x1063};
inline constexpr Tag kFrameTimeVector{0x0018, 0x1065};
inline constexpr Tag kRadiopharmaceuticalStartTime{0x0018, 0x1072};
inline constexpr Tag kRadionuclideTotalDose{0x0018, 0x1074};
inline constexpr Tag kRadionuclideHalfLife{0x0018, 0x1075};
inline constexpr Tag kRadiopharmaceuticalStartDateTime{0x0018, 0x1078};
inline constexpr Tag kEstimatedMagnification{0x0018, 0x1114};
inline constexpr Tag kImagerPixelSpacing{0x0018, 0x1164};
inline constexpr Tag kNominalScannedPixelSpacing{0x0018, 0x2010};
inline constexpr Tag kPatientPosition{0x0018, 0x5100};
inline constexpr Tag kStudyInstanceUid{0x0020, 0x000D};
inline constexpr Tag kSeriesInstanceUid{0x0020, 0x000E};
inline constexpr Tag kSeriesNumber{0x0020, 0x0011};
inline constexpr Tag kAcquisitionNumber{0x0020, 0x0012};
inline constexpr Tag kInstanceNumber{0x0020, 0x0013};
inline constexpr Tag kPatientOrientation{0x0020, 0x0020};
inline constexpr Tag kImagePositionPatient{0x0020, 0x0032};
inline constexpr Tag kImageOrientationPatient{0x0020, 0x0037};
inline constexpr Tag kFrameOfReferenceUid{0x0020, 0x0052};
inline constexpr Tag kImagesInAcquisition{0x0020, 0x1002};
inline constexpr Tag kSliceLocation{0x0020, 0x1041};
inline constexpr Tag kNumberOfStudyRelatedInstances{0x0020, 0x1208};
inline constexpr Tag kNumberOfSeriesRelatedInstances{0x0020, 0x1209};
inline constexpr Tag kDimensionIndexValues{0x0020, 0x9157};
inline constexpr Tag kConcatenationUid{0x0020, 0x9161};
inline constexpr Tag kInConcatenationTotalNumber{0x0020, 0x9163};
inline constexpr Tag kDimensionIndexPointer{0x0020, 0x9165};
inline constexpr Tag kDimensionIndex{0x0020, 0x9222};
inline constexpr Tag kImagePositionVolume{0x0020, 0x9301};
inline constexpr Tag kImageOrientationVolume{0x0020, 0x9302};
inline constexpr Tag kVolumeFrameOfReferenceUid{0x0020, 0x9312};
inline constexpr Tag kSamplesPerPixel{0x0028, 0x0002};
inline constexpr Tag kPhotometricInterpretation{0x0028, 0x0004};
inline constexpr Tag kNumberOfFrames{0x0028, 0x0008};
inline constexpr Tag kRows{0x0028, 0x0010};
inline constexpr Tag kColumns{0x0028, 0x0011};
inline constexpr Tag kPixelSpacing{0x0028, 0x0030};
inline constexpr Tag kCorrectedImage{0x0028, 0x0051};
inline constexpr Tag kBitsAllocated{0x0028, 0x0100};
inline constexpr Tag kBitsStored{0x0028, 0x0101};
inline constexpr Tag kHighBit{0x0028, 0x0102};
inline constexpr Tag kPixelRepresentation{0x0028, 0x0103};
inline constexpr std::uint16_t kOverlayBitPositionElement = 0x0102;  // in the groups 6000 to 601E
inline constexpr Tag kPixelPaddingValue{0x0028, 0x0120};
inline constexpr Tag kPixelPaddingRangeLimit{0x0028, 0x0121};
inline constexpr Tag kFloatPixelPaddingValue{0x0028, 0x0122};
inline constexpr Tag kDoubleFloatPixelPaddingValue{0x0028, 0x0123};
inline constexpr Tag kFloatPixelPaddingRangeLimit{0x0028, 0x0124};
inline constexpr Tag kDoubleFloatPixelPaddingRangeLimit{0x0028, 0x0125};
inline constexpr Tag kWindowCenter{0x0028, 0x1050};
inline constexpr Tag kWindowWidth{0x0028, 0x1051};
inline constexpr Tag kRescaleIntercept{0x0028, 0x1052};
inline constexpr Tag kRescaleSlope{0x0028, 0x1053};
inline constexpr Tag kRescaleType{0x0028, 0x1054};
inline constexpr Tag kWindowExplanation{0x0028, 0x1055};
inline constexpr Tag kVoiLutFunction{0x0028, 0x1056};
inline constexpr Tag kLossyImageCompression{0x0028, 0x2110};
inline constexpr Tag kModalityLutSequence{0x0028, 0x3000};
inline constexpr Tag kVoiLutSequence{0x0028, 0x3010};
inline constexpr Tag kLutDescriptor{0x0028, 0x3002};
inline constexpr Tag kModalityLutType{0x0028, 0x3004};
inline constexpr Tag kLutData{0x0028, 0x3006};
inline constexpr Tag kMeasurementUnitsCode{0x0040, 0x08EA};
inline constexpr Tag kRealWorldValueMapping{0x0040, 0x9096};
inline constexpr Tag kRealWorldValueIntercept{0x0040, 0x9224};
inline constexpr Tag kRealWorldValueSlope{0x0040, 0x9225};
inline constexpr Tag kRadiopharmaceuticalInformation{0x0054, 0x0016};
inline constexpr Tag kDetectorInformation{0x0054, 0x0022};
inline constexpr Tag kSliceVector{0x0054, 0x0080};
inline constexpr Tag kNumberOfSlices{0x0054, 0x0081};
inline constexpr Tag kUnits{0x0054, 0x1001};
inline constexpr Tag kSuvType{0x0054, 0x1006};
inline constexpr Tag kDecayCorrection{0x0054, 0x1102};
inline constexpr Tag kDoseUnits{0x3004, 0x0002};
inline constexpr Tag kGridFrameOffsetVector{0x3004, 0x000C};
inline constexpr Tag kDoseGridScaling{0x3004, 0x000E};
inline constexpr Tag kSharedFunctionalGroups{0x5200, 0x9229};
inline constexpr Tag kPerFrameFunctionalGroups{0x5200, 0x9230};
inline constexpr Tag kFloatPixelData{0x7FE0, 0x0008};
inline constexpr Tag kDoubleFloatPixelData{0x7FE0, 0x0009};
inline constexpr Tag kPixelData{0x7FE0, 0x0010};

}  // namespace macula::dicom::tag
