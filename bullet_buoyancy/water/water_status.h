#pragma once

#include <string>

namespace bullet_buoyancy {

/// Why a water field or sea state was refused.
enum class WaterError {
    none,          ///< it was not
    notFinite,     ///< a number is NaN or infinite where it must not be
    badDepth,      ///< depth or gravity not above zero
    badComponent,  ///< a wave component with a negative amplitude or without a length
    loopedCrest,   ///< `WaterStatus::steepness` of 1 or more: the crests would fold over themselves
    badSpectrum,   ///< height, period, peakedness, spreading or number of components out of range
    badGrid,       ///< fewer than two nodes along an axis, or a spacing not above zero
    badProfile,    ///< a negative exponent of a current's profile
};

/// Why a water field was refused. A refused field is flat water at rest.
struct WaterStatus {
    WaterError error = WaterError::none;  ///< why
    double steepness = 0;                 ///< of Gerstner waves: sum of amplitude times wavenumber

    /// The field is what it was asked to be.
    bool accepted() const { return error == WaterError::none; }
    /// As `accepted`.
    explicit operator bool() const { return accepted(); }

    /// One line for people: the refusal, or "ok".
    std::string describe() const;
};

}  // namespace bullet_buoyancy
