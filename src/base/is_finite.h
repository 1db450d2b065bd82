// Whether every component of a vector or matrix is a number: neither infinite nor NaN.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace macula {

template <glm::length_t N, class T>
bool isFinite(const glm::vec<N, T>& vector) {
    for (glm::length_t i = 0; i < N; ++i)
        if (!std::isfinite(vector[i])) return false;
    return true;
}

inline bool isFinite(const glm::dmat4& matrix) {
    return isFinite(matrix[0]) && isFinite(matrix[1]) && isFinite(matrix[2]) && isFinite(matrix[3]);
}

}  // namespace macula
