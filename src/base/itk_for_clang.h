// Debian's ITK 5.2 accepts only the compiler that it was built with and rejects Clang, which clang-tidy and
// the fuzz targets use. This header defines what ITK's itk_compiler_detection.h would. Include it before any
// ITK header.
#pragma once

#ifdef __clang__
#define ITK_COMPILER_DETECTION_H
#define ITK_CONSTEXPR constexpr
#define ITK_NOEXCEPT noexcept
#define ITK_DEPRECATED_MSG(message) [[deprecated(message)]]
#endif
