// Debian's ITK 5.2 knows only the compiler that it was built with, and stops Clang, which clang-tidy and the
// fuzz targets are. This is what its itk_compiler_detection.h would say. Include it before any header of ITK.
#pragma once

#ifdef __clang__
#define ITK_COMPILER_DETECTION_H
#define ITK_CONSTEXPR constexpr
#define ITK_NOEXCEPT noexcept
#define ITK_DEPRECATED_MSG(message) [[deprecated(message)]]
#endif
