// The data elements of a volumetric presentation state, by their keywords (PS3.6).
#pragma once

#include "dicom/read/tags.h"

namespace macula::dicom::presentation_tag {

inline constexpr Tag kReferencedInstances{0x0008, 0x114A};
inline constexpr Tag kReferencedImages{0x0008, 0x1140};
inline constexpr Tag kReferencedSopClassUid{0x0008, 0x1150};
inline constexpr Tag kReferencedSopInstanceUid{0x0008, 0x1155};
inline constexpr Tag kReferencedFrameNumber{0x0008, 0x1160};
inline constexpr Tag kPixelPresentation{0x0008, 0x9205};
inline constexpr Tag kStudiesContainingOtherInstances{0x0008, 0x1200};
inline constexpr Tag kWindowCenter{0x0028, 0x1050};
inline constexpr Tag kWindowWidth{0x0028, 0x1051};
inline constexpr Tag kVoiLutFunction{0x0028, 0x1056};
inline constexpr Tag kRedDescriptor{0x0028, 0x1101};
inline constexpr Tag kGreenDescriptor{0x0028, 0x1102};
inline constexpr Tag kBlueDescriptor{0x0028, 0x1103};
inline constexpr Tag kAlphaDescriptor{0x0028, 0x1104};
inline constexpr Tag kRedData{0x0028, 0x1201};
inline constexpr Tag kGreenData{0x0028, 0x1202};
inline constexpr Tag kBlueData{0x0028, 0x1203};
inline constexpr Tag kAlphaData{0x0028, 0x1204};
inline constexpr Tag kSegmentedRed{0x0028, 0x1221};
inline constexpr Tag kSegmentedGreen{0x0028, 0x1222};
inline constexpr Tag kSegmentedBlue{0x0028, 0x1223};
inline constexpr Tag kSegmentedAlpha{0x0028, 0x1224};
inline constexpr Tag kRgbLutTransferFunction{0x0028, 0x140F};
inline constexpr Tag kAlphaLutTransferFunction{0x0028, 0x1410};
inline constexpr Tag kIccProfile{0x0028, 0x2000};
inline constexpr Tag kColorSpace{0x0028, 0x2002};
inline constexpr Tag kVoiLutSequence{0x0028, 0x3010};
inline constexpr Tag kViewCode{0x0054, 0x0220};
inline constexpr Tag kGraphicAnnotations{0x0070, 0x0001};
inline constexpr Tag kContentLabel{0x0070, 0x0080};
inline constexpr Tag kContentDescription{0x0070, 0x0081};
inline constexpr Tag kCreationDate{0x0070, 0x0082};
inline constexpr Tag kCreationTime{0x0070, 0x0083};
inline constexpr Tag kContentCreatorName{0x0070, 0x0084};
inline constexpr Tag kReferencedRegistration{0x0070, 0x0404};
inline constexpr Tag kInputs{0x0070, 0x1201};
inline constexpr Tag kInputType{0x0070, 0x1202};
inline constexpr Tag kInputSequencePositionIndex{0x0070, 0x1203};
inline constexpr Tag kCrop{0x0070, 0x1204};
inline constexpr Tag kCroppingIndex{0x0070, 0x1205};
inline constexpr Tag kInputNumber{0x0070, 0x1207};
inline constexpr Tag kInputSetUid{0x0070, 0x1209};
inline constexpr Tag kInputSets{0x0070, 0x120A};
inline constexpr Tag kGlobalCrop{0x0070, 0x120B};
inline constexpr Tag kGlobalCroppingIndex{0x0070, 0x120C};
inline constexpr Tag kRenderingMethod{0x0070, 0x120D};
inline constexpr Tag kVolumeCropping{0x0070, 0x1301};
inline constexpr Tag kCroppingMethod{0x0070, 0x1302};
inline constexpr Tag kBoundingBoxCrop{0x0070, 0x1303};
inline constexpr Tag kObliquePlanes{0x0070, 0x1304};
inline constexpr Tag kPlane{0x0070, 0x1305};
inline constexpr Tag kPlaneNormal{0x0070, 0x1306};
inline constexpr Tag kCroppingNumber{0x0070, 0x1309};
inline constexpr Tag kRenderProjection{0x0070, 0x1602};
inline constexpr Tag kViewpointPosition{0x0070, 0x1603};
inline constexpr Tag kViewpointLookAt{0x0070, 0x1604};
inline constexpr Tag kViewpointUp{0x0070, 0x1605};
inline constexpr Tag kRenderFieldOfView{0x0070, 0x1606};
inline constexpr Tag kSamplingStepSize{0x0070, 0x1607};
inline constexpr Tag kShadingStyle{0x0070, 0x1701};
inline constexpr Tag kAmbient{0x0070, 0x1702};
inline constexpr Tag kLightDirection{0x0070, 0x1703};
inline constexpr Tag kDiffuse{0x0070, 0x1704};
inline constexpr Tag kSpecular{0x0070, 0x1705};
inline constexpr Tag kShininess{0x0070, 0x1706};
inline constexpr Tag kClassification{0x0070, 0x1801};
inline constexpr Tag kComponentType{0x0070, 0x1802};
inline constexpr Tag kComponentInputs{0x0070, 0x1803};
inline constexpr Tag kInputIndex{0x0070, 0x1804};
inline constexpr Tag kCompositor{0x0070, 0x1805};
inline constexpr Tag kVolumetricAnnotations{0x0070, 0x1901};
inline constexpr Tag kAnimationStyle{0x0070, 0x1A01};
inline constexpr Tag kVolumeStreams{0x0070, 0x1A08};

// Macula's private block.
inline constexpr const char* kPrivateCreator = "MACULA";
inline constexpr Tag kPrivateBlock{0x0071, 0x0010};
inline constexpr Tag kOwnState{0x0071, 0x1001};  // OB, so that no character set changes it: a view as JSON
inline constexpr Tag kOwnStateDigest{0x0071, 0x1002};  // LO: digestOf the presentation as written

}  // namespace macula::dicom::presentation_tag
